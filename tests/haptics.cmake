thaum_test(test_haptics
    SOURCES
        unit/haptics_device_test.cpp unit/haptics_simulated_test.cpp unit/haptics_coupling_test.cpp
        unit/haptics_safety_audit_test.cpp unit/haptics_safety_test.cpp unit/haptics_servo_test.cpp unit/haptics_servo_contact_test.cpp
        unit/haptics_energy_test.cpp unit/haptics_viscosity_test.cpp unit/haptics_surface_test.cpp unit/haptics_surface_laws_test.cpp
        unit/haptics_texture_test.cpp unit/allocations.cpp
        unit/flow_patch_test.cpp unit/fluid_touch_test.cpp
        accuracy/haptics_oscillator_test.cpp accuracy/haptics_simulated_accuracy_test.cpp
        accuracy/haptics_coupling_accuracy_test.cpp accuracy/haptics_round_accuracy_test.cpp accuracy/fluid_touch_accuracy_test.cpp
        accuracy/primitives_test.cpp accuracy/primitives_random_test.cpp
        stability/haptics_z_width_test.cpp stability/haptics_hostile_test.cpp
        stability/haptics_safety_hostile_test.cpp stability/haptics_switches_test.cpp stability/haptics_round_test.cpp
        stability/fluid_touch_hostile_test.cpp
    LINK thaum_haptics_audit thaum_fluid
    NOT_SANITIZED HapticsSwitches.TenThousand* HapticsZWidth.WithDamping* HapticsZWidth.AControllerOfMore* RoundBodies.NoProxyStays*)

thaum_test(test_haptic_modes
    SOURCES
        accuracy/haptics_drawn_body_test.cpp accuracy/haptics_modes_test.cpp accuracy/haptics_implicit_test.cpp accuracy/haptics_volume_test.cpp
        stability/haptics_modes_hostile_test.cpp stability/haptics_still_hand_test.cpp
    LINK thaum_modes)

# Tests a haptic mode that only this program has, in one .cpp.
thaum_test(test_own_mode
    SOURCES own_mode/homing.cpp own_mode/own_mode_test.cpp
    LINK thaum_modes)
