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

/// Computes the weights of the voxels of `part`, from 0 to 1. Returns the number of weights.
std::size_t weigh(const Footprint& footprint, const VoxelBox& part, PartWeights& weights);

/// Largest product of a filter's rate and time in one edit. exp(-max_amount) is close to the least normal
/// double.
inline constexpr double max_amount = 700;

/// Turns the first `count` weights w into 1 - exp(-amount w), the part of the way to its constant by which a
/// filter moves a property. The error is below 1e-13. Four voxels are computed at once, and rows of zeros, as
/// there are around a ball, are left as they are.
void to_shares(double amount, std::size_t count, PartWeights& weights);

}  // namespace thaum::field
