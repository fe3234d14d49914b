thaum_test(test_physics
    SOURCES
        unit/physics_test.cpp unit/physics_repeat_test.cpp unit/physics_mover_test.cpp unit/physics_memory_test.cpp
        unit/physics_nearby_test.cpp unit/physics_maths_test.cpp
        accuracy/physics_accuracy_test.cpp accuracy/physics_contact_test.cpp stability/physics_stability_test.cpp
    LINK thaum_physics PkgConfig::bullet ${CMAKE_DL_LIBS}
    NOT_SANITIZED PhysicsRepeat.AWorldRestored* PhysicsNearby.AMeshGives* PhysicsRepeat.SkippingSleepers*)
