thaum_test(test_gesture
    SOURCES unit/gesture_comparison_test.cpp unit/gesture_files_test.cpp unit/gesture_network_test.cpp unit/gesture_prefix_test.cpp
        unit/gesture_shape_test.cpp unit/gesture_spotter_test.cpp
        accuracy/gesture_accuracy_test.cpp accuracy/gesture_confusion_test.cpp stability/gesture_hostile_test.cpp
    THREAD_SOURCES
        unit/allocations.cpp unit/gesture_recogniser_test.cpp
    LINK thaum_gesture_trials
    NOT_SANITIZED GesturePublicData.*  # takes minutes, and runs the same code as shorter cases
    THREADS GestureThreads.*)
