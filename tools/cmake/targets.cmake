# thaum_engine(core SOURCES ... LINK ...): one engine folder as one static library, thaum_core here and
# Thaum::core for its users. Includes are written from engine/ ("core/error.h") and, for the game, from the top
# ("game/match/simulation.h").
function(thaum_engine name)
    cmake_parse_arguments(ARG "" "" "SOURCES;LINK;PRIVATE_LINK" ${ARGN})
    add_library(thaum_${name} STATIC ${ARG_SOURCES})
    add_library(Thaum::${name} ALIAS thaum_${name})
    set_target_properties(thaum_${name} PROPERTIES EXPORT_NAME ${name})
    target_include_directories(thaum_${name} PUBLIC
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/engine> $<INSTALL_INTERFACE:${THAUM_HEADERS}>)
    target_link_libraries(thaum_${name}
        PUBLIC thaum_arithmetic ${ARG_LINK}
        PRIVATE $<BUILD_INTERFACE:thaum_flags> ${ARG_PRIVATE_LINK})
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
