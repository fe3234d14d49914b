// tactile/frame.h: what actuators do, as plain data. One frame covers eight ticks: 125 frames a second.
//
//     events -> TactileMixer -> TactileFrame every 8 ms -> jacket, pad, figure of the HUD, recorder
//
// A frame is absolute: it does not build on earlier ones, so a lost frame leaves nothing wrong. It has a time to live:
// an output whose link has died calls `frame_at` and becomes silent. An actuator gets an amplitude and a carrier
// frequency, so that waves of 12 ms survive the frame rate.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/units.h"

namespace thaum::tactile {

inline constexpr Tick frame_ticks = 8;
inline constexpr std::size_t frame_capacity = 64;  ///< actuators

struct TactileFrame {
    Tick tick{};            ///< when the frame begins
    Tick time_to_live{};    ///< ticks after which an output must be silent without a newer frame
    std::uint64_t count{};  ///< actuators in use
    std::array<float, frame_capacity> amplitude{};  ///< 0 to 1
    std::array<float, frame_capacity>
        carrier_hz{};  ///< frequency (Hz); of no meaning where the amplitude is 0

    bool is_silent() const;
};
static_assert(sizeof(TactileFrame) == 3 * 8 + 2 * 4 * frame_capacity,
              "no padding, so that frames can be hashed");

/// The frame as an output has to play it at `now`: all silent before it begins and after its time to live.
TactileFrame frame_at(const TactileFrame& frame, Tick now);

}  // namespace thaum::tactile
