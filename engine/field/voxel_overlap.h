// field/voxel_overlap.h: measures how well a carved body matches a wanted body, and recounts only where an
// edit changed it.
//
// A voxel is inside a body if its density reaches the threshold. The overlap of the two bodies is the number
// of voxels inside both, divided by the number inside at least one of them (intersection over union).
#pragma once
#include "field/voxels.h"

namespace thaum::field {

/// Counts of voxels by which a body is compared with a wanted body. They derive from the densities alone:
/// recounting at any time gives the same result.
struct VoxelOverlap {
    std::array<int, 3> count{};  ///< voxels along each axis
    float threshold{};           ///< density from which on a voxel is inside
    /// A sum for each voxel: 1 if it is inside the body, plus 2 if it is inside the wanted body.
    std::vector<std::uint8_t> inside{};
    std::size_t both{};    ///< number of voxels inside the body and the wanted body
    std::size_t either{};  ///< number of voxels inside the body or the wanted body

    /// Whether a voxel is inside the wanted body.
    bool wants(std::size_t voxel) const { return (inside[voxel] & 2U) != 0; }
    /// Overlap of the bodies from 0 to 1; 1 for two empty bodies.
    double ratio() const { return either == 0 ? 1 : static_cast<double>(both) / static_cast<double>(either); }
};

/// Compares a body with a wanted one by counting all voxels. `wanted` has a density for each voxel.
VoxelOverlap overlap_with(const VoxelView& body, std::span<const float> wanted, float threshold);
/// Compares like overlap_with, but into `overlap`, whose memory is used again: it allocates only if the body
/// has grown.
void measure_overlap(const VoxelView& body, std::span<const float> wanted, float threshold,
                     VoxelOverlap& overlap);

/// Counts the voxels of a box again, after an edit, an undo or a redo there.
void recount(VoxelOverlap& overlap, const VoxelView& body, const VoxelBox& changed);

}  // namespace thaum::field
