// field/voxel_overlap.h: how much of a body lies in a wanted body, counted anew only where an edit changed it.
//
// A voxel is inside a body if its density reaches the threshold. The overlap of the two bodies is the number of
// voxels inside both, divided by the number inside at least one of them (intersection over union).
#pragma once
#include "field/voxels.h"

namespace thaum::field {

/// A count of voxels, derived from the densities: it can be made again at any time with the same result.
struct VoxelOverlap {
    std::array<int, 3> count{};          ///< voxels along each axis
    float threshold{};                   ///< density from which a voxel is inside
    std::vector<std::uint8_t> inside{};  ///< for each voxel: 1 inside the body, plus 2 inside the wanted body
    std::size_t both{};                  ///< voxels inside both
    std::size_t either{};                ///< voxels inside at least one

    /// Whether the wanted body holds a voxel.
    bool wants(std::size_t voxel) const { return (inside[voxel] & 2U) != 0; }
    /// Overlap of the bodies from 0 to 1; 1 for two empty bodies.
    double ratio() const { return either == 0 ? 1 : static_cast<double>(both) / static_cast<double>(either); }
};

/// Counts all voxels. `wanted` is a density for each voxel of the body.
VoxelOverlap overlap_with(const VoxelView& body, std::span<const float> wanted, float threshold);

/// Counts the voxels of a box anew, after an edit, an undo or a redo there.
void recount(VoxelOverlap& overlap, const VoxelView& body, const VoxelBox& changed);

}  // namespace thaum::field
