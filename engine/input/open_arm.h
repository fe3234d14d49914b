// input/open_arm.h: finding and opening real force feedback arms, whatever their drivers.
//
//     const auto places = arm_places();              // arms that may be plugged in
//     auto arm = open_arm(places.at(0));             // an open arm, or one line that says what to do
//     (*arm)->start({step, &context});               // step is called at 1 kHz in the arm's servo thread
//     (*arm)->status();                              // present, lost or fault
//
// Drivers and vendors' libraries are not trusted (input/arm_driver.h). A call that never returns is given up
// after a limit. An arm without ticks is lost. A tick that comes too late does nothing. Texts and numbers are
// checked.
#pragma once
#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "core/error.h"
#include "input/arm.h"
#include "input/arm_driver.h"
#include "input/tick_times.h"

namespace thaum::input {

/// Greatest number of arms that one process can open at once.
inline constexpr std::size_t max_open_arms = 8;

/// Longest time that a driver may take before it counts as hanging.
struct ArmPatience {
    /// Longest time for opening an arm, and for starting its ticks (ns).
    std::int64_t open_ns = 15'000'000'000;
    std::int64_t close_ns = 3'000'000'000;  ///< longest time for closing an arm (ns)
    /// set to true when the user wants to end the program, so that waiting for an arm ends at once; null:
    /// unused
    const std::atomic<bool>* enough{};
};

/// An arm that may be plugged in.
struct ArmPlace {
    const ArmDriverKind* kind{};
    std::string arm{};  ///< word by which the driver distinguishes this arm from its other arms
};

/// Arms of all drivers, sorted by driver. Users call number i of the list "arm:i".
std::vector<ArmPlace> arm_places();

/// Whether a call of some driver has not returned. Then the program must end by _Exit, because a library's
/// own clean-up may hang as well.
bool arms_hang();

/// An arm that was opened, with the thread that calls its driver.
class OpenArm {
public:
    OpenArm(const OpenArm&) = delete;
    OpenArm& operator=(const OpenArm&) = delete;
    /// Ends the arm's force and its thread. The step function is never called again.
    ~OpenArm();

    /// Facts about the arm, as the driver reported them and the engine checked them.
    const ArmFacts& facts() const;

    /// Begins to call `tick` at 1 kHz. May be called once.
    Expected<void> start(ArmTick tick);
    /// State of the arm. After `lost` or `fault` there are no more ticks. Any thread may call it.
    ArmStatus status() const;
    /// Statistics of the times of the arm's ticks so far.
    TickReport times() const;
    /// Whether the system schedules the arm's thread before ordinary ones (SCHED_FIFO); false before the
    /// first tick.
    bool preferred() const;

private:
    friend Expected<std::unique_ptr<OpenArm>> open_arm(const ArmPlace&, const ArmPatience&);
    struct State;
    explicit OpenArm(std::shared_ptr<State> state);
    std::shared_ptr<State> state_;  ///< state of the arm, shared with the threads that call the driver
};

/// Opens and calibrates an arm. The error is one line: what is wrong, then what to do.
Expected<std::unique_ptr<OpenArm>> open_arm(const ArmPlace& place, const ArmPatience& patience = {});

}  // namespace thaum::input
