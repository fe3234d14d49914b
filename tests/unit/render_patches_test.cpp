// Tests of the patches of a large mesh: no visible patch is left out, near patches come first, and its
// coarser copy is drawn only where nobody can see a difference.
#include "render/detail/patches.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "core/random.h"

namespace thaum::render::detail {
namespace {

const fvec3 grey(0.5F);

/// A viewer who looks along -z, with a field of view of 90 degrees that is 720 pixels high.
Sight sight_from(fvec3 eye) {
    const float half = 0.7853982F;
    const auto to_clip = glm::perspective(2 * half, 1.0F, 0.1F, 1000.0F) * glm::translate(fmat4(1), -eye);
    return {to_clip, eye, 2 * std::tan(half) / 720};
}

std::vector<std::uint32_t> chosen(const PatchTable& table, const Sight& sight) {
    std::vector<std::uint32_t> out;
    PatchOrder order;
    choose_patches(table, sight, order, out);
    return out;
}

/// A square that crosses the z axis at z, with sides of 2 x `half`. It faces +z.
MeshData sheet(float z, float half = 1) {
    return transformed(grid({half, half}, 1, 1, grey),
                       translated({0, 0, z}) * rotated({1, 0, 0}, 1.5707963F));
}

TEST(Patches, HaveAllTheirTrianglesAndTheFullOnesFirst) {
    const auto all =
        joined({{.full = box(fvec3(1), grey, 0.1F), .plain = box(fvec3(1), grey), .detail = 0.1F},
                {.full = sheet(-3)}});
    EXPECT_EQ(all.table.full_count, 3U * (44 + 2));
    EXPECT_EQ(all.table.indices.size(), 3U * (44 + 2 + 12));
    EXPECT_EQ(all.mesh.indices, all.table.indices);
    EXPECT_EQ(all.table.patches[1].plain.count, 0U);
    for (const auto index : all.table.indices) EXPECT_LT(index, all.mesh.vertices.size());
}

TEST(Patches, PlainOnlyIfTheMissingDetailIsBelowAPixelAndHasFaded) {
    const Patch patch{.full = box(fvec3(1), grey, 0.1F), .plain = box(fvec3(1), grey), .detail = 0.1F};
    const auto table = joined({patch}).table;
    const auto triangles = [&](float distance) {
        return chosen(table, sight_from({0, 0, distance})).size() / 3;
    };
    const auto sight = sight_from(fvec3(0));
    const float fine = 0.1F / sight.pixel_angle, gone = fading_of(sight.pixel_angle).gone;
    ASSERT_GT(fine, gone);
    EXPECT_EQ(triangles(3), 44U);
    EXPECT_EQ(triangles(fine), 44U);
    EXPECT_EQ(triangles(fine + 4), 12U);
    // A patch without a coarser copy must fade as well.
    const auto finest = joined({{patch.full, patch.plain, 0}}).table;
    EXPECT_EQ(chosen(finest, sight_from({0, 0, gone})).size() / 3, 44U);
    EXPECT_EQ(chosen(finest, sight_from({0, 0, gone + 4})).size() / 3, 12U);
    EXPECT_EQ(chosen(joined({{.full = patch.full}}).table, sight_from({0, 0, 300})).size() / 3, 44U);
}

TEST(Patches, NearOnesFirstAndSmallOnesBeforeASheetAroundThem) {
    const auto table = joined({{.full = sheet(-20)}, {.full = sheet(-9, 50)}, {.full = sheet(-10)}}).table;
    const auto indices = chosen(table, sight_from(fvec3(0)));
    ASSERT_EQ(indices.size(), 18U);
    EXPECT_EQ(indices[0] / 4, 2U);
    EXPECT_EQ(indices[6] / 4, 0U);
    EXPECT_EQ(indices[12] / 4, 1U);
}

TEST(Patches, PatchesInPermanentShadeAreSeparate) {
    const auto table =
        joined({{.full = sheet(-5), .sunless = true}, {.full = sheet(-9)}, {.full = sheet(-7)}}).table;
    std::vector<std::uint32_t> out(2);
    PatchOrder order;
    const auto all = choose_patches(table, sight_from(fvec3(0)), order, out);
    EXPECT_EQ(all.sunlit.first, 2U);
    EXPECT_EQ(all.sunlit.count, 12U);
    EXPECT_EQ(out[2] / 4, 2U) << "near first within each";
    EXPECT_EQ(all.sunless.first, 14U);
    EXPECT_EQ(all.sunless.count, 6U);
    EXPECT_EQ(all.all().count, 18U);
}

TEST(Patches, PatchesOutOfViewOrFacingAwayAreLeftOut) {
    const auto table = joined({{.full = sheet(-5)}}).table;
    EXPECT_EQ(chosen(table, sight_from(fvec3(0))).size(), 6U);
    EXPECT_TRUE(chosen(table, sight_from({0, 0, -10})).empty()) << "behind the eye";
    EXPECT_TRUE(chosen(table, sight_from({9, 0, 0})).empty()) << "to the left of the view";
    const auto turned = joined({{.full = transformed(sheet(5), rotated({0, 1, 0}, 3.1415927F))}}).table;
    EXPECT_TRUE(chosen(turned, sight_from(fvec3(0))).empty()) << "seen from behind";
}

TEST(Patches, PlainOnlyPatchesAreDrawnWhereDetailIsBelowAPixel) {
    const auto table = joined({{.full = {}, .plain = sheet(-5), .detail = 0.05F}}).table;
    EXPECT_EQ(table.full_count, 0U);
    auto sight = sight_from(fvec3(0));
    sight.pixel_angle = 0.001F;
    EXPECT_TRUE(chosen(table, sight).empty()) << "all in front is drawn in full";
    sight.pixel_angle = 0.05F;
    EXPECT_EQ(chosen(table, sight).size(), 6U);
}

TEST(Patches, PlainPatchesComeAfterFullOnes) {
    const auto beside = transformed(sheet(-10), translated({1.5F, 0, 0}));
    const auto table =
        joined({{.full = {}, .plain = sheet(-10.05F), .detail = 0.05F}, {.full = beside}}).table;
    auto sight = sight_from(fvec3(0));
    sight.pixel_angle = 0.05F;
    const auto indices = chosen(table, sight);
    ASSERT_EQ(indices.size(), 12U);
    EXPECT_LT(indices[0], 4U) << "all that is full has the first vertices";
    EXPECT_GE(indices[6], 4U);
}

TEST(Patches, NoFrontIsEverTakenForABack) {
    Random random = random_stream(5, 1);
    const auto any = [&](double low, double high) { return static_cast<float>(random.uniform(low, high)); };
    int left_out = 0;
    for (int round = 0; round < 400; ++round) {
        // A square with dents, in which normals differ.
        MeshData mesh = grid({1, 1}, 3, 3, grey);
        for (auto& v : mesh.vertices) v.position.y += any(-0.3, 0.3);
        // A random eye with the whole square in view.
        const fvec3 eye(any(-6, 6), any(-6, 6), any(4, 9));
        const fvec3 axis = glm::normalize(fvec3(any(-1, 1), any(-1, 1), any(-1, 1)) + fvec3(0, 0, 1e-3F));
        const auto there = transformed(mesh, rotated(axis, any(-3, 3)));
        auto sight = sight_from(eye);
        sight.to_clip = glm::ortho(-50.0F, 50.0F, -50.0F, 50.0F, -50.0F, 50.0F);
        const bool seen = !chosen(joined({{.full = there}}).table, sight).empty();
        left_out += seen ? 0 : 1;
        if (seen) continue;
        for (std::size_t i = 0; i < there.indices.size(); i += 3) {
            const auto at = [&](std::size_t k) { return there.vertices[there.indices[i + k]].position; };
            const fvec3 normal = glm::cross(at(1) - at(0), at(2) - at(0));
            EXPECT_GE(glm::dot(normal, at(0) - eye), -1e-4F) << "round " << round;
        }
    }
    EXPECT_GT(left_out, 40) << "the random cases must include this case";
}

}  // namespace
}  // namespace thaum::render::detail
