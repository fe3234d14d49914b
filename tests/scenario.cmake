# Every scenario is a test of its own; the program that runs them has no picture, so those that look at pixels are skipped here.
add_executable(run_scenario unit/scenario_main.cpp)
target_compile_definitions(run_scenario PRIVATE THAUM_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
target_link_libraries(run_scenario PRIVATE thaum_flags thaum_scenario)
file(GLOB scenarios CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/scenarios/*.lua)
foreach(script ${scenarios})
    get_filename_component(name ${script} NAME_WE)
    add_test(NAME scenario.${name} COMMAND run_scenario ${script} ${CMAKE_CURRENT_BINARY_DIR}/scenarios)
    set_tests_properties(scenario.${name} PROPERTIES TIMEOUT 300 SKIP_RETURN_CODE 77)
endforeach()

thaum_test(test_scenario
    SOURCES unit/scenario_sandbox_test.cpp unit/scenario_runner_test.cpp fuzz/scenario_fuzz_test.cpp
    LINK thaum_scenario PkgConfig::lua nlohmann_json::nlohmann_json)
