# A build with sanitizers is not made to be installed, so it leaves these tests out.
if(THAUM_SANITIZE)
    return()
endif()

# The examples and a probe, built here to compare with. install.package installs everything into a folder of its
# own, builds them again with nothing but that folder, and expects the same output. It takes the compiler that Debian's
# users have, which is not the one that builds everything here: both must come to the same bits.
add_subdirectory(${PROJECT_SOURCE_DIR}/engine/examples ${PROJECT_BINARY_DIR}/engine/examples)
add_executable(install_probe install/probe.cpp)
target_link_libraries(install_probe PRIVATE Thaum::physics Thaum::render Thaum::audio Thaum::pads thaum_flags)
find_program(usual_compiler NAMES g++ c++ REQUIRED)
add_test(NAME install.package COMMAND ${timed} ${CMAKE_CURRENT_SOURCE_DIR}/install/package.sh
    ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR} ${usual_compiler})
set_tests_properties(install.package PROPERTIES TIMEOUT ${longest_test} COST 50)
