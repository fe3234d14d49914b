thaum_test(test_core
    SOURCES accuracy/maths.cpp unit/core_bytes.cpp unit/core_config.cpp unit/core_file.cpp unit/core_file_watch.cpp unit/core_jobs.cpp
            unit/core_memory.cpp unit/core_values.cpp
    LINK thaum_core
    NOT_SANITIZED CoreMemoryDeathTest.*)  # sanitizers replace the allocator

# Rules of the source tree: dependencies between folders, no paths of one machine, no test left out of the
# build.
thaum_test(test_structure
    SOURCES structure/rules.cpp structure/check_rules.cpp structure/check_tree.cpp
    NOT_SANITIZED *)

# The launcher with missing packages: a copy of it runs with stand-ins for apt-get and the other tools.
if(NOT THAUM_SANITIZE)
    add_test(NAME structure.launcher COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/structure/launcher.sh ${PROJECT_SOURCE_DIR})
    set_tests_properties(structure.launcher PROPERTIES TIMEOUT ${longest_test})
endif()

# Components with padding are refused by both compilers.
if(NOT THAUM_SANITIZE)
    add_test(NAME structure.padding COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/structure/padding.sh ${PROJECT_SOURCE_DIR}/engine
        ${CMAKE_CURRENT_SOURCE_DIR}/structure/padding.cpp)
    set_tests_properties(structure.padding PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT ${longest_test})
endif()
