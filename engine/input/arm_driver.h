// input/arm_driver.h: the interface of drivers for real force feedback arms. A driver is one .cpp in
// input/drivers that derives from ArmDriver and registers an ArmDriverKind. Adding a driver changes no other
// file.
//
//     class Mine : public ArmDriver { open, spec, read, write, status, close };
//     const ArmDriverRegistration mine({.name = "mine", .about = "...", .find = find_mine, .make = make_mine,
//                                       .at_hang = AtHang::write_zero});
//
// The engine (input/open_arm.h) does the rest for every driver. It runs the servo thread, unless the vendor's
// library has one. It gives up calls that hang, limits the force, and makes it zero at every end of the
// program. Its watchdog ends the force within 50 ms when ticks stop, in the way that the driver allows
// (AtHang). It reports an arm without ticks as lost, and it cleans the vendor's texts.
//
// A process that is stopped (SIGSTOP, a debugger) or killed (SIGKILL) runs no watchdog. Then the last force
// stays until the device ends it by itself. A driver turns on what its device has:
//
//     OpenHaptics (Touch, Omni, Premium)     unknown: its documents name no such limit
//     Force Dimension (omega, delta, sigma)  dhdSetWatchdog: the firmware disables forces if no new one comes
//                                            for 1 to 255 periods of 125 us, 31.9 ms at most; 0 turns it off
//     Novint Falcon by libnifalcon           unknown: it depends on the firmware that the program loads
//     Haply                                  unknown
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/registry.h"
#include "input/arm.h"

namespace thaum::input {

/// A driver's own number for a fault of its arm; 0: none.
using ArmFault = std::uint32_t;

/// How the engine's watchdog ends the force when ticks stop because the servo thread hangs in a call, or
/// because the vendor's thread stops calling.
enum class AtHang : std::uint8_t {
    /// The library accepts no call while another one hangs: only the device's own watchdog can end the force.
    keeps_force,
    /// The watchdog calls write_zero every few milliseconds; if the ticks resume, the arm works on.
    write_zero,
    give_up,  ///< the watchdog calls give_up; the arm then counts as lost
};

/// One arm, as its driver sees it.
class ArmDriver {
public:
    ArmDriver() = default;
    ArmDriver(const ArmDriver&) = delete;
    ArmDriver& operator=(const ArmDriver&) = delete;
    virtual ~ArmDriver() = default;

    // Slow calls. The engine makes them on a thread that it abandons if a call hangs, so they may block.

    /// Opens the arm and calibrates it. The error is one line: what is wrong, then what to do. After an error
    /// the arm is free again.
    virtual Expected<void> open() = 0;
    /// Facts about the open arm. Impossible numbers are treated as unknown.
    virtual ArmFacts spec() const = 0;
    /// Starts the servo thread of the vendor's library, which calls run_arm_tick(`ticks`) at 1 kHz; `ticks`
    /// is the number by which the engine finds the open arm. Returns false if there is no such thread: then
    /// the engine runs one.
    virtual Expected<bool> start(std::uint64_t ticks);
    /// Ends the force if `write_zero` could not, ends the vendor's thread, and releases the arm. Another
    /// thread may still hang in a read or write.
    virtual void close() = 0;
    /// Ends the force while another thread hangs in `close`, `read` or `write`, or the vendor's thread does
    /// not call. It must not wait for those threads. It may hang itself, and may be called again even while
    /// it hangs.
    virtual void give_up() {}

    // Calls of the servo thread, once a tick. They take no lock, allocate nothing and open no file.

    /// Measures pose and buttons, in the device frame (+x right, +y up, +z towards the user).
    /// On entry `reading.time_ns` is the start of the tick.
    virtual ArmFault read(ArmReading& reading) noexcept = 0;
    /// Gives the arm a force (N, device frame), never more than its peak force.
    virtual ArmFault write(vec3 force) noexcept = 0;
    /// Sets zero force. Called as the last call of a tick, after any fault, and in signal handlers. With
    /// AtHang::write_zero it is also called by another thread during a read or write. Returns whether the arm
    /// accepted the force.
    virtual bool write_zero() noexcept { return write(vec3(0)) == 0; }
    /// Stores the vendor's message for a fault that ended the arm's ticks. Called after zero force was
    /// written, because this call may hang.
    virtual void note(ArmFault) noexcept {}

    /// State and text for a fault that read or write returned. Any thread may call it. The engine sets
    /// `newest_ns`.
    virtual ArmStatus status(ArmFault fault) const = 0;
};

/// Runs one tick of the arm that was started with this number: reads the pose, computes the force (the servo
/// step) and writes it. Returns false if the arm needs no more ticks. A call for an arm that was closed does
/// nothing, so a vendor's library may call at any time.
bool run_arm_tick(std::uint64_t ticks) noexcept;

/// Description of a driver, which the driver's .cpp registers.
struct ArmDriverKind {
    std::string_view name;   ///< short name, such as "openhaptics"
    std::string_view about;  ///< devices and requirements, for `thaum doctor`: at most one line
    /// Arms that may be plugged in, as words that `make` understands. Opens no arm.
    std::vector<std::string> (*find)();
    std::unique_ptr<ArmDriver> (*make)(const std::string& arm);
    AtHang at_hang{};
};

/// Registers a driver when the program starts.
using ArmDriverRegistration = Registration<ArmDriverKind>;

/// All drivers, sorted by name.
inline const std::vector<ArmDriverKind>& arm_drivers() { return registry_of<ArmDriverKind>().all(); }

}  // namespace thaum::input
