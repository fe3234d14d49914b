// tests/drivers/fake_hd/fake_hd.h: reports of the fake libHD.so to tests, beyond the functions of a real
// one. Tests find the function by name:
//
//     auto report = reinterpret_cast<FakeHdReport (*)()>(dlsym(library, "fakeHdReport"));
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
    std::uint64_t ticks;  ///< ticks of the library's thread since the last hdInitDevice
    std::array<std::uint32_t, fake_hd_rules> broken;  ///< violations of each rule since the last hdInitDevice
    std::array<double, 3> force;                      ///< force that the arm exerts now (N)
    double greatest_force;                            ///< largest force of any tick (N)
    std::array<double, 3> position;                   ///< position of the arm's tip (m)
    std::uint64_t calls_after_end;  ///< calls of tasks after the device was disabled (callback=after_end)
    std::array<double, 3> left;     ///< force at hdDisableDevice (N): a real arm may go on exerting it
};

/// Layout of the file named by the script's word `live`. The file remains when the program dies.
struct FakeHdLive {
    std::array<double, 3> force;  ///< force that the arm exerts now, and continues to exert (N)
    double greatest_force;        ///< largest force of any tick (N)
    std::uint64_t ticks;          ///< ticks of the library's thread
    std::uint64_t initiated;      ///< 1 while a program holds the device
    std::array<double, 3> left;   ///< force at hdDisableDevice (N)
};
