// Finds the cells of sky.vert's grid in which the sky may be visible. No OpenGL.
#pragma once
#include <vector>

#include "render/scene.h"

namespace thaum::render::detail {

// Columns, rows and corners of the grid of cells, with the same values as in sky.vert.
inline constexpr int sky_columns = 16, sky_rows = 10, corners_of_sky_cell = 6;

/// Runs of cells, in the form of glMultiDrawArrays.
struct SkyCells {
    std::vector<std::int32_t> firsts, counts;  // first vertex and number of vertices of each run

    // Scratch memory, kept between frames.
    std::vector<std::uint64_t> hidden;
};

/// Finds all cells except those that one block covers completely. A block that contains the eye hides
/// nothing.
void open_sky_cells(const Camera& camera, float aspect, std::span<const Block> blocks, SkyCells& out);

}  // namespace thaum::render::detail
