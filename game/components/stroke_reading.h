// game/components/stroke_reading.h: what was read from a stroke that a wizard drew.
#pragma once
#include <cstdint>

namespace thaum::game {

inline constexpr std::uint32_t no_gesture = 0xFFFF'FFFF;

struct StrokeReading {
    std::uint32_t gesture = no_gesture;  ///< number in GestureSet; no_gesture: nothing was meant
    /// Probability that the gesture was meant, 0 to 1. Of a stroke that was not read, that it was meant as the nearest
    /// gesture, if every second stroke meant nothing.
    double probability{};
    double force{};  ///< mean force along the stroke, before caps and faders (N)
    /// Whole turns round the middle of a closed stroke, clockwise as the wizard sees it; negative: counterclockwise;
    /// 0 for a stroke that is not closed.
    double turns{};
};

}  // namespace thaum::game
