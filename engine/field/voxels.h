// field/voxels.h: a body made of voxels that can be felt, seen and carved (R. S. Avila, L. M. Sobierajski, A
// haptic interaction method for volume visualization, 1996, section 3).
//
//     Voxels (owns) -- view --> VoxelView --> edit (field/carving.h)
//        |                          |
//        |                          '-- Bricks: which parts have changed, for readers that keep copies
//        '-- density_grid --> Grid --> Placed --> value and gradient at any place of the world
//
// Each property is an array of its own, because haptics read only the density, and pictures read mostly the
// density. Voxel (i, j, k) is element i + count[0] (j + count[1] k) of each array. The arrays may also be
// blobs of a World (arrays saved with the game's state): a VoxelView refers to them in the same way.
//
// The paper stores a gradient in each voxel, too: 3 bytes of magnitude and direction. Here Grid
// computes it from the density. A stored gradient would have to be recomputed around each edit, in
// every undo and in every snapshot. Its 8 bits of magnitude and 16 bits of direction would also
// disagree with the surface that is drawn.
//
// Bricks are blocks of 8 x 8 x 8 voxels; those at the far ends may be smaller. Lengths are in m, in the
// body's own frame: its origin is the middle of all voxels.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/maths.h"
#include "field/field.h"
#include "field/placement.h"

namespace thaum::field {

/// Colour of a voxel: red, green and blue, 0 to 255 each.
struct Rgb8 {
    std::uint8_t r{}, g{}, b{};

    bool operator==(const Rgb8&) const = default;
};

/// A box of voxels: those with low <= (i, j, k) < high. By default there are none.
struct VoxelBox {
    std::array<int, 3> low{}, high{};

    bool empty() const { return low[0] >= high[0] || low[1] >= high[1] || low[2] >= high[2]; }
    bool operator==(const VoxelBox&) const = default;
};

/// Smallest box that contains both boxes.
VoxelBox around(const VoxelBox& a, const VoxelBox& b);
/// Voxels that lie in both boxes.
VoxelBox overlap(const VoxelBox& a, const VoxelBox& b);

/// Voxels along each edge of a brick (a block of voxels).
inline constexpr int brick_size = 8;
inline constexpr int voxels_of_brick = brick_size * brick_size * brick_size;

/// Record of the parts of a body that have changed, brick by brick (block of 8 x 8 x 8 voxels). A reader that
/// keeps a copy also keeps the value of `newest` at its last look. Later it reads again only bricks whose
/// version is above that value.
///
/// The versions are no part of the body's state. They never go back, not even when an older state is
/// restored. Otherwise a reader could take its copy of a brick from before for the brick as it was changed
/// after the restoration.
struct Bricks {
    std::array<int, 3> count{};
    std::vector<std::uint32_t> version{};  ///< value of `newest` when each brick last changed
    /// Number of the newest change. It is 1 after the body was made, so a reader that has seen 0 reads every
    /// brick.
    std::uint32_t newest = 1;

    std::size_t at(int i, int j, int k) const {
        return static_cast<std::size_t>(i) +
               static_cast<std::size_t>(count[0]) *
                   (static_cast<std::size_t>(j) +
                    static_cast<std::size_t>(count[1]) * static_cast<std::size_t>(k));
    }
};

/// Bricks (blocks of 8 x 8 x 8 voxels) of a body of this many voxels. All of them have version 1.
Bricks make_bricks(std::array<int, 3> voxels);

/// A body whose arrays belong to another object.
struct VoxelView {
    std::array<int, 3> count{};
    vec3 spacing{1};            ///< distance between voxels along each axis (m)
    float empty = 0, full = 1;  ///< densities of empty and of solid material; full > empty
    float surface = 0.5F;       ///< density at the body's surface, for tools that draw on it
    std::span<float> density{};
    std::span<Rgb8> colour{};
    std::span<std::uint8_t> material{};  ///< index into a table of materials (field/materials.h)
    Bricks* bricks{};

    /// Index of a voxel in the arrays.
    std::size_t at(int i, int j, int k) const {
        return static_cast<std::size_t>(i) +
               static_cast<std::size_t>(count[0]) *
                   (static_cast<std::size_t>(j) +
                    static_cast<std::size_t>(count[1]) * static_cast<std::size_t>(k));
    }
    /// The box of all voxels.
    VoxelBox all() const { return {{}, count}; }
    /// The density at any place of the body's frame. Valid as long as the arrays.
    Grid density_grid(Kernel kernel = Kernel::catmull_rom) const;
    /// Place of voxel (0, 0, 0) (m).
    vec3 first_place() const;
    /// Volume of one voxel (m^3).
    double voxel_volume() const { return spacing.x * spacing.y * spacing.z; }
};

/// A body that owns its arrays.
struct Voxels {
    std::array<int, 3> count{};
    vec3 spacing{1};            ///< distance between voxels along each axis (m)
    float empty = 0, full = 1;  ///< densities of empty and of solid material; full > empty
    float surface = 0.5F;       ///< density at the body's surface, for tools that draw on it
    std::vector<float> density{};
    std::vector<Rgb8> colour{};
    std::vector<std::uint8_t> material{};
    Bricks bricks{};
    Placement placement{};  ///< placement of the body in its parent's frame

    /// The arrays, for reading and changing them. Valid until the body is destroyed or moved.
    VoxelView view() { return {count, spacing, empty, full, surface, density, colour, material, &bricks}; }
    /// The density at any place of the body's frame. Valid until the body is destroyed or moved.
    Grid density_grid(Kernel kernel = Kernel::catmull_rom) const;
};

/// The greatest number of voxels of a body: 1,024 along each axis.
inline constexpr std::size_t max_voxels = std::size_t{1} << 30U;

/// A body of empty voxels: density 0, white, material 0. Each count must be positive, their product at most
/// `max_voxels`.
Voxels make_voxels(std::array<int, 3> count, vec3 spacing);

/// The box of the voxels of one brick (a block of 8 x 8 x 8 voxels).
VoxelBox brick_box(std::array<int, 3> voxels, std::array<int, 3> brick);

/// Bricks (blocks of 8 x 8 x 8 voxels) that hold voxels of the box, as a box of bricks.
VoxelBox bricks_around(const VoxelBox& box);

/// Calls visit(brick, number) for each brick of the box of bricks `some`, x fastest.
template <class Visit>
void for_each_brick(const Bricks& bricks, const VoxelBox& some, Visit visit) {
    for (int k = some.low[2]; k < some.high[2]; ++k) {
        for (int j = some.low[1]; j < some.high[1]; ++j) {
            for (int i = some.low[0]; i < some.high[0]; ++i) visit(std::array{i, j, k}, bricks.at(i, j, k));
        }
    }
}

/// Calls visit(first, row) for each row of voxels of the box. `first` is the index of its first voxel, `row`
/// counts the rows from 0.
template <class Visit>
void for_each_row(const VoxelView& body, const VoxelBox& box, Visit visit) {
    std::size_t row = 0;
    for (int k = box.low[2]; k < box.high[2]; ++k) {
        for (int j = box.low[1]; j < box.high[1]; ++j) visit(body.at(box.low[0], j, k), row++);
    }
}

/// Marks every brick (8 x 8 x 8 voxels) that holds a voxel of the box as changed.
void mark_changed(Bricks& bricks, const VoxelBox& box);

}  // namespace thaum::field
