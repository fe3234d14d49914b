// input/detail/stall_watch.h: the watchdog of an arm's ticks. A device keeps exerting its last command, so a
// servo thread that hangs in the vendor's library, or that the library no longer calls, would leave the last
// force on the hand. The watchdog checks the ticks from a thread of its own, and ends the force when they
// have stopped.
#pragma once
#include <cstdint>
#include <functional>

#include "input/arm_driver.h"
#include "input/detail/arm_ticks.h"

namespace thaum::input {

/// Time between two checks (ns), and the number of checks without a tick after which the ticks count as
/// stopped. Checks are counted instead of reading a clock: while other programs take every core, the watchdog
/// is delayed like the ticks.
inline constexpr std::int64_t stall_look_ns = 5'000'000;
inline constexpr int stall_looks = 7;

/// Checks the ticks until they have ended or `ticks.unwatched` is set. When ticks stop while the arm exerts a
/// force, it ends the force in the driver's way: it calls write_zero at each check, or `give_up` after every
/// stall_looks checks.
void watch_for_stalls(ArmTicks& ticks, AtHang at_hang, const std::function<void()>& give_up);

}  // namespace thaum::input
