// tests/drivers/fake_hd/fake_hd.h: functions that the make-believe libHD.so has for tests, beyond those of a
// real one. They are found by name:
//
//     auto report = reinterpret_cast<FakeHdReport (*)()>(dlsym(library, "fakeHdReport"));
//     auto of_arm = reinterpret_cast<FakeHdReport (*)(int)>(dlsym(library, "fakeHdReportOf"));  // 0 or 1
#pragma once
#include <array>
#include <cstdint>

/// Rules of the library that a program can break.
enum FakeHdRule {
    fake_hd_wrong_thread,   ///< frame opened outside the library's thread while that thread runs
    fake_hd_outside_frame,  ///< state read or force set outside a frame
    fake_hd_unpaired,       ///< nested frame, end without a beginning, or frame left open by a task
    fake_hd_wrong_units,    ///< force that is not finite, or so large that its unit must be wrong
    fake_hd_wrong_order,    ///< device released while the library's thread runs, or task without a device
    fake_hd_wrong_value,    ///< unknown name, handle or priority
    fake_hd_rules
};

struct FakeHdReport {
    std::uint64_t ticks;                              ///< ticks of the library's thread since hdInitDevice
    std::array<std::uint32_t, fake_hd_rules> broken;  ///< times each rule was broken since hdInitDevice
    std::array<double, 3> force;                      ///< force that the arm exerts now (N)
    double greatest_force;                            ///< largest force of any tick (N)
    std::array<double, 3> position;                   ///< position of the tip (m)
    std::uint64_t calls_after_end;   ///< calls of tasks after the device was disabled (callback=after_end)
    std::array<double, 3> left;      ///< force at hdDisableDevice (N): a real arm may go on exerting it
    std::uint64_t stops_with_force;  ///< calls of hdStopScheduler that left an arm with a force
    std::uint64_t stops;             ///< calls of hdStopScheduler
};

/// Layout of the file named by the script's word `live`. The file remains when the program dies.
struct FakeHdLive {
    std::array<double, 3> force;  ///< force that the arm exerts now, and continues to exert (N)
    double greatest_force;        ///< largest force of any tick (N)
    std::uint64_t ticks;          ///< ticks of the library's thread
    std::uint64_t initiated;      ///< 1 while a program holds the device
    std::array<double, 3> left;   ///< force at hdDisableDevice (N)
};
