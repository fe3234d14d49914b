// Where the sky may be seen: the cells of sky.vert's grid. Pure: no OpenGL.
#pragma once
#include <vector>

#include "render/scene.h"

namespace thaum::render::detail {

// As sky.vert has them.
inline constexpr int sky_columns = 16, sky_rows = 10, corners_of_sky_cell = 6;

/// Runs of cells, as glMultiDrawArrays takes them.
struct SkyCells {
    std::vector<std::int32_t> firsts, counts;  // vertices

    // Kept between frames for its memory.
    std::vector<std::uint64_t> hidden;
};

/// All but those that lie wholly within what one block covers. A block that the eye is in hides nothing.
void open_sky_cells(const Camera& camera, float aspect, std::span<const Block> blocks, SkyCells& out);

}  // namespace thaum::render::detail
