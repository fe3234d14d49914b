// core/units.h: the time units of the simulation. One tick is one haptic sample, 1 ms (ARCHITECTURE.md, "The
// tick").
#pragma once
#include <cstdint>

namespace thaum {

/// Time or duration in ticks.
using Tick = std::uint64_t;

inline constexpr double tick_seconds = 0.001;
inline constexpr Tick ticks_per_second = 1000;
/// Interval between hashes of the state in the log of a match (ticks).
inline constexpr Tick hash_interval = 128;
/// Interval at which physics is rebuilt from the state (ticks). A replay can start at such a tick, because
/// physics then depends on the saved state alone.
inline constexpr Tick keyframe_interval = 2048;

/// Converts ticks to seconds.
constexpr double seconds(Tick ticks) { return static_cast<double>(ticks) * tick_seconds; }

/// Converts a duration (s, >= 0) to the nearest number of ticks.
constexpr Tick ticks(double s) {
    const double exact = s * static_cast<double>(ticks_per_second);
    const auto whole = static_cast<Tick>(exact);  // rounded by hand, because std::lround is not constexpr
    return whole + (exact - static_cast<double>(whole) >= 0.5 ? 1 : 0);
}

}  // namespace thaum
