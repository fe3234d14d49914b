# thaum_engine(core SOURCES ... LINK ...): one engine folder as one static library. Includes are written from
# engine/ ("core/error.h") and, for the game, from the top ("game/match/simulation.h").
function(thaum_engine name)
    cmake_parse_arguments(ARG "" "" "SOURCES;LINK;PRIVATE_LINK" ${ARGN})
    add_library(thaum_${name} STATIC ${ARG_SOURCES})
    target_include_directories(thaum_${name} PUBLIC ${PROJECT_SOURCE_DIR}/engine)
    target_link_libraries(thaum_${name} PUBLIC ${ARG_LINK} PRIVATE thaum_flags ${ARG_PRIVATE_LINK})
endfunction()

# thaum_quick_to_build(TARGETS...): targets that compute little themselves are compiled without optimisation
# in sanitizer builds. There, optimised code takes twice as long to compile.
function(thaum_quick_to_build)
    if(NOT THAUM_SANITIZE)
        return()
    endif()
    foreach(target ${ARGN})
        target_compile_options(${target} PRIVATE -O0)
    endforeach()
endfunction()

# thaum_start_check(PROGRAM): the program tests the processor before its first constructor runs.
function(thaum_start_check program)
    if(THAUM_PORTABLE)
        return()
    endif()
    set(check ${PROJECT_SOURCE_DIR}/game/app/start_check.cpp)
    target_sources(${program} PRIVATE ${check})
    set_source_files_properties(${check} PROPERTIES
        SKIP_UNITY_BUILD_INCLUSION ON COMPILE_OPTIONS "${THAUM_ANY_PROCESSOR}")
endfunction()
