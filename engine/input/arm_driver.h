// input/arm_driver.h: the interface of drivers for real force feedback arms. A driver is one .cpp in
// input/drivers that derives from ArmDriver and registers an ArmDriverKind. Adding a driver changes no other
// file.
//
//     class Mine : public ArmDriver { open, spec, read, write, status, close };
//     const ArmDriverRegistration mine({.name = "mine", .about = "...", .find = find_mine, .make = make_mine});
//
// The engine (input/open_arm.h) does the rest for every driver. It runs the servo thread, unless the vendor's
// library has one. It gives up calls that hang, limits the force, and makes it zero at every end of the
// program. It reports an arm without ticks as lost, and it cleans the vendor's texts.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "input/arm.h"

namespace thaum::input {

/// A driver's own number for a fault of its arm; 0: none.
using ArmFault = std::uint32_t;

/// One arm, as its driver sees it.
class ArmDriver {
public:
    ArmDriver() = default;
    ArmDriver(const ArmDriver&) = delete;
    ArmDriver& operator=(const ArmDriver&) = delete;
    virtual ~ArmDriver() = default;

    // Slow calls. The engine makes them on a thread that it leaves behind if a call hangs, so they may block.

    /// Takes the arm and calibrates it. The error is one line: what is wrong, then what to do. After an error the arm
    /// is free again.
    virtual Expected<void> open() = 0;
    /// Facts about the open arm. Numbers beyond belief count as unknown.
    virtual ArmFacts spec() const = 0;
    /// Starts the servo thread of the vendor's library, which calls run_arm_tick(`ticks`) at 1 kHz. Returns false if
    /// there is no such thread: then the engine runs one.
    virtual Expected<bool> start(std::uint64_t ticks);
    /// Ends the force if `write_zero` could not, ends the vendor's thread, and frees the arm. A read or write may still
    /// hang in another thread.
    virtual void close() = 0;
    /// Ends the force while `close` hangs in another thread.
    virtual void give_up() {}

    // Calls of the servo thread, once a tick. They take no lock, allocate nothing and open no file.

    /// Measures pose and buttons, in the device frame (+x right, +y up, +z towards the user).
    /// On entry `reading.time_ns` is the start of the tick.
    virtual ArmFault read(ArmReading& reading) noexcept = 0;
    /// Gives the arm a force (N, device frame), never more than its peak force.
    virtual ArmFault write(vec3 force) noexcept = 0;
    /// Gives the arm zero force as the last call of a tick, after any fault, also in a signal handler. Returns whether
    /// the arm took it.
    virtual bool write_zero() noexcept { return write(vec3(0)) == 0; }
    /// Keeps the vendor's words for a fault, after the last zero force. It may hang.
    virtual void note(ArmFault) noexcept {}

    /// State and text that a fault of read or write means. Any thread. `newest_ns` is the engine's.
    virtual ArmStatus status(ArmFault fault) const = 0;
};

/// Runs one tick of the arm that was started with this number: read, servo step, write. Returns false if the
/// arm takes no more ticks. A call for an arm that was closed does nothing, so a vendor's library may call at
/// any time.
bool run_arm_tick(std::uint64_t ticks) noexcept;

/// A driver, as its .cpp registers it.
struct ArmDriverKind {
    std::string_view name;   ///< short name, such as "openhaptics"
    std::string_view about;  ///< devices and requirements, for `thaum doctor`: at most one line
    /// Arms that may be plugged in, by words that `make` understands. Finding them opens none.
    std::vector<std::string> (*find)();
    std::unique_ptr<ArmDriver> (*make)(const std::string& arm);
};

/// Registers a driver when the program starts.
struct ArmDriverRegistration {
    explicit ArmDriverRegistration(const ArmDriverKind& kind);
};

/// All drivers, sorted by name.
const std::vector<ArmDriverKind>& arm_drivers();

}  // namespace thaum::input
