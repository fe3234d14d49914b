#include "field/voxels.h"

#include "core/assert.h"

namespace thaum::field {
namespace {

vec3 first_place_of(std::array<int, 3> count, vec3 spacing) {
    return -0.5 * spacing * vec3(count[0] - 1, count[1] - 1, count[2] - 1);
}

Grid grid_of(std::span<const float> density, std::array<int, 3> count, vec3 spacing, Kernel kernel) {
    const std::ptrdiff_t row = count[0], plane = row * count[1];
    return {.first = density.data(),
            .count = count,
            .stride = {1, row, plane},
            .origin = first_place_of(count, spacing),
            .spacing = spacing,
            .kernel = kernel};
}

}  // namespace

vec3 VoxelView::first_place() const { return first_place_of(count, spacing); }

Grid VoxelView::density_grid(Kernel kernel) const { return grid_of(density, count, spacing, kernel); }

Grid Voxels::density_grid(Kernel kernel) const { return grid_of(density, count, spacing, kernel); }

VoxelBox around(const VoxelBox& a, const VoxelBox& b) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    VoxelBox both;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        both.low[axis] = std::min(a.low[axis], b.low[axis]);
        both.high[axis] = std::max(a.high[axis], b.high[axis]);
    }
    return both;
}

VoxelBox overlap(const VoxelBox& a, const VoxelBox& b) {
    VoxelBox both;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        both.low[axis] = std::max(a.low[axis], b.low[axis]);
        both.high[axis] = std::min(a.high[axis], b.high[axis]);
    }
    return both.empty() ? VoxelBox{} : both;
}

Bricks make_bricks(std::array<int, 3> voxels) {
    Bricks bricks;
    bricks.count = bricks_around({{}, voxels}).high;
    bricks.version.assign(bricks.at(0, 0, bricks.count[2]), bricks.newest);
    return bricks;
}

Voxels make_voxels(std::array<int, 3> count, vec3 spacing) {
    std::size_t total = 1;
    for (const int n : count) {
        THAUM_ASSERT(n > 0 && static_cast<std::size_t>(n) <= max_voxels / total,
                     "too few or too many voxels");
        total *= static_cast<std::size_t>(n);
    }
    THAUM_ASSERT(is_finite(spacing) && spacing.x > 0 && spacing.y > 0 && spacing.z > 0,
                 "voxels need a positive spacing");
    Voxels body{.count = count, .spacing = spacing, .bricks = make_bricks(count)};
    body.density.assign(total, body.empty);
    body.colour.assign(total, Rgb8{255, 255, 255});
    body.material.assign(total, 0);
    return body;
}

VoxelBox brick_box(std::array<int, 3> voxels, std::array<int, 3> brick) {
    VoxelBox box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        box.low[axis] = brick[axis] * brick_size;
        box.high[axis] = std::min(box.low[axis] + brick_size, voxels[axis]);
    }
    return box;
}

VoxelBox bricks_around(const VoxelBox& box) {
    if (box.empty()) return {};
    VoxelBox bricks;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        bricks.low[axis] = box.low[axis] / brick_size;
        bricks.high[axis] = (box.high[axis] + brick_size - 1) / brick_size;
    }
    return bricks;
}

void mark_changed(Bricks& bricks, const VoxelBox& box) {
    if (box.empty()) return;
    ++bricks.newest;
    for_each_brick(bricks, bricks_around(box),
                   [&](std::array<int, 3>, std::size_t brick) { bricks.version[brick] = bricks.newest; });
}

}  // namespace thaum::field
