thaum_test(test_core
    SOURCES accuracy/maths.cpp unit/core_bytes.cpp unit/core_config.cpp unit/core_file_watch.cpp unit/core_gzip.cpp
            unit/core_json.cpp unit/core_memory.cpp unit/core_registry.cpp unit/core_table.cpp unit/core_values.cpp
    THREAD_SOURCES
        unit/core_file.cpp unit/core_jobs.cpp unit/core_queues.cpp unit/core_team.cpp
    LINK thaum_core nlohmann_json::nlohmann_json
    NOT_SANITIZED CoreMemoryDeathTest.*  # sanitizers replace the allocator
    THREADS Threads.* *JobsByThreads.* CoreJobs.* CoreTeam.* CoreFile.AReaderNever* SpscQueue.* TripleBuffer.*)

if(NOT THAUM_SANITIZE)
    # Rules of the source tree: dependencies between folders, no paths of one machine, no test left out of the
    # build, no long file. clang-tidy finds long functions.
    thaum_test(test_structure
        SOURCES structure/rules.cpp structure/check_rules.cpp structure/check_tree.cpp)
    thaum_links_alone()

    # Tests the launcher with missing packages, in moved, copied, read-only and other users' trees, and in odd
    # surroundings: a copy of the launcher runs with stand-ins for apt-get and the other tools. It takes 6 s
    # of a processor.
    add_test(NAME structure.launcher COMMAND ${timed} ${CMAKE_CURRENT_SOURCE_DIR}/structure/launcher.sh ${PROJECT_SOURCE_DIR})
    set_tests_properties(structure.launcher PROPERTIES TIMEOUT ${longest_test})

    # Tests that programs are built with protections against buffer overruns, and that they name neither the
    # source folder nor the build folder. It reads three files and takes half a second.
    if(THAUM_HARDENED AND CMAKE_BUILD_TYPE STREQUAL Release)
        add_test(NAME structure.hardened COMMAND ${timed} ${CMAKE_CURRENT_SOURCE_DIR}/structure/hardened.sh
            ${PROJECT_SOURCE_DIR}:${PROJECT_BINARY_DIR}
            $<TARGET_FILE:thaum> $<TARGET_FILE:thaum-tools> $<TARGET_FILE:thaum-bench>)
        set_tests_properties(structure.hardened PROPERTIES TIMEOUT ${longest_test})
    endif()

    # Every type and function of the engine's public headers has a doc comment (8 s of a processor).
    add_test(NAME structure.api_pages COMMAND ${timed} ${PROJECT_SOURCE_DIR}/tools/api.sh ${PROJECT_BINARY_DIR}/api)
    set_tests_properties(structure.api_pages PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT ${longest_test})

    # Components with padding are refused by both compilers.
    add_test(NAME structure.padding COMMAND ${timed} ${CMAKE_CURRENT_SOURCE_DIR}/structure/padding.sh ${PROJECT_SOURCE_DIR}/engine
        ${CMAKE_CURRENT_SOURCE_DIR}/structure/padding.cpp)
    set_tests_properties(structure.padding PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT ${longest_test})
endif()

# A race that the thread sanitizer must report.
if(THAUM_SANITIZE STREQUAL thread)
    add_executable(race drivers/race.cpp)
    target_link_libraries(race PRIVATE thaum_flags Threads::Threads)
    thread_program(race)
    add_test(NAME threads.race_is_reported COMMAND ${timed} $<TARGET_FILE:race>)
    set_tests_properties(threads.race_is_reported PROPERTIES
        LABELS threads ENVIRONMENT "${sanitizer_environment}" PASS_REGULAR_EXPRESSION "WARNING: ThreadSanitizer: data race")
endif()
