// game/data/periods.h: how often the systems of a match run.
#pragma once
#include "core/units.h"

namespace thaum::game::inline data {

/// How often physics and gameplay systems run: every so many ticks. A tick is 1 ms (engine/ARCHITECTURE.md,
/// "The tick").
inline constexpr Tick physics_period = 1;
inline constexpr Tick gameplay_period = 8;
inline constexpr double physics_dt = seconds(physics_period);
inline constexpr double gameplay_dt = seconds(gameplay_period);

}  // namespace thaum::game::inline data
