// Tests of edits: which voxels, bricks (blocks of voxels) and properties a tool changes.
#include "field/carving.h"

#include <gtest/gtest.h>

#include "unit/allocations.h"
#include "unit/carving_rig.h"

namespace thaum::field {
namespace {

/// Compares the result that an edit reports with the voxels that really differ from the body before the edit.
void expect_exact(const Edit& e, Voxels& before, Voxels& after) {
    VoxelBox box;
    std::size_t voxels = 0, bricks = 0;
    for_each_brick(after.bricks, {{}, after.bricks.count}, [&](std::array<int, 3> brick, std::size_t number) {
        const VoxelBox all = brick_box(after.count, brick);
        std::size_t here = 0;
        for (int k = all.low[2]; k < all.high[2]; ++k) {
            for (int j = all.low[1]; j < all.high[1]; ++j) {
                for (int i = all.low[0]; i < all.high[0]; ++i) {
                    if (!differs(before, after, after.view().at(i, j, k))) continue;
                    box = around(box, {{i, j, k}, {i + 1, j + 1, k + 1}});
                    ++here;
                }
            }
        }
        voxels += here;
        bricks += here > 0 ? 1 : 0;
        EXPECT_EQ(after.bricks.version[number] != before.bricks.version[number], here > 0);
    });
    EXPECT_EQ(e.changed, box);
    EXPECT_EQ(e.voxels, voxels);
    EXPECT_EQ(e.bricks, bricks);
}

TEST(Carving, AnEditReportsExactlyWhatItChanged) {
    Voxels body = random_block({25, 17, 24}, 1);
    Random random = random_stream(24, 5);
    for (int i = 0; i < 300; ++i) {
        Voxels before = body;
        const Tool tool = random_tool(random);
        const Dab dab = random_dab(body, random);
        const VoxelBox most = reach(body.view(), tool, dab);
        const Edit e = edit(body.view(), tool, dab);
        expect_exact(e, before, body);
        EXPECT_EQ(around(most, e.changed), most) << i;
    }
}

TEST(Carving, AConstantAppliedAgainChangesNothing) {
    for (const auto shape : {ExtentShape::sphere, ExtentShape::box, ExtentShape::plate}) {
        for (const double constant : {0.0, 0.63, 1.0}) {
            Voxels body = random_block({20, 20, 20}, 2);
            const Tool tool = density_constant(round_extent(shape, 4.3), constant);
            EXPECT_GT(edit(body.view(), tool, {}).voxels, 100U);
            EXPECT_EQ(edit(body.view(), tool, {}).voxels, 0U);
        }
    }
}

TEST(Carving, ADabAtTheCornerOfBricksChangesAllEight) {
    Voxels body = block({16, 16, 16}, 1);
    const Edit e = edit(body.view(), density_filter(2, 0), {.seconds = 1});
    EXPECT_EQ(e.bricks, 8U);
    EXPECT_EQ(e.changed, (VoxelBox{{6, 6, 6}, {10, 10, 10}}));
    EXPECT_EQ(body.bricks.newest, 2U);
}

TEST(Carving, BodiesSmallerThanABrickAreCarved) {
    Voxels body = block({1, 3, 2}, 1);
    const Edit e = edit(body.view(), density_constant(round_extent(ExtentShape::sphere, 20), 0), {});
    EXPECT_EQ(e.voxels, 6U);
    EXPECT_EQ(mass_of(body), 0);
}

TEST(Carving, EditsThatDoNotOverlapMayChangePlaces) {
    Random random = random_stream(24, 6);
    for (int round = 0; round < 50; ++round) {
        Voxels first = random_block({40, 16, 16}, 3), second = first;
        const Tool left = random_tool(random), right = random_tool(random);
        Dab a = random_dab(first, random), b = random_dab(first, random);
        a.motion = b.motion = {};
        a.place = place_of(first, {9, 8, 8});
        b.place = place_of(first, {30, 8, 8});
        edit(first.view(), left, a);
        edit(first.view(), right, b);
        edit(second.view(), right, b);
        edit(second.view(), left, a);
        EXPECT_EQ(hash_of(first), hash_of(second));
    }
}

TEST(Carving, TheSizeOfTheBodyDoesNotChangeTheEdit) {
    Voxels small = block({32, 32, 32}, 1), large = block({96, 96, 96}, 1);
    const Tool tool = density_filter(5, 0);
    const Dab dab{.place = vec3(0.003), .seconds = 0.1};
    const Edit a = edit(small.view(), tool, dab), b = edit(large.view(), tool, dab);
    EXPECT_EQ(a.voxels, b.voxels);
    EXPECT_EQ(a.bricks, b.bricks);
    EXPECT_EQ(a.removed, b.removed);
}

TEST(Carving, AnInvisibleSkinKeepsItsDensity) {
    Voxels body = block({16, 16, 16}, 0.8F);
    const Tool tool{
        "invisibility",
        {{.extent = round_extent(ExtentShape::sphere, 4), .changes = {.material = true}, .material = 1}}};
    const double mass = mass_of(body);
    const Edit e = edit(body.view(), tool, {});
    EXPECT_EQ(e.removed + e.added, 0);
    EXPECT_EQ(mass_of(body), mass);
    EXPECT_EQ(std::ranges::count(body.material, 1), static_cast<std::ptrdiff_t>(e.voxels));
    EXPECT_NEAR(static_cast<double>(e.voxels), 4 * pi / 3 * 64, 20);
}

TEST(Carving, AnAnnotationStaysOnTheSurface) {
    Voxels body = block({16, 16, 16}, 0);
    for_each_row(body.view(), {{0, 0, 0}, {16, 16, 8}}, [&](std::size_t first, std::size_t) {
        std::fill_n(body.density.begin() + static_cast<std::ptrdiff_t>(first), 16, 1.0F);
    });
    const Tool tool{"annotate",
                    {{.extent = round_extent(ExtentShape::sphere, 5),
                      .changes = {.colour = true, .material = true},
                      .colour = {9, 8, 7},
                      .material = 3,
                      .surface_only = true}}};
    const Edit e = edit(body.view(), tool, {});
    EXPECT_EQ(e.changed.low[2], 7);  // the surface lies between layers 7 and 8
    EXPECT_EQ(e.changed.high[2], 9);
    EXPECT_EQ(body.material[body.view().at(8, 8, 7)], 3);
    EXPECT_EQ(body.colour[body.view().at(8, 8, 8)], (Rgb8{9, 8, 7}));
    EXPECT_EQ(body.material[body.view().at(8, 8, 9)], 0);
    body.surface = 2;  // with this value no voxel is inside the surface
    EXPECT_EQ(edit(body.view(), tool, {.place = {0, 0, 0.02}}).voxels, 0U);
}

TEST(Carving, AStampOfAPartGivesThePartBack) {
    Voxels body = random_block({12, 12, 12}, 4), copy = block({20, 20, 20}, 0);
    const Stamp stamp = stamp_of(body.view(), {{2, 3, 4}, {7, 6, 8}});
    ASSERT_EQ(stamp.cells, (std::array{5, 3, 4}));
    const Extent extent{.shape = ExtentShape::stamp, .half = {2.5, 1.5, 2}, .stamp = stamp};
    const Tool tool = density_constant(extent, 1);
    edit(copy.view(), tool,
         {.place = place_of(copy, {12, 11, 9.5})});  // the middle of the box of voxels 10-14, 10-12, 8-11
    for (int k = 0; k < 4; ++k) {
        for (int j = 0; j < 3; ++j) {
            for (int i = 0; i < 5; ++i) {
                EXPECT_NEAR(copy.density[copy.view().at(10 + i, 10 + j, 8 + k)],
                            body.density[body.view().at(2 + i, 3 + j, 4 + k)], 1e-6);
            }
        }
    }
    EXPECT_EQ(copy.density[copy.view().at(9, 11, 9)], 0);
    EXPECT_EQ(copy.density[copy.view().at(15, 11, 9)], 0);
}

TEST(Carving, AQuickStrokeLeavesNoGap) {
    Voxels body = block({60, 12, 12}, 1);
    const Tool tool = density_filter(3, 0, 40);
    edit(body.view(), tool, {.place = place_of(body, {54, 5.5, 5.5}), .motion = {0.48, 0, 0}, .seconds = 1});
    const float middle = body.density[body.view().at(30, 5, 5)];
    EXPECT_LT(middle, 0.25);
    for (int i = 12; i < 49; ++i) EXPECT_NEAR(body.density[body.view().at(i, 5, 5)], middle, 0.01) << i;
}

TEST(Carving, ACutGoesThroughAlongTheMotion) {
    Voxels body = block({40, 24, 24}, 1);
    const Tool tool = density_constant({.shape = ExtentShape::plate, .half = {1, 30, 1}}, 0);
    // The blade stands along y and moves along x: the slot is thin along z.
    const Edit e = edit(body.view(), tool, {.place = place_of(body, {35, 12, 11}), .motion = {0.30, 0, 0}});
    // The change reaches one voxel beyond the path on each side, half-way into the tool's soft edge.
    EXPECT_EQ(e.changed, (VoxelBox{{4, 0, 10}, {37, 24, 13}}));
    for (int i = 5; i <= 35; ++i) {
        for (int j = 0; j < 24; ++j) {
            EXPECT_EQ(body.density[body.view().at(i, j, 11)], 0);
            EXPECT_EQ(body.density[body.view().at(i, j, 9)], 1);
            EXPECT_EQ(body.density[body.view().at(i, j, 13)], 1);
        }
    }
}

TEST(Carving, EveryBuildGivesTheSameBits) {
    Voxels body = random_block({25, 17, 24}, 6);
    Random random = random_stream(24, 15);
    for (int i = 0; i < 500; ++i) {
        const Tool tool = random_tool(random);
        edit(body.view(), tool, random_dab(body, random));
    }
    EXPECT_EQ(hash_of(body), 0xb23435e9cac81844U);
}

TEST(Carving, AnEditDoesNotAllocate) {
    Voxels body = random_block({40, 40, 40}, 5);
    Random random = random_stream(24, 14);
    std::size_t changed = 0;
    for (int i = 0; i < 100; ++i) {
        const Tool tool = random_tool(random);
        const Dab dab = random_dab(body, random);
        const std::size_t before = test::allocations();
        changed += edit(body.view(), tool, dab).voxels;
        ASSERT_EQ(test::allocations(), before) << i;
    }
    EXPECT_GT(changed, 1000U);
}

TEST(Carving, TwoOperationsOfOnePropertyAreOurMistake) {
    Voxels body = block({8, 8, 8}, 1);
    Tool tool = density_filter(3, 0);
    tool.operations.push_back(tool.operations[0]);
    EXPECT_DEATH(edit(body.view(), tool, {.seconds = 1}),
                 "two operations of a carving tool change one property");
}

}  // namespace
}  // namespace thaum::field
