// field/block_averages.h: averages of blocks of a body's samples. Surface normals that are computed from them
// do not show the body's steps.
//
// Two kinds of body have steps that are larger than a sample: one whose samples lie farther apart along one
// axis, as slices of a scan do, and one whose samples have few values, as those of a mask do. A block is as
// wide along each axis as the widest spacing. It is twice as wide if there are few values, or if slices are
// at least twice as far apart as the samples within them and are hard: the values jump from one slice to the
// next, while in slices that average their whole thickness a surface shows values in between. So the averages
// are equally far apart along all axes and have values in between.
//
// The wider blocks are used only where they are needed, because they blur curved surfaces unevenly. In slices
// of 3 mm, they turn the normals of a ring with a tube of 18 mm by up to 5.9 degrees, the narrower ones by up
// to 1.6.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "field/voxels.h"

namespace thaum::field {

/// Averages of blocks of a grid's samples. The first block begins at the first sample; the
/// last ones may hold fewer samples.
struct BlockAverages {
    std::array<int, 3> block{1, 1, 1};  ///< number of samples of a block along each axis
    std::array<int, 3> count{};         ///< number of blocks along each axis
    /// Whether surfaces have such steps that directions computed from the samples themselves are far off.
    /// Blocks are then twice as wide.
    bool coarse_steps{};
    /// Averages of the finite samples of each block, x fastest. Empty if each block is a single sample.
    std::vector<float> samples{};
    /// Bricks::newest (number of the body's last change) when the averages were made.
    std::uint32_t newest{};

    /// The averages as a grid that lies where the samples of `of` lie, from which they were made. It has no
    /// samples if averages are not needed. Valid until the averages are made again.
    Grid grid(const Grid& of) const;
};

/// Averages of blocks of a grid's samples; empty if each block would be a single sample. `bricks` holds, for
/// each part of a body, the number of the part's last change; null: the samples never change.
BlockAverages make_block_averages(const Grid& grid, const Bricks* bricks = nullptr);

/// Recomputes the averages of the parts of a body that have changed. No allocation.
void update(BlockAverages& averages, const Grid& grid, const Bricks& bricks);

}  // namespace thaum::field
