thaum_test(test_tactile
    SOURCES
        unit/tact_test.cpp unit/tact_writer.cpp unit/tactile_files_test.cpp unit/tactile_mixer_test.cpp unit/tactile_patterns_test.cpp
        accuracy/tactile_grating_test.cpp accuracy/tactile_phantom_test.cpp stability/tactile_hostile_test.cpp
    LINK thaum_tactile nlohmann_json::nlohmann_json)
