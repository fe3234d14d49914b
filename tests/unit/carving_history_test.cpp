// Tests of undo and redo of edits to a body of voxels.
#include "field/carving_history.h"

#include <gtest/gtest.h>

#include "unit/carving_rig.h"

namespace thaum::field {
namespace {

constexpr std::size_t copy_bytes = sizeof(BrickCopy);

/// A solid body of 3 x 3 x 3 bricks (blocks of 8 x 8 x 8 voxels) with a history.
struct Rig {
    Voxels body = block({24, 24, 24}, 1);
    CarvingHistory history;

    explicit Rig(std::size_t copies = 1000) : history(make_history(body.view(), copies * copy_bytes)) {}

    /// Changes the middle voxel of a brick and nothing else.
    Edit carve(int i, int j, int k, double density = 0) {
        const Tool tool = density_constant(round_extent(ExtentShape::sphere, 1.5), density);
        return edit(body.view(), tool, {.place = place_of(body, 8.0 * vec3(i, j, k) + 3.5)}, history);
    }
    void carve_step(int i, int j, int k, double density = 0) {
        carve(i, j, k, density);
        end_step(history, body.view());
    }
};

TEST(CarvingHistory, AStrokeOfManyEditsIsOneStep) {
    Rig rig;
    const std::uint64_t start = hash_of(rig.body);
    rig.carve(0, 0, 0);
    rig.carve(0, 0, 0, 0.5);
    rig.carve(1, 2, 0);
    end_step(rig.history, rig.body.view());
    const std::uint64_t carved = hash_of(rig.body);
    EXPECT_EQ(undo(rig.history, rig.body.view()), (VoxelBox{{0, 0, 0}, {16, 24, 8}}));
    EXPECT_EQ(hash_of(rig.body), start);
    EXPECT_FALSE(can_undo(rig.history));
    EXPECT_EQ(redo(rig.history, rig.body.view()), (VoxelBox{{0, 0, 0}, {16, 24, 8}}));
    EXPECT_EQ(hash_of(rig.body), carved);
    EXPECT_FALSE(can_redo(rig.history));
}

TEST(CarvingHistory, UndoEndsAnOpenStep) {
    Rig rig;
    const std::uint64_t start = hash_of(rig.body);
    rig.carve(1, 1, 1);
    undo(rig.history, rig.body.view());
    EXPECT_EQ(hash_of(rig.body), start);
    EXPECT_TRUE(can_redo(rig.history));
}

TEST(CarvingHistory, WithoutAStepNothingHappens) {
    Rig rig;
    EXPECT_TRUE(undo(rig.history, rig.body.view()).empty());
    EXPECT_TRUE(redo(rig.history, rig.body.view()).empty());
    EXPECT_EQ(rig.body.bricks.newest, 1U);
}

TEST(CarvingHistory, AStrokeThatChangesNothingIsNoStep) {
    Rig rig;
    rig.carve_step(0, 0, 0);
    rig.carve_step(0, 0, 0);  // carves with the same constant again, which changes nothing
    rig.carve_step(9, 9, 9);  // a place outside of the body
    EXPECT_EQ(rig.history.steps.size(), 1U);
    EXPECT_EQ(rig.history.next, 1U);
}

TEST(CarvingHistory, OnlyChangedBricksAreStored) {
    Rig rig;
    const Tool tool = density_constant(round_extent(ExtentShape::sphere, 4.4), 0);
    const VoxelBox most = reach(rig.body.view(), tool, {.place = place_of(rig.body, vec3(11.5))});
    EXPECT_EQ(bricks_around(most), (VoxelBox{{0, 0, 0}, {3, 3, 3}}));
    const Edit e = edit(rig.body.view(), tool, {.place = place_of(rig.body, vec3(11.5))}, rig.history);
    end_step(rig.history, rig.body.view());
    EXPECT_LT(e.bricks, 27U);
    EXPECT_EQ(rig.history.next, e.bricks);
}

TEST(CarvingHistory, ANewEditForgetsWhatCouldBeRedone) {
    Rig rig;
    rig.carve_step(0, 0, 0);
    rig.carve_step(1, 0, 0);
    undo(rig.history, rig.body.view());
    rig.carve_step(2, 0, 0);
    EXPECT_FALSE(can_redo(rig.history));
    EXPECT_EQ(rig.history.steps.size(), 2U);
}

TEST(CarvingHistory, AStrokeInTheAirKeepsWhatCanBeRedone) {
    Rig rig;
    rig.carve_step(0, 0, 0);
    rig.carve_step(1, 0, 0);
    const std::uint64_t carved = hash_of(rig.body);
    undo(rig.history, rig.body.view());
    rig.carve(0, 0, 0);  // an edit without effect, because the brick is already carved
    EXPECT_TRUE(can_redo(rig.history));
    end_step(rig.history, rig.body.view());
    rig.carve_step(0, 0, 0);
    ASSERT_TRUE(can_redo(rig.history));
    redo(rig.history, rig.body.view());
    EXPECT_EQ(hash_of(rig.body), carved);
    EXPECT_FALSE(can_redo(rig.history));
    EXPECT_TRUE(can_undo(rig.history));
}

TEST(CarvingHistory, AStrokeThatChangesSomethingLateForgetsWhatCouldBeRedone) {
    for (const std::size_t room : {4U, 1000U}) {
        Rig rig(room);
        rig.carve_step(0, 0, 0);
        const std::uint64_t one = hash_of(rig.body);
        rig.carve_step(1, 0, 0);
        undo(rig.history, rig.body.view());
        rig.carve(0, 0, 0);  // an edit without effect, because the brick is already carved
        rig.carve(0, 2, 0);
        EXPECT_FALSE(can_redo(rig.history));
        rig.carve(2, 2, 0);
        end_step(rig.history, rig.body.view());
        EXPECT_FALSE(can_redo(rig.history));
        undo(rig.history, rig.body.view());
        EXPECT_EQ(hash_of(rig.body), one) << "room for " << room;
    }
}

TEST(CarvingHistory, TheOldestStepsAreForgottenWhenMemoryRunsOut) {
    Rig rig(3);
    for (int i = 0; i < 3; ++i) rig.carve_step(i, 0, 0);
    const std::uint64_t three = hash_of(rig.body);
    rig.carve_step(0, 1, 0);
    rig.carve_step(1, 1, 0);
    EXPECT_EQ(rig.history.steps.size(), 3U);
    EXPECT_EQ(rig.history.ring.size(), 3U);
    undo(rig.history, rig.body.view());
    undo(rig.history, rig.body.view());
    EXPECT_EQ(hash_of(rig.body), three);
    undo(rig.history, rig.body.view());
    EXPECT_FALSE(can_undo(rig.history));
    for (int i = 0; i < 3; ++i) redo(rig.history, rig.body.view());
    EXPECT_FALSE(can_redo(rig.history));
}

TEST(CarvingHistory, OfAStrokeThatIsTooLongTheBeginningIsForgotten) {
    Rig rig(3);
    rig.carve_step(2, 2, 2);
    rig.carve(0, 0, 0);
    rig.carve(1, 0, 0);
    rig.carve(2, 0, 0);
    const std::uint64_t middle = hash_of(rig.body);
    rig.carve(0, 1, 0);
    rig.carve(1, 1, 0);
    undo(rig.history, rig.body.view());
    EXPECT_EQ(hash_of(rig.body), middle);
    EXPECT_FALSE(can_undo(rig.history));
}

TEST(CarvingHistory, AnEditLargerThanTheMemoryCannotBeUndone) {
    Rig rig(3);
    rig.carve_step(0, 0, 0);
    edit(rig.body.view(), density_constant(round_extent(ExtentShape::sphere, 30), 0.5), {}, rig.history);
    const std::uint64_t current = hash_of(rig.body);
    EXPECT_TRUE(undo(rig.history, rig.body.view()).empty());
    EXPECT_EQ(hash_of(rig.body), current);
    rig.carve_step(1, 0, 0);  // the history can still be used afterwards
    undo(rig.history, rig.body.view());
    EXPECT_EQ(hash_of(rig.body), current);
}

TEST(CarvingHistory, UndoGivesNewVersionsToItsBricksAlone) {
    Rig rig;
    rig.carve_step(1, 0, 0);
    const std::vector<std::uint32_t> before = rig.body.bricks.version;
    BrickHashes kept;
    voxel_hash(rig.body.view(), kept);
    undo(rig.history, rig.body.view());
    for (std::size_t i = 0; i < before.size(); ++i)
        EXPECT_EQ(rig.body.bricks.version[i] != before[i], i == 1);
    EXPECT_EQ(voxel_hash(rig.body.view(), kept), hash_of(rig.body));
}

TEST(CarvingHistory, AHistoryOfAnotherBodyIsOurMistake) {
    Rig rig;
    Voxels other = block({8, 8, 8}, 1);
    EXPECT_DEATH(keep(rig.history, other.view(), {{0, 0, 0}, {1, 1, 1}}), "a history of another body");
}

}  // namespace
}  // namespace thaum::field
