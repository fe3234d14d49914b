#include "render/detail/sky_cells.h"

#include <algorithm>
#include <cmath>

namespace thaum::render::detail {
namespace {

constexpr std::size_t max_blocks = 64;

bool holds(const Block& block, vec3 p) {
    return glm::all(glm::lessThanEqual(block.low, p)) && glm::all(glm::lessThanEqual(p, block.high));
}

/// One bit for each block that the ray from the eye hits. A block that contains the eye does not count.
std::uint64_t hidden_by(std::span<const Block> blocks, vec3 eye, vec3 way) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < std::min(blocks.size(), max_blocks); ++i) {
        if (meets(blocks[i], eye, way) && !holds(blocks[i], eye)) bits |= std::uint64_t{1} << i;
    }
    return bits;
}

void look_through_corners(const Camera& camera, float aspect, std::span<const Block> blocks,
                          std::vector<std::uint64_t>& out) {
    const float high = std::tan(camera.fov_y / 2);
    out.clear();
    for (int y = 0; y <= sky_rows; ++y) {
        for (int x = 0; x <= sky_columns; ++x) {
            const float right = 2 * static_cast<float>(x) / sky_columns - 1;
            const float up = 2 * static_cast<float>(y) / sky_rows - 1;
            const fvec3 way = camera.orientation * fvec3(right * high * aspect, up * high, -1);
            out.push_back(hidden_by(blocks, vec3(camera.position), vec3(way)));
        }
    }
}

/// Returns true if the sky may be visible in the cell. Seen from one place, a block covers a convex part of
/// the picture. A block that covers the four corners of a cell therefore covers the whole cell.
bool is_open(const std::vector<std::uint64_t>& hidden, int column, int row) {
    const auto at = [&](int x, int y) {
        return hidden[static_cast<std::size_t>(y) * (sky_columns + 1) + static_cast<std::size_t>(x)];
    };
    return (at(column, row) & at(column + 1, row) & at(column, row + 1) & at(column + 1, row + 1)) == 0;
}

}  // namespace

void open_sky_cells(const Camera& camera, float aspect, std::span<const Block> blocks, SkyCells& out) {
    out.firsts.clear();
    out.counts.clear();
    look_through_corners(camera, aspect, blocks, out.hidden);
    for (int cell = 0; cell < sky_columns * sky_rows; ++cell) {
        if (!is_open(out.hidden, cell % sky_columns, cell / sky_columns)) continue;
        const int first = cell * corners_of_sky_cell;
        const bool goes_on = !out.firsts.empty() && out.firsts.back() + out.counts.back() == first;
        if (goes_on) {
            out.counts.back() += corners_of_sky_cell;
        } else {
            out.firsts.push_back(first);
            out.counts.push_back(corners_of_sky_cell);
        }
    }
}

}  // namespace thaum::render::detail
