thaum_test(test_haptics
    SOURCES accuracy/primitives_test.cpp accuracy/primitives_random_test.cpp unit/haptics_allocations.cpp
    LINK thaum_haptics)
