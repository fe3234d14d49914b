# What `cmake --install` puts where. Component "engine": headers, static libraries and the files by which CMake
# and pkg-config find them. Component "program": thaum, thaum-tools, thaum-bench and their data.
include(CMakePackageConfigHelpers)
set(THAUM_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/Thaum)

# ---- the engine ------------------------------------------------------------------------------------------------

# render needs a window system's libraries, audio needs OpenAL and pads needs SDL, so each is a package component of its
# own.
set(libraries core ecs field physics fluid haptics tactile gesture input)
list(TRANSFORM libraries PREPEND thaum_ OUTPUT_VARIABLE targets)
# Baselines and audits are libraries of their own, whose sources are in the same folders.
list(APPEND targets thaum_fluid_classic thaum_haptics_audit thaum_gesture_trials)
install(TARGETS thaum_arithmetic ${targets} EXPORT ThaumTargets COMPONENT engine)
install(TARGETS thaum_render thaum_render_audit EXPORT ThaumRenderTargets COMPONENT engine)
install(TARGETS thaum_audio EXPORT ThaumAudioTargets COMPONENT engine)
install(TARGETS thaum_pads EXPORT ThaumPadsTargets COMPONENT engine)
foreach(exported ThaumTargets ThaumRenderTargets ThaumAudioTargets ThaumPadsTargets)
    install(EXPORT ${exported} NAMESPACE Thaum:: DESTINATION ${THAUM_PACKAGE_DIR} COMPONENT engine)
endforeach()

# Headers in detail/ are not installed, because only sources of their own folder may include them.
foreach(library ${libraries} render audio)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/engine/${library} DESTINATION ${THAUM_HEADERS} COMPONENT engine
        FILES_MATCHING PATTERN "*.h" PATTERN detail EXCLUDE)
endforeach()

configure_package_config_file(
    ${CMAKE_CURRENT_LIST_DIR}/ThaumConfig.cmake.in ${PROJECT_BINARY_DIR}/ThaumConfig.cmake
    INSTALL_DESTINATION ${THAUM_PACKAGE_DIR} NO_SET_AND_CHECK_MACRO)
# Before 1.0 every minor version may change the functions that users call.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/ThaumConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/ThaumConfig.cmake ${PROJECT_BINARY_DIR}/ThaumConfigVersion.cmake
    DESTINATION ${THAUM_PACKAGE_DIR} COMPONENT engine)

# The flags for pkg-config are those of the exported CMake targets. In a list, a library stands before the libraries
# that it needs.
list(REVERSE targets)
list(TRANSFORM targets PREPEND -l)
list(JOIN targets " " THAUM_PKG_LIBRARIES)
list(JOIN THAUM_ARITHMETIC " " THAUM_PKG_FLAGS)
# pkg-config finds the prefix relative to the file's own place, so an installation may be moved.
file(RELATIVE_PATH THAUM_PKG_TO_PREFIX
    ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
foreach(package thaum thaum-render thaum-audio thaum-pads)
    configure_file(${CMAKE_CURRENT_LIST_DIR}/${package}.pc.in ${PROJECT_BINARY_DIR}/${package}.pc @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/${package}.pc
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT engine)
endforeach()

# ---- the program -----------------------------------------------------------------------------------------------

# Folders as game::find_assets and game::scenarios_beside look for them.
set(THAUM_DATA ${CMAKE_INSTALL_DATADIR}/thaum)
install(TARGETS thaum thaum-tools COMPONENT program)
if(TARGET thaum-bench)
    install(TARGETS thaum-bench COMPONENT program)
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/assets DESTINATION ${THAUM_DATA} COMPONENT program
    PATTERN pictures EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/tests/scenarios DESTINATION ${THAUM_DATA}/assets COMPONENT program)
