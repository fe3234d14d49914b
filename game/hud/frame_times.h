// game/hud/frame_times.h: where the time of the pictures goes, as a line on the screen.
#pragma once
#include <string>

#include "render/pass_times.h"
#include "render/quality.h"

namespace thaum::game::inline hud {

/// Times of the pictures of about the last second (ms).
struct FrameTimes {
    double building_ms{};      ///< from the match's picture to the renderer's frame
    render::PassTimes passes;  ///< the renderer's passes, each waiting for the one before
    double showing_ms{};       ///< bringing the picture to the screen
    render::Quality quality{};
    float resolution = 1;  ///< length of the views' pixels along a side as a share of the window's
    double total_ms() const { return building_ms + passes.total_ms() + showing_ms; }
    bool operator==(const FrameTimes&) const = default;
};

/// Moves times by a share `weight` (0 to 1) towards those of the newest picture, so that they can be read.
void approach(FrameTimes& shown, const FrameTimes& newest, double weight);

/// One line: the whole time, then each part of at least 0.05 ms, the longest first.
std::string words_of(const FrameTimes& times);

}  // namespace thaum::game::inline hud
