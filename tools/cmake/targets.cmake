# thaum_engine(core SOURCES ... LINK ...): one engine folder as one static library, thaum_core here and
# Thaum::core for its users. Includes are written from engine/ ("core/error.h") and, for the game, from the top
# ("game/match/simulation.h"). HOT: it is not watched for overruns, see flags.cmake.
function(thaum_engine name)
    cmake_parse_arguments(ARG "HOT" "" "SOURCES;LINK;PRIVATE_LINK" ${ARGN})
    add_library(thaum_${name} STATIC ${ARG_SOURCES})
    add_library(Thaum::${name} ALIAS thaum_${name})
    set_target_properties(thaum_${name} PROPERTIES EXPORT_NAME ${name})
    thaum_hot(thaum_${name} ${ARG_HOT})
    target_include_directories(thaum_${name} PUBLIC
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/engine> $<INSTALL_INTERFACE:${THAUM_HEADERS}>)
    target_link_libraries(thaum_${name}
        PUBLIC thaum_arithmetic ${ARG_LINK}
        PRIVATE $<BUILD_INTERFACE:thaum_flags> ${ARG_PRIVATE_LINK})
    thaum_headers_of(engine thaum_${name})
    set_property(GLOBAL APPEND PROPERTY THAUM_FOLDERS ${name})
endfunction()

# thaum_links_alone(): links the whole of each folder's library, engine's and game's, against the libraries that it names,
# and nothing else. So a folder that uses what it does not name stops the build.
function(thaum_links_alone)
    get_property(folders GLOBAL PROPERTY THAUM_FOLDERS)
    file(WRITE ${PROJECT_BINARY_DIR}/links_alone.cpp "int main() {}\n")
    foreach(name ${folders})
        add_executable(${name}_links_alone ${PROJECT_BINARY_DIR}/links_alone.cpp)
        target_link_libraries(${name}_links_alone PRIVATE "$<LINK_LIBRARY:WHOLE_ARCHIVE,thaum_${name}>" thaum_flags)
        target_link_options(${name}_links_alone PRIVATE -Wl,--strip-all)
        set_target_properties(${name}_links_alone PROPERTIES
            RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/links_alone UNITY_BUILD OFF DISABLE_PRECOMPILE_HEADERS ON)
    endforeach()
endfunction()

# thaum_hot(TARGET ON|OFF): whether the target computes numbers alone. Our own builds optimise it fully, also where the rest
# is optimised less, as in what GCC makes for the tests.
function(thaum_hot target hot)
    set_target_properties(${target} PROPERTIES THAUM_HOT ${hot})
    if(hot AND THAUM_HARDENED)
        target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O3>)
    endif()
endfunction()

# thaum_cold(TARGETS...): targets in which no time is spent at run time, such as menus, commands and words.
# Little optimisation halves the time in which they compile. Under sanitizers they are not optimised at all.
function(thaum_cold)
    foreach(target ${ARGN})
        if(THAUM_SANITIZE)
            thaum_unoptimised(${target})
        else()
            target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
        endif()
    endforeach()
endfunction()

# thaum_unoptimised(TARGETS...): targets that take longer to optimise than to run, such as tests.
function(thaum_unoptimised)
    foreach(target ${ARGN})
        target_compile_options(${target} PRIVATE -O0)
        set_target_properties(${target} PROPERTIES THAUM_UNOPTIMISED ON)
    endforeach()
endfunction()

# thaum_headers_of(SET TARGETS...): compiles the targets with the precompiled header tools/cmake/precompiled/SET.h. Sources
# include all that they use themselves, so they compile without it, too. Call thaum_cold or thaum_unoptimised before.
function(thaum_headers_of set)
    if(CMAKE_DISABLE_PRECOMPILE_HEADERS)
        return()
    endif()
    foreach(target ${ARGN})
        set(headers thaum_headers_${set})
        # Precompiled headers for code without optimisation (-O0) and with it differ; all other levels share
        # one.
        get_target_property(unoptimised ${target} THAUM_UNOPTIMISED)
        if(unoptimised)
            string(APPEND headers _unoptimised)
        endif()
        # Precompiled headers also differ between code with and without protections against overruns.
        get_target_property(hot ${target} THAUM_HOT)
        if(hot AND THAUM_HARDENED)
            string(APPEND headers _hot)
        endif()
        if(NOT TARGET ${headers})
            add_library(${headers} OBJECT ${PROJECT_SOURCE_DIR}/tools/cmake/precompiled/empty.cpp)
            target_include_directories(${headers} PRIVATE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/engine)
            target_link_libraries(${headers} PRIVATE thaum_arithmetic thaum_flags)
            if(set MATCHES _tests$)
                target_link_libraries(${headers} PRIVATE GTest::gtest)
            endif()
            if(unoptimised)
                thaum_unoptimised(${headers})
            endif()
            thaum_hot(${headers} ${hot})
            target_precompile_headers(${headers} PRIVATE ${PROJECT_SOURCE_DIR}/tools/cmake/precompiled/${set}.h)
        endif()
        target_precompile_headers(${target} REUSE_FROM ${headers})
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
        SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON COMPILE_OPTIONS "${THAUM_ANY_PROCESSOR}")
endfunction()
