// input/detail/arm_ticks.h: the servo ticks of open arms, one call per tick of a servo thread. The thread may
// be a vendor's, and a vendor's library may call at any time: twice at once, from within one of its own
// functions, or after it was told to stop. The library is therefore given a number instead of an address, and
// a call whose number belongs to no open arm does nothing.
#pragma once
#include <atomic>

#include "input/arm.h"
#include "input/arm_driver.h"
#include "input/tick_times.h"

namespace thaum::input {

/// The ticks of one arm, from `open_ticks` until `close_ticks`.
struct ArmTicks {
    ArmDriver* driver{};
    double peak_force{};  ///< largest force that the arm gets (N)
    ArmTick tick{};
    std::uint64_t number{};  ///< number of the opened arm in this process; 0: none
    TickTimes times{};
    /// Fault that ended the ticks; its message was stored before it was set.
    std::atomic<ArmFault> fault{0};
    /// true: the driver has started the ticks; before that they give no force.
    std::atomic<bool> accepted{false};
    std::atomic<bool> ending{false};  ///< true: the next tick is the last
    std::atomic<bool> ended{false};
    std::atomic<bool> preferred{false};
    std::atomic<bool> silent{false};  ///< true: the newest tick gave no force because silence was asked for

    // Shared with the watchdog (detail/stall_watch.h).
    std::atomic<std::uint64_t> done{0};  ///< ticks that have returned
    /// True: the arm may exert a force, since the last force that it took is not known to be zero.
    std::atomic<bool> pushes{false};
    std::atomic<bool> stalled{false};    ///< true: the watchdog has ended the force since the newest tick
    std::atomic<bool> unwatched{false};  ///< true: the watchdog must end, because the arm is being closed
    /// Number of ticks since the ticks resumed after a stop, while the force still fades in; 0: no fade is
    /// under way. Used by the servo thread.
    std::uint32_t resumed{};
};

/// Gives the ticks of an arm a number, by which calls of `run_tick` find them. Returns false if max_open_arms
/// arms are open already.
bool open_ticks(ArmTicks& ticks);

/// Runs one tick of the open arm whose ticks have this number: reads the pose, computes the force and sends
/// it. Returns false if no further tick is needed.
bool run_tick(std::uint64_t number) noexcept;

/// Asks the system to schedule this thread before ordinary ones (SCHED_FIFO). Returns whether it does, or
/// already did.
bool prefer_this_thread(int priority);

/// Ends the ticks, so that the step function is never called again. Returns false if a tick hangs in the
/// driver; the ticks must then never be destroyed.
bool close_ticks(ArmTicks& ticks);

}  // namespace thaum::input
