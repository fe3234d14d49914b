// input/open_arm.h: finding and opening real force feedback arms, whatever their drivers.
//
//     const auto places = arm_places();              // arms that may be plugged in
//     auto arm = open_arm(places.at(0));             // an open arm, or one line that says what to do
//     (*arm)->start({step, &context});               // step is called at 1 kHz in the arm's servo thread
//     (*arm)->status();                              // present, lost or fault
//
// Drivers and vendors' libraries are not trusted (input/arm_driver.h). A call that never returns is given up
// after a limit. An arm whose ticks fail to come is lost. A tick that comes too late does nothing. Texts and
// numbers are checked.
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

/// Arms that one process can hold at once.
inline constexpr std::size_t most_open_arms = 8;

/// Time that a driver may take before it counts as hanging.
struct ArmPatience {
    std::int64_t open_ns = 15'000'000'000;  ///< for opening an arm, and for starting its ticks (ns)
    std::int64_t close_ns = 3'000'000'000;  ///< for closing an arm (ns)
    /// true: somebody wants the program to end, so waiting for an arm to open ends at once; null: nobody
    const std::atomic<bool>* enough{};
};

/// An arm that may be plugged in.
struct ArmPlace {
    const ArmDriverKind* kind{};
    std::string arm{};  ///< the driver's word for the arm
};

/// Arms of all drivers, sorted by driver. Number i of the list is the arm that people call "arm:i".
std::vector<ArmPlace> arm_places();

/// Whether a driver's call has not returned. Then the program must end by _Exit, because a library's own clean-up may
/// hang as well.
bool arms_hang();

class OpenArm {
public:
    OpenArm(const OpenArm&) = delete;
    OpenArm& operator=(const OpenArm&) = delete;
    /// Leaves the arm without force and ends its thread. The step of its ticks is never called again.
    ~OpenArm();

    const ArmFacts& facts() const;

    /// From now on `tick` is called at 1 kHz. May be called once.
    Expected<void> start(ArmTick tick);
    /// Any thread. After lost or fault no more ticks come.
    ArmStatus status() const;
    TickReport times() const;
    /// Whether the system runs the arm's thread before others (SCHED_FIFO); false before the first tick.
    bool preferred() const;

private:
    friend Expected<std::unique_ptr<OpenArm>> open_arm(const ArmPlace&, const ArmPatience&);
    struct State;
    explicit OpenArm(std::shared_ptr<State> state);
    std::shared_ptr<State> state_;  ///< shared with the threads that call the driver
};

/// Opens and calibrates an arm. The error is one line: what is wrong, then what to do.
Expected<std::unique_ptr<OpenArm>> open_arm(const ArmPlace& place, const ArmPatience& patience = {});

}  // namespace thaum::input
