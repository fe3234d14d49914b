// tactile/frame.h: what actuators do, as plain data. One frame covers eight ticks: 125 frames a second.
//
//     events -> TactileMixer -> TactileFrame every 8 ms -> jacket, pad, figure on the screen, recorder
//
// A frame is absolute: it does not depend on earlier ones, so a lost frame does no lasting harm. It has a
// time to live: an output whose link has died calls `frame_at` and becomes silent. An actuator gets an
// amplitude and a carrier frequency, so that waves of 12 ms survive the frame rate.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/units.h"

namespace thaum::tactile {

inline constexpr Tick frame_ticks = 8;
inline constexpr std::size_t frame_capacity = 64;  ///< largest number of actuators in a frame

/// Amplitudes of all actuators from one moment on.
struct TactileFrame {
    Tick tick{};  ///< tick at which the frame begins
    /// Number of ticks after which an output must be silent if there is no newer frame.
    Tick time_to_live{};
    std::uint64_t count{};                           ///< number of actuators in use
    std::array<float, frame_capacity> amplitude{};   ///< amplitude of each actuator, 0 to 1
    std::array<float, frame_capacity> carrier_hz{};  ///< frequency (Hz); meaningless where the amplitude is 0

    /// Whether all amplitudes are 0.
    bool is_silent() const;
};
static_assert(sizeof(TactileFrame) == 3 * 8 + 2 * 4 * frame_capacity,
              "no padding, so that frames can be hashed");

/// The frame as an output must play it at tick `now`: silent before the frame begins and after its time to
/// live.
TactileFrame frame_at(const TactileFrame& frame, Tick now);

}  // namespace thaum::tactile
