// field/detail/carving_extent.h: which voxels an operation reaches, and the
// weight of each (field/carving_tools.h).
//
// The rim of a hard shape falls from 1 to 0 over two voxels, so that a carved surface lies between voxels
// where the surface of the shape is. With a narrower rim, a hand would feel the steps from voxel to voxel.
// Spheres with a radius of 12.3 voxels, carved at random places and read with the kernel catmull_rom:
//
//     rim (voxels)               1       1.5     2       3
//     surface off by, at most    0.097   0.039   0.013   0.006   voxels
//     normal off by, at most     18.1    7.5     2.4     0.9     degrees
#pragma once
#include <array>
#include <cstdint>
#include <limits>

#include "field/carving_tools.h"

namespace thaum::field {

/// The extent of an operation (the region in which a tool acts), placed in a body.
struct Footprint {
    VoxelBox box{};  ///< voxels that may have a weight above 0
    ExtentShape shape{};
    const Stamp* stamp{};
    vec3 centre{};   ///< centre, counted in voxels from the first voxel
    vec3 step{1};    ///< distance between voxels (voxels or m, as the extent says)
    vec3 half{};     ///< half edges along the tool's axes (voxels or m)
    double rim{};    ///< width over which the weight falls from 1 to 0 (voxels or m)
    mat3 turn{1.0};  ///< rotation from the tool's frame to the body's
};

/// Places an extent (the region in which a tool acts) in a body. The footprint has no voxels if `place` is
/// outside the body or if a number is not finite.
Footprint footprint_of(const VoxelView& body, const Extent& extent, vec3 place, const mat3& turn);

/// Like footprint_of, for a plate: a thin box for cuts, which reaches along the motion to `place`. Its z axis
/// lies along the motion, its y axis as near to the tool's y axis as that allows. Without motion it is like
/// any box.
Footprint plate_of(const VoxelView& body, const Extent& extent, vec3 place, vec3 motion, const mat3& turn);

/// A number for each voxel of a part of at most 8 x 8 x 8 voxels, x fastest. Each row has 8 numbers; those
/// beyond the end of a shorter row are 0.
using PartWeights = std::array<double, voxels_of_brick>;

/// A number for each voxel of a part along one axis.
using BrickAxis = std::array<double, brick_size>;

/// The factors of a bell (ExtentShape::gaussian) along one axis of a part, and what they were computed from.
/// Most parts share them with the part before along two axes, and several operations with each other.
struct BellAxis {
    double centre = std::numeric_limits<double>::quiet_NaN();  ///< at first equal to nothing
    double step{}, radius{};
    int low{}, high{};
    BrickAxis factors{};
};
using BellAxes = std::array<BellAxis, 3>;

/// Computes the weights of the voxels of `part`, from 0 to 1. Returns the number of weights. `last` keeps
/// the factors of this part along each axis, since the next part often has the same along some axes.
std::size_t weigh(const Footprint& footprint, const VoxelBox& part, BellAxes& last, PartWeights& weights);

/// Largest product of a filter's rate and time in one edit. exp(-max_amount) is close to the least normal
/// double.
inline constexpr double max_amount = 700;

/// Rows of a part that hold a weight above 0, in order. At the border of a ball, some rows hold none. They
/// are left out here, once, because a branch at each row would often be foreseen wrongly.
struct WeightedRows {
    std::array<std::uint8_t, voxels_of_brick / brick_size> rows;
    std::size_t count = 0;
};
WeightedRows weighted_rows(const PartWeights& weights, std::size_t count);

/// Turns the weights w of these rows into 1 - exp(-amount w), the part of the way to its constant by which a
/// filter moves a property. The error is below 1e-13. Two rows are computed at once.
void to_shares(double amount, const WeightedRows& weighted, PartWeights& weights);

}  // namespace thaum::field
