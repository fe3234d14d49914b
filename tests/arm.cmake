# Real arms without one: a libHD.so of our own, with a simulated arm behind it. It is loaded as the vendor's would be, so it must
# bring along what it needs and show no more than its functions. The second one lacks a function, as an old version does.
foreach(name fake_hd fake_hd_old)
    add_library(${name} SHARED
        drivers/fake_hd/fake_hd.cpp
        ${PROJECT_SOURCE_DIR}/engine/core/assert.cpp
        ${PROJECT_SOURCE_DIR}/engine/core/maths.cpp
        ${PROJECT_SOURCE_DIR}/engine/haptics/oscillator.cpp
        ${PROJECT_SOURCE_DIR}/engine/haptics/simulated.cpp)
    set_target_properties(${name} PROPERTIES CXX_VISIBILITY_PRESET hidden)
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/engine ${CMAKE_CURRENT_SOURCE_DIR})
    target_link_libraries(${name} PRIVATE thaum_flags Threads::Threads)
endforeach()
target_compile_definitions(fake_hd_old PRIVATE FAKE_HD_OLD)

thaum_test(test_arm
    SOURCES unit/arm_test.cpp unit/openhaptics_test.cpp
    LINK thaum_input ${CMAKE_DL_LIBS})
target_compile_definitions(test_arm PRIVATE
    FAKE_HD="$<TARGET_FILE:fake_hd>" FAKE_HD_OLD="$<TARGET_FILE:fake_hd_old>")
add_dependencies(test_arm fake_hd fake_hd_old)
