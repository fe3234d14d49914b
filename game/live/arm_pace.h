// game/live/arm_pace.h: how the clock of a live match follows the clock of a real force-feedback arm.
#pragma once
#include <algorithm>
#include <cstdint>

#include "core/units.h"

namespace thaum::game::inline live {

/// Correction of the match's clock for one tick (ns), added to the time at which the match began. The arm
/// ticks by a clock of its own, and each tick of the match takes one of its samples. Without a correction the
/// samples of a faster arm would pile up, and the forces would answer ever older samples. The correction is
/// at most 4 % of a tick for a faster arm and 0.4 % for a slower one. For a still slower arm, a tick that
/// finds no sample repeats the last one. `waiting`: samples that the match has not taken. `behind`: ticks of
/// the match that are due, this one included.
inline std::int64_t arm_pace_correction(std::int64_t waiting, Tick behind) {
    constexpr std::int64_t in_reserve = 2, most = 10, step_ns = 4000;
    if (waiting == 0) return 0;  // the arm may have stopped, so its clock is not followed
    const std::int64_t ahead = waiting - static_cast<std::int64_t>(behind - 1) - in_reserve;
    return -step_ns * std::clamp(ahead, -most, most);
}

}  // namespace thaum::game::inline live
