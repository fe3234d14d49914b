// The sky is drawn in the cells of a grid (sky.vert). This finds those in which it may be visible. No OpenGL.
#pragma once
#include <vector>

#include "render/scene.h"

namespace thaum::render::detail {

// Columns and rows of the grid in which the sky is drawn, and vertices of a cell, as in sky.vert.
inline constexpr int sky_columns = 16, sky_rows = 10, corners_of_sky_cell = 6;

/// Runs of adjacent cells of the sky, as glMultiDrawArrays takes them.
struct SkyCells {
    std::vector<std::int32_t> firsts, counts;  // first vertex and number of vertices of each run

    // Scratch memory, kept between frames.
    std::vector<std::uint64_t> hidden;
};

/// Finds all cells of the sky except those that one block covers completely. A block that contains the eye
/// hides nothing.
void open_sky_cells(const Camera& camera, float aspect, std::span<const Block> blocks, SkyCells& out);

}  // namespace thaum::render::detail
