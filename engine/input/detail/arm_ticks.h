// input/detail/arm_ticks.h: the servo ticks of open arms, one call per tick of a servo thread. The thread may
// be a vendor's, and a vendor's library may call at any time: twice at once, from within one of its own
// functions, or after it was told to stop. So it holds a number and no address, and a call whose number belongs
// to no open arm does nothing.
#pragma once
#include <atomic>

#include "input/arm.h"
#include "input/arm_driver.h"
#include "input/tick_times.h"

namespace thaum::input {

/// The ticks of one arm, from `open_ticks` until `close_ticks`.
struct ArmTicks {
    ArmDriver* driver{};
    double peak_force{};  ///< limit of the force (N)
    ArmTick tick{};
    std::uint64_t number{};  ///< number of the opened arm in this process; 0: none
    TickTimes times{};
    std::atomic<ArmFault> fault{0};     ///< fault that ended the ticks; the driver has kept its words before
    std::atomic<bool> accepted{false};  ///< the driver has started the ticks; before that they give no force
    std::atomic<bool> ending{false};    ///< the next tick is the last
    std::atomic<bool> ended{false};
    std::atomic<bool> preferred{false};
    std::atomic<bool> silent{false};  ///< the newest tick gave no force because silence was asked for

    // Shared with the watchdog (detail/stall_watch.h).
    std::atomic<std::uint64_t> done{0};  ///< ticks that have returned
    /// The arm may exert a force: the last one that it took is not known to be zero.
    std::atomic<bool> pushes{false};
    std::atomic<bool> stalled{false};    ///< the watchdog has ended the force since the newest tick
    std::atomic<bool> unwatched{false};  ///< the watchdog shall end
    std::uint32_t resumed{};  ///< ticks since the last stall, up to those of the ramp; the servo thread's
};

/// Gives the ticks a number, with which calls reach them. Returns false if most_open_arms are open.
bool open_ticks(ArmTicks& ticks);

/// Runs one tick. Returns false if no more ticks may come.
bool run_tick(std::uint64_t number) noexcept;

/// Asks the system to run this thread before ordinary ones (SCHED_FIFO). Returns whether it does, or has done so before.
bool prefer_this_thread(int priority);

/// After this call the step of the ticks is never called again. Returns false if a tick hangs in the driver:
/// then the ticks must live for ever.
bool close_ticks(ArmTicks& ticks);

}  // namespace thaum::input
