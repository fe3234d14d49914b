// tactile/clip.h: a recording of strengths over time on a jacket of 4x5 cells in front and 4x5 at the back.
//
// This is what a .tact file holds (tact.h): 50 frames a second, a strength for each cell. A clip plays on
// every layout, because each cell is a place on the body.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tactile/body.h"
#include "tactile/frame.h"

namespace thaum::tactile {

/// Number of cells on a jacket's front; as many are on its back.
inline constexpr std::size_t clip_side = 20;
/// Number of all cells: front cells, then back cells; rows from the top, each from the wearer's left.
inline constexpr std::size_t clip_cells = 40;
inline constexpr Tick clip_frame_ticks = 20;
inline constexpr std::size_t max_clip_frames = 3000;  ///< largest number of frames: one minute

/// The strengths of all cells of a jacket in one frame of a recording.
struct ClipFrame {
    std::array<std::uint8_t, clip_cells> strength{};  ///< strength of each cell, 0 to 100

    bool operator==(const ClipFrame&) const = default;
};

/// A recording of strengths over time on a grid of places.
struct Clip {
    std::string name;
    std::vector<ClipFrame> frames;  ///< frames with their strengths; at most max_clip_frames

    bool operator==(const Clip&) const = default;
};

/// Place of a cell of the jacket on the body.
BodyPoint clip_place(std::size_t cell);

}  // namespace thaum::tactile
