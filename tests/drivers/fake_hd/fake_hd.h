// tests/drivers/fake_hd/fake_hd.h: functions that the fake libHD.so offers to tests, beyond those of the real
// library. A test looks them up by name:
//
//     auto report = reinterpret_cast<FakeHdReport (*)()>(dlsym(library, "fakeHdReport"));
//     auto of_arm = reinterpret_cast<FakeHdReport (*)(int)>(dlsym(library, "fakeHdReportOf"));  // 0 or 1
#pragma once
#include <array>
#include <cstdint>

/// Rules of the library that a program can break.
enum FakeHdRule {
    fake_hd_wrong_thread,   ///< frame opened in another thread while the library's thread runs
    fake_hd_outside_frame,  ///< state read or force set outside a frame
    fake_hd_unpaired,       ///< nested frame, end without a beginning, or frame left open by a task
    fake_hd_wrong_units,    ///< force that is not finite, or so large that it must be in a wrong unit
    fake_hd_wrong_order,    ///< device released while the library's thread runs, or task without a device
    fake_hd_wrong_value,    ///< unknown name, handle or priority passed to a function
    fake_hd_rules
};

struct FakeHdReport {
    std::uint64_t ticks;  ///< ticks of the library's thread since hdInitDevice
    /// Number of violations of each rule since hdInitDevice.
    std::array<std::uint32_t, fake_hd_rules> broken;
    std::array<double, 3> force;     ///< force that the arm exerts now (N)
    double max_force;                ///< largest force of any tick so far (N)
    std::array<double, 3> position;  ///< position of the tip (m)
    /// Number of calls of tasks after the device was disabled (callback=after_end)
    std::uint64_t calls_after_end;
    std::array<double, 3> left;      ///< force at hdDisableDevice (N), which a real arm may continue to exert
    std::uint64_t stops_with_force;  ///< number of calls of hdStopScheduler that left an arm with a force
    std::uint64_t stops;             ///< number of calls of hdStopScheduler
};

/// Layout of the file that the script's option `live` names. The file remains when the program dies.
struct FakeHdLive {
    std::array<double, 3> force;  ///< force that the arm exerts now, and continues to exert (N)
    double max_force;             ///< largest force of any tick so far (N)
    std::uint64_t ticks;          ///< number of ticks of the library's thread
    std::uint64_t initiated;      ///< 1 while a program holds the device
    std::array<double, 3> left;   ///< force at hdDisableDevice (N)
};
