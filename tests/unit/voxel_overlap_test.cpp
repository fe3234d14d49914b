// Tests of the overlap of two bodies of voxels, which is recounted after each edit.
#include "field/voxel_overlap.h"

#include <gtest/gtest.h>

#include <limits>

#include "field/carving_history.h"
#include "unit/carving_rig.h"

namespace thaum::field {
namespace {

TEST(VoxelOverlap, KnownBodiesHaveTheirRatio) {
    Voxels body = block({10, 10, 10}, 0);
    std::vector<float> wanted(1000);
    // Two bodies that are both empty overlap completely, by definition.
    EXPECT_EQ(overlap_with(body.view(), wanted, 0.5F).ratio(), 1);
    std::fill_n(wanted.begin(), 600, 1.0F);
    EXPECT_EQ(overlap_with(body.view(), wanted, 0.5F).ratio(), 0);
    std::fill_n(body.density.begin() + 200, 800, 0.5F);  // densities equal to the threshold
    const VoxelOverlap overlap = overlap_with(body.view(), wanted, 0.5F);
    EXPECT_EQ(overlap.both, 400U);
    EXPECT_EQ(overlap.either, 1000U);
    EXPECT_EQ(overlap.ratio(), 0.4);
}

TEST(VoxelOverlap, CountsAfterEditsAndUndoAreThoseOfAFullCount) {
    Voxels body = random_block({25, 17, 24}, 1);
    const Voxels wanted = random_block({25, 17, 24}, 2);
    CarvingHistory history = make_history(body.view());
    VoxelOverlap overlap = overlap_with(body.view(), wanted.density, 0.5F);
    Random random = random_stream(24, 9);
    const auto expect_full = [&] {
        const VoxelOverlap full = overlap_with(body.view(), wanted.density, 0.5F);
        ASSERT_EQ(overlap.both, full.both);
        ASSERT_EQ(overlap.either, full.either);
        ASSERT_EQ(overlap.inside, full.inside);
    };
    for (int i = 0; i < 300; ++i) {
        const Tool tool = random_tool(random);
        const Edit e = edit(body.view(), tool, random_dab(body, random), history);
        recount(overlap, body.view(), e.changed);
        expect_full();
        if (random.below(3) == 0) end_step(history, body.view());
        if (random.below(5) != 0) continue;
        recount(overlap, body.view(), undo(history, body.view()));
        expect_full();
    }
}

TEST(VoxelOverlap, NaNIsOutside) {
    Voxels body = block({2, 1, 1}, std::numeric_limits<float>::quiet_NaN());
    const std::vector<float> wanted{1, std::numeric_limits<float>::quiet_NaN()};
    const VoxelOverlap overlap = overlap_with(body.view(), wanted, 0.5F);
    EXPECT_EQ(overlap.both, 0U);
    EXPECT_EQ(overlap.either, 1U);
}

}  // namespace
}  // namespace thaum::field
