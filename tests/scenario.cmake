# Every scenario is a test of its own, run by the program itself. Sanitizer builds run each scenario once, and
# leave out long ones: more would show them no other code.
set(scenario_program $<TARGET_FILE:thaum-tools> scenario --out ${CMAKE_CURRENT_BINARY_DIR}/scenarios)
# Ten minutes of a match: only `./thaum test --long` runs it.
set(long_scenarios no_cast_while_fighting)
set(slow_scenarios "")
if(THAUM_SANITIZE)
    list(APPEND scenario_program --once)
    set(slow_scenarios bots_fight_to_a_kill brew_is_stirrable light_brew_lifts mix_red_green_to_yellow rest_costs_nothing
        same_on_1_and_2_threads seek_equals_play standard_best_of_three stir_against_flow_resists stir_makes_swirl_and_swirl_carries_hand thick_brew_slows_both)
endif()
if(THAUM_SANITIZE STREQUAL thread)
    # The one scenario with threads does not need the rest of thaum-tools, which takes a fifth of the time of this build.
    add_executable(scenario_probe drivers/scenario_probe.cpp)
    target_link_libraries(scenario_probe PRIVATE thaum_flags thaum_scenario)
    thread_program(scenario_probe)
    set(scenario_program $<TARGET_FILE:scenario_probe>)
endif()
file(GLOB scenarios CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/scenarios/*.lua)
foreach(script ${scenarios})
    get_filename_component(name ${script} NAME_WE)
    add_test(NAME scenario.${name}
        COMMAND ${timed} ${scenario_program} ${script})
    if(name IN_LIST long_scenarios)
        set_tests_properties(scenario.${name} PROPERTIES TIMEOUT ${longest_test} COST 50 LABELS "scenario;long")
    elseif(name IN_LIST slow_scenarios)
        set_tests_properties(scenario.${name} PROPERTIES TIMEOUT ${longest_test} LABELS "scenario;slow")
    else()
        set_tests_properties(scenario.${name} PROPERTIES TIMEOUT ${longest_test} LABELS scenario FIXTURES_SETUP scenarios)
    endif()
endforeach()

# A second thread plays the match of this scenario, so the thread sanitizer runs it, too.
set_tests_properties(scenario.late_frames_same_result PROPERTIES
    LABELS "scenario;threads" ENVIRONMENT "${sanitizer_environment}")

# Sums the tables of forces that the scenarios write: the energy that passive sources created.
add_executable(passivity drivers/passivity.cpp)
target_include_directories(passivity PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(passivity PRIVATE thaum_flags thaum_core)
if(NOT THAUM_SANITIZE)  # sanitizers' builds leave out most scenarios
    add_test(NAME haptics.passivity COMMAND ${timed} $<TARGET_FILE:passivity> ${CMAKE_CURRENT_BINARY_DIR}/scenarios 0.02)
    set_tests_properties(haptics.passivity PROPERTIES FIXTURES_REQUIRED scenarios)
endif()

# The force traces of the scenarios (replays/forces) are exact within one rules version. After a change of
# rules, data or haptic scenarios run THAUM_KEEP_FORCES=tests/replays/forces ./thaum scenario, and say in the
# commit why the traces changed.

# Every log in the folder is a test. Its name NAME_rules_VERSION.thaumlog has the rules version that recorded
# it. Logs of this version must give the same bits, in this build too. Logs of older versions must be rejected
# with a clear message. After a change of rules or data run thaum --headless --seed 30 --seconds 30 --record
# tests/replays/bots_rules_N.thaumlog, and say in the commit why it changed. Logs of older versions stay.
# bots_format_1_rules_17 is the same match as bots_rules_17 in format 1 of the log, which programs of later rules do
# not write (engine/input/FORMAT.md).
file(STRINGS ${PROJECT_SOURCE_DIR}/game/match/simulation.h rules_line REGEX "rules_version = [0-9]+;")
string(REGEX MATCH "rules_version = ([0-9]+)" rules_line "${rules_line}")
set(rules_version ${CMAKE_MATCH_1})
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/game/match/simulation.h)
file(GLOB replays CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/replays/*.thaumlog)
foreach(log ${replays})
    get_filename_component(name ${log} NAME_WE)
    string(REGEX MATCH "[0-9]+$" version ${name})
    add_test(NAME replay.${name} COMMAND ${timed} $<TARGET_FILE:thaum-tools> replay ${log} --verify)
    if(version EQUAL rules_version)
        if(NOT THAUM_SANITIZE)
            # Makes the C library use its functions for processors without AVX2 and FMA.
            add_test(NAME replay.${name}.older_libm COMMAND ${timed} $<TARGET_FILE:thaum-tools> replay ${log} --verify)
            set_tests_properties(replay.${name}.older_libm PROPERTIES
                ENVIRONMENT GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4)
        endif()
    else()
        set_tests_properties(replay.${name} PROPERTIES PASS_REGULAR_EXPRESSION
            "recorded under rules version ${version}, this program plays version ${rules_version}")
    endif()
endforeach()

if(NOT THAUM_SANITIZE)
    # This match diverged after 140 s when Bullet called the C library's functions.
    set(long_duel ${CMAKE_CURRENT_BINARY_DIR}/long_duel)
    # A log is never overwritten, so the log of the last run is deleted first.
    add_test(NAME replay.long_duel.clear COMMAND ${CMAKE_COMMAND} -E rm -f ${long_duel}.thaumlog)
    add_test(NAME replay.long_duel.record
        COMMAND ${timed} $<TARGET_FILE:thaum> --headless --seconds 150 --bots 3,3 --seed 7 --match standard --record ${long_duel}.thaumlog
            --out ${long_duel})
    add_test(NAME replay.long_duel.older_libm COMMAND ${timed} $<TARGET_FILE:thaum-tools> replay ${long_duel}.thaumlog --verify)
    set_tests_properties(replay.long_duel.clear PROPERTIES FIXTURES_SETUP no_long_duel LABELS long)
    set_tests_properties(replay.long_duel.record PROPERTIES
        FIXTURES_REQUIRED no_long_duel FIXTURES_SETUP long_duel LABELS long TIMEOUT ${longest_test})
    set_tests_properties(replay.long_duel.older_libm PROPERTIES FIXTURES_REQUIRED long_duel LABELS long TIMEOUT ${longest_test}
        ENVIRONMENT GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4)

    # Tests that an ordinary build on an older processor prints one line and executes no illegal instruction.
    # Each processor lacks at least the feature named first. A portable build starts on all of them but the
    # one without bmi1, which no maker sells: there even the C library's own functions for AVX2 cannot run.
    find_program(qemu qemu-x86_64)
    if(qemu)
        foreach(processor avx:Nehalem avx2:Haswell,-avx2 movbe:Haswell,-movbe abm:Haswell,-abm bmi1:Haswell,-bmi1
                bmi2:Haswell,-bmi2 f16c:Haswell,-f16c)
            string(REPLACE ":" ";" processor "${processor}")
            list(GET processor 0 feature)
            list(GET processor 1 model)
            if(THAUM_PORTABLE AND feature STREQUAL bmi1)
                continue()
            endif()
            add_test(NAME start.without_${feature} COMMAND ${timed} ${qemu} -cpu ${model} $<TARGET_FILE:thaum> --version)
            if(NOT THAUM_PORTABLE)
                set_tests_properties(start.without_${feature} PROPERTIES PASS_REGULAR_EXPRESSION
                    "this one lacks[a-z0-9_ ]* ${feature}[ ;]")
            endif()
        endforeach()
        add_test(NAME start.without_fma COMMAND ${timed} ${qemu} -cpu Haswell,-fma $<TARGET_FILE:thaum> --version)
    endif()
endif()

thaum_test(test_scenario
    SOURCES unit/scenario_sandbox_test.cpp unit/scenario_runner_test.cpp
    LINK thaum_scenario PkgConfig::lua nlohmann_json::nlohmann_json)
thaum_test(test_orb_follow
    SOURCES stability/orb_follow_test.cpp
    LINK thaum_scenario
    NOT_SANITIZED OrbFollow.*
    LONG OrbFollow.*)
