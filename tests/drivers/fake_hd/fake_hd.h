// tests/drivers/fake_hd/fake_hd.h: functions that the make-believe libHD.so has for tests, beyond those of a
// real one. They are found by name:
//
//     auto report = reinterpret_cast<FakeHdReport (*)()>(dlsym(library, "fakeHdReport"));
//     auto of_arm = reinterpret_cast<FakeHdReport (*)(int)>(dlsym(library, "fakeHdReportOf"));  // 0 or 1
#pragma once
#include <array>
#include <cstdint>

/// Rules that a program may break.
enum FakeHdRule {
    fake_hd_wrong_thread,   ///< a frame outside the library's thread while that runs
    fake_hd_outside_frame,  ///< state asked for or a force set outside a frame
    fake_hd_unpaired,       ///< a frame in a frame, an end without a beginning, a frame left open by a task
    fake_hd_wrong_units,    ///< a force that is no number or that only another unit explains
    fake_hd_wrong_order,    ///< a device let go of while the library's thread runs, a task for no device
    fake_hd_wrong_value,    ///< a name, handle or priority that there is not
    fake_hd_rules
};

struct FakeHdReport {
    std::uint64_t ticks;                              ///< of the library's thread since the last hdInitDevice
    std::array<std::uint32_t, fake_hd_rules> broken;  ///< times, since the last hdInitDevice
    std::array<double, 3> force;                      ///< N, that the arm exerts now
    double greatest_force;                            ///< N, of any tick
    std::array<double, 3> position;                   ///< m, where the tip is
    std::uint64_t calls_after_end;   ///< of tasks, after the device was disabled (callback=after_end)
    std::array<double, 3> left;      ///< force at hdDisableDevice (N): a real arm may go on exerting it
    std::uint64_t stops_with_force;  ///< calls of hdStopScheduler that left an arm with a force
    std::uint64_t stops;             ///< calls of hdStopScheduler
};

/// The file of the word `live`, which stays behind when the program dies.
struct FakeHdLive {
    std::array<double, 3> force;  ///< N, that the arm exerts now and goes on exerting
    double greatest_force;        ///< N, of any tick
    std::uint64_t ticks;          ///< of the library's thread
    std::uint64_t initiated;      ///< 1: a program has the device
    std::array<double, 3> left;   ///< force at hdDisableDevice (N)
};
