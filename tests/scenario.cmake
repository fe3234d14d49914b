# Every scenario is a test of its own, run by the program as anybody would.
file(GLOB scenarios CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/scenarios/*.lua)
foreach(script ${scenarios})
    get_filename_component(name ${script} NAME_WE)
    add_test(NAME scenario.${name}
        COMMAND thaum scenario ${script} --out ${CMAKE_CURRENT_BINARY_DIR}/scenarios)
    set_tests_properties(scenario.${name} PROPERTIES TIMEOUT 300 LABELS scenario)
endforeach()

# Every log in the folder is a test: it must still come to the same bits, in this build too. After a change of rules or
# data: thaum --headless --seed 2 --seconds 30 --record tests/replays/bots_rules_N.thaumlog, and say why it changed.
file(GLOB replays CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/replays/*.thaumlog)
foreach(log ${replays})
    get_filename_component(name ${log} NAME_WE)
    add_test(NAME replay.${name} COMMAND thaum replay ${log} --verify)
    # A machine whose mathematical library computes other bits cannot tell whether we do.
    set_tests_properties(replay.${name} PROPERTIES SKIP_REGULAR_EXPRESSION "mathematical library")
endforeach()

thaum_test(test_scenario
    SOURCES unit/scenario_sandbox_test.cpp unit/scenario_runner_test.cpp fuzz/scenario_fuzz_test.cpp
    LINK thaum_scenario PkgConfig::lua nlohmann_json::nlohmann_json)
