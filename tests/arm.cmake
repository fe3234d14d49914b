# Tests of real arms without an arm: our own libHD.so, which simulates an arm. Programs load it like the
# maker's libHD.so, so it must contain all code that it needs, and export only the functions of libHD.
# fake_hd_old lacks a function that old versions of the maker's library lack.
foreach(name fake_hd fake_hd_old)
    add_library(${name} SHARED
        drivers/fake_hd/calls.cpp drivers/fake_hd/library.cpp drivers/fake_hd/misbehaviour.cpp
        drivers/fake_hd/scheduler.cpp drivers/fake_hd/script.cpp
        ${PROJECT_SOURCE_DIR}/engine/core/assert.cpp
        ${PROJECT_SOURCE_DIR}/engine/core/maths.cpp
        ${PROJECT_SOURCE_DIR}/engine/core/powers.cpp
        ${PROJECT_SOURCE_DIR}/engine/haptics/oscillator.cpp
        ${PROJECT_SOURCE_DIR}/engine/haptics/simulated.cpp)
    set_target_properties(${name} PROPERTIES CXX_VISIBILITY_PRESET hidden)
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/engine ${CMAKE_CURRENT_SOURCE_DIR})
    target_link_libraries(${name} PRIVATE thaum_flags Threads::Threads)
endforeach()
target_compile_definitions(fake_hd_old PRIVATE FAKE_HD_OLD)

# Holds a force on a faulty arm. It is a process of its own, since it may hang or die.
add_executable(arm_probe drivers/arm_probe.cpp)
target_include_directories(arm_probe PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(arm_probe PRIVATE thaum_flags thaum_arms ${CMAKE_DL_LIBS})

# A driver that only test programs have (drivers/fake_arm). An object library, so that the linker keeps its registration.
add_library(fake_arm OBJECT drivers/fake_arm/fake_arm.cpp drivers/fake_hd/script.cpp)
target_include_directories(fake_arm PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(fake_arm PRIVATE thaum_flags thaum_input)

thaum_test(test_arm
    SOURCES unit/arm_driver_test.cpp unit/arm_modes_test.cpp unit/arm_test.cpp unit/openhaptics_test.cpp
    LINK thaum_arms fake_arm ${CMAKE_DL_LIBS}
    NOT_SANITIZED ArmEnds.*  # sanitizers end a faulty program in their own way
    THREADS ArmDrivers.* OpenHaptics.*)
target_compile_definitions(test_arm PRIVATE
    ARM_PROBE="$<TARGET_FILE:arm_probe>" FAKE_HD="$<TARGET_FILE:fake_hd>" FAKE_HD_OLD="$<TARGET_FILE:fake_hd_old>")
add_dependencies(test_arm arm_probe fake_hd fake_hd_old)
