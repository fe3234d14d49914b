// game/hud/frame_times.h: where the time of the pictures goes, as a line on the screen.
#pragma once
#include <string>

#include "render/pass_times.h"
#include "render/quality.h"

namespace thaum::game::inline hud {

/// Times of the pictures of about the last second (ms).
struct FrameTimes {
    double building_ms{};  ///< time to make the renderer's frame from the match's picture
    /// times of the renderer's passes (steps of drawing), measured so that no two overlap
    render::PassTimes passes;
    double showing_ms{};  ///< time to bring the drawn frame to the screen
    render::Quality quality{};
    float resolution = 1;  ///< length of the views' pixels along a side as a share of the window's
    double total_ms() const { return building_ms + passes.total_ms() + showing_ms; }
    bool operator==(const FrameTimes&) const = default;
};

/// Moves times by a share `weight` (0 to 1) towards those of the newest picture, so that they can be read.
void approach(FrameTimes& shown, const FrameTimes& newest, double weight);

/// One line: the time of a whole picture, then of each part of it of at least 0.05 ms, the longest first.
std::string words_of(const FrameTimes& times);

}  // namespace thaum::game::inline hud
