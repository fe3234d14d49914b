// game/components/stroke_reading.h: result of reading a stroke that a wizard drew.
#pragma once
#include <cstdint>

namespace thaum::game::inline components {

inline constexpr std::uint32_t no_gesture = 0xFFFF'FFFF;

struct StrokeReading {
    std::uint32_t gesture = no_gesture;  ///< number of the recognised gesture in the player's set;
                                         ///< no_gesture: none was recognised
    /// Probability that the gesture was meant, 0 to 1. For an unrecognised stroke: probability that the
    /// nearest gesture was meant, if half of all strokes are no gesture at all.
    double probability{};
    double force{};  ///< mean force along the stroke, before limits and the player's faders reduce it (N)
    /// Number of turns around the middle of a closed stroke, clockwise as the wizard sees it; negative:
    /// counter-clockwise; 0: the stroke is not closed.
    double turns{};
};

}  // namespace thaum::game::inline components
