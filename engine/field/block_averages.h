// field/block_averages.h: averages of blocks of a body's samples, for directions that do not show its steps.
//
// Two kinds of body have steps that are larger than a sample: one whose samples lie farther apart along one axis, as
// slices of a scan do, and one whose samples have few values, as a mask's. Blocks are as wide along each axis as the
// widest spacing, or twice that if slices are twice as far apart as samples or there are few values. So their averages
// are as far apart along all axes and have values in between.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "field/voxels.h"

namespace thaum::field {

/// Averages of blocks of a grid's samples. The first block begins at the first sample; the last ones may hold fewer samples.
struct BlockAverages {
    std::array<int, 3> block{1, 1, 1};  ///< samples of a block along each axis
    std::array<int, 3> count{};         ///< number of blocks along each axis
    /// Averages of the finite samples of each block, x fastest. Empty: each block is a sample.
    std::vector<float> samples{};
    std::uint32_t newest{};  ///< value of Bricks::newest that the averages know

    /// The averages of the blocks of a grid, in its frame; no samples if they are not needed. Valid until they are made
    /// anew.
    Grid grid(const Grid& of) const;
};

/// Averages of a grid's samples; none if its samples need no averages. `bricks` are those of a body that changes.
BlockAverages make_block_averages(const Grid& grid, const Bricks* bricks = nullptr);

/// Computes anew what has changed in a body. No allocation.
void update(BlockAverages& averages, const Grid& grid, const Bricks& bricks);

}  // namespace thaum::field
