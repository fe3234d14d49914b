thaum_test(test_haptics
    SOURCES
        unit/haptics_device_test.cpp unit/haptics_coupling_test.cpp
        accuracy/haptics_oscillator_test.cpp accuracy/haptics_coupling_accuracy_test.cpp
    LINK thaum_haptics)
