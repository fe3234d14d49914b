thaum_test(test_input
    SOURCES unit/input_bindings_test.cpp unit/input_log_seek_test.cpp unit/input_log_end_test.cpp unit/input_log_formats_test.cpp unit/input_stick_test.cpp unit/arm_playback_test.cpp
        unit/rumble_effect_test.cpp unit/locked_sticks_test.cpp unit/pad_assignment_test.cpp unit/pad_places_test.cpp
    THREAD_SOURCES
        unit/allocations.cpp unit/arm_servo_test.cpp unit/input_collector_test.cpp unit/input_log_test.cpp
        unit/tactile_playback_test.cpp
    LINK thaum_input PkgConfig::zstd
    THREADS ArmServoTest.TwoThreads* TactilePlayerThreads.* InputCollector.TwoThreads* InputLog.FullDisk* InputLog.HashesAndMarks InputLog.NoAllocation*)
