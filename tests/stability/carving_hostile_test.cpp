// Hostile tests of carving: numbers that are not finite, huge extents, and long random sequences of edits,
// undo and redo.
#include <gtest/gtest.h>

#include <limits>

#include "field/carving_history.h"
#include "unit/carving_rig.h"

namespace thaum::field {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(CarvingHostile, UndoIsExactUnderTenThousandRandomEdits) {
    Voxels body = random_block({25, 17, 24}, 1);
    body.density[77] = std::numeric_limits<float>::quiet_NaN();
    CarvingHistory history = make_history(body.view(), std::size_t{1} << 30U);
    std::vector<std::uint64_t> hashes{hash_of(body)};  // hashes before the first step and after each step
    const auto end = [&] {
        end_step(history, body.view());
        if (can_redo(history)) return;
        hashes.resize(history.done);
        hashes.push_back(hash_of(body));
    };
    Random random = random_stream(24, 10);
    for (int i = 0; i < 10'000; ++i) {
        const Tool tool = random_tool(random);
        edit(body.view(), tool, random_dab(body, random), history);
        if (random.below(3) != 0) continue;
        end();
        for (auto back = random.below(3); back > 0 && can_undo(history); --back) {
            undo(history, body.view());
            ASSERT_EQ(hash_of(body), hashes[history.done]) << i;
        }
        for (auto forth = random.below(3); forth > 0 && can_redo(history); --forth) {
            redo(history, body.view());
            ASSERT_EQ(hash_of(body), hashes[history.done]) << i;
        }
    }
    end();
    EXPECT_GT(history.steps.size(), 200U);
    while (can_undo(history)) {
        undo(history, body.view());
        ASSERT_EQ(hash_of(body), hashes[history.done]);
    }
    while (can_redo(history)) {
        redo(history, body.view());
        ASSERT_EQ(hash_of(body), hashes[history.done]);
    }
}

TEST(CarvingHostile, UndoIsExactWithLittleMemory) {
    Voxels body = random_block({25, 17, 24}, 2);
    CarvingHistory history = make_history(body.view(), 20 * sizeof(BrickCopy));
    std::vector<std::uint64_t> seen{hash_of(body)};  // hashes of the body after each edit
    Random random = random_stream(24, 11);
    for (int i = 0; i < 3000; ++i) {
        const Tool tool = random_tool(random);
        edit(body.view(), tool, random_dab(body, random), history);
        seen.push_back(hash_of(body));
        if (random.below(3) == 0) end_step(history, body.view());
        if (random.below(10) != 0) continue;
        while (can_undo(history)) {
            undo(history, body.view());
            // However much history was dropped, the body must equal that after some edit, never a mixture of
            // two.
            ASSERT_NE(std::ranges::find(seen, hash_of(body)), seen.end()) << i;
        }
        ASSERT_LE(history.ring.size(), 20U);
    }
}

/// Expects that an edit with this tool and this dab (where and how long the tool is used) does not change the
/// body.
void expect_nothing(const Tool& tool, const Dab& dab) {
    Voxels body = random_block({9, 10, 11}, 3);
    const std::uint64_t before = hash_of(body);
    const Edit e = edit(body.view(), tool, dab);
    EXPECT_EQ(e.voxels, 0U);
    EXPECT_TRUE(e.changed.empty());
    EXPECT_EQ(e.removed + e.added, 0);
    EXPECT_EQ(hash_of(body), before);
    EXPECT_EQ(body.bricks.newest, 1U);
}

TEST(CarvingHostile, DabsThatAreNotFiniteOrOutsideChangeNothing) {
    const Tool filter = density_filter(3, 0.5),
               constant = density_constant(round_extent(ExtentShape::box, 3), 0);
    for (const Tool& tool : {filter, constant}) {
        for (const double bad : {nan, infinity, -infinity, 1e300, -1e300, 5.0}) {
            for (int axis = 0; axis < 3; ++axis) {
                Dab place{.seconds = 0.1}, motion = place, turn = place;
                place.place[axis] = bad;
                expect_nothing(tool, place);
                if (std::isfinite(bad)) continue;
                motion.motion[axis] = bad;
                turn.turn[axis][0] = bad;
                expect_nothing(tool, motion);
                expect_nothing(tool, turn);
            }
        }
    }
    for (const double seconds : {0.0, -1.0, nan, -infinity}) expect_nothing(filter, {.seconds = seconds});
}

TEST(CarvingHostile, ExtentsWithoutASizeChangeNothing) {
    for (const double radius : {0.0, -3.0, nan, infinity}) {
        for (int shape = 0; shape < 5; ++shape) {
            Extent extent = round_extent(static_cast<ExtentShape>(shape), radius);
            extent.stamp = {{1, 1, 1}, {1}};
            expect_nothing(density_constant(extent, 0), {});
        }
    }
    // A stamp, a tool whose extent is given by cells, must have cells. Without any it must change nothing.
    expect_nothing(density_constant(round_extent(ExtentShape::stamp, 3), 0), {});
}

TEST(CarvingHostile, HugeExtentsChangeTheWholeBody) {
    for (const double radius : {1e3, 1e9, 1e100, 1e300}) {
        for (const auto shape : {ExtentShape::sphere, ExtentShape::box, ExtentShape::plate}) {
            for (const bool metres : {false, true}) {
                Voxels body = block({9, 10, 11}, 1);
                Extent extent = round_extent(shape, radius);
                extent.in_metres = metres;
                EXPECT_EQ(edit(body.view(), density_constant(extent, 0), {}).voxels, body.density.size());
            }
        }
        Voxels body = block({9, 10, 11}, 1);
        Tool tool = density_filter(radius, 0, 1e6);
        EXPECT_EQ(edit(body.view(), tool, {.seconds = infinity}).voxels, body.density.size());
        EXPECT_EQ(mass_of(body), 0);
    }
}

TEST(CarvingHostile, HugeNumbersTogetherGiveNoUndefinedResult) {
    const double huge[] = {1e150, 1e300, 1.7e308};
    for (const double spacing : {1e-200, 1.0, 1e100}) {
        for (const double radius : huge) {
            for (const double far : huge) {
                for (int shape = 0; shape < 5; ++shape) {
                    Voxels body = block({9, 10, 11}, 1, spacing);
                    Extent extent = round_extent(static_cast<ExtentShape>(shape), radius);
                    extent.in_metres = far > radius;
                    extent.stamp = {{1, 1, 1}, {1}};
                    edit(body.view(), density_constant(extent, 0),
                         {.place = vec3(far), .motion = vec3(-far)});
                    for (const float density : body.density) ASSERT_TRUE(density >= 0 && density <= 1);
                }
            }
        }
    }
}

TEST(CarvingHostile, ALongMotionIsWalkedInFewSteps) {
    Voxels body = block({40, 9, 9}, 1);
    const Edit e = edit(body.view(), density_filter(0.5, 0), {.motion = {1e6, 0, 0}, .seconds = 1});
    EXPECT_LE(e.voxels, 2U);
}

TEST(CarvingHostile, DensitiesThatAreNotFiniteCanBeCarved) {
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        Voxels melted = block({8, 8, 8}, bad), built = melted;
        edit(melted.view(), density_filter(30, 0), {.seconds = 0.001});
        EXPECT_EQ(mass_of(melted), 0);
        const Edit e = edit(built.view(), density_constant(round_extent(ExtentShape::sphere, 30), 1), {});
        EXPECT_NEAR(mass_of(built), 512e-6, 1e-12);
        EXPECT_NEAR(e.added, 512e-6, 1e-12);
    }
}

TEST(CarvingHostile, MeltingEndsAtEmptyNotAtDenormalNumbers) {
    Voxels body = block({16, 16, 16}, 1);
    const Tool tool = density_filter(20, 0);
    int edits = 0;
    while (mass_of(body) > 0 && edits < 10'000) {
        edit(body.view(), tool, {.seconds = 0.016});
        ++edits;
        for (const float density : body.density) ASSERT_TRUE(density == 0 || density > 1e-7F);
    }
    EXPECT_LT(edits, 1000);
}

TEST(CarvingHostile, DensityStaysBetweenItsOldValueAndTheConstant) {
    Voxels body = random_block({25, 17, 24}, 4);
    Random random = random_stream(24, 12);
    for (int i = 0; i < 2000; ++i) {
        const Tool tool = random_tool(random);
        const Edit e = edit(body.view(), tool, random_dab(body, random));
        EXPECT_TRUE(std::isfinite(e.removed) && std::isfinite(e.added));
    }
    for (const float density : body.density) ASSERT_TRUE(density >= 0 && density <= 1);
}

}  // namespace
}  // namespace thaum::field
