// Tests of reduced detail that no viewer can see: coarser copies of meshes, and the sky behind walls.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/random.h"
#include "render/detail/batches.h"
#include "render/detail/hidden.h"
#include "render/detail/simplify.h"
#include "render/detail/sky_cells.h"

namespace thaum::render {
namespace {

const fvec3 any_colour(0.4F);

std::size_t triangles(const MeshData& mesh) { return mesh.indices.size() / 3; }

TEST(Clustered, CellsSmallerThanAnythingLeaveAllAsItWas) {
    const auto mesh = sphere(1, 12, any_colour);
    const auto same = clustered(mesh, 1e-3F);
    EXPECT_EQ(triangles(same.mesh), triangles(mesh));
    EXPECT_LT(same.error, 2e-3F);
}

TEST(Clustered, ABevelGoesAndTheBoxStays) {
    const auto copy = clustered(box(fvec3(1), any_colour, 0.05F), 0.3F);
    EXPECT_EQ(triangles(copy.mesh), 12U);
    // In each corner three vertices are merged into one: the first of those farthest out.
    EXPECT_NEAR(copy.error, 0.05F * std::sqrt(2.0F), 1e-5F);
    EXPECT_NEAR(bounds(copy.mesh).radius, bounds(box(fvec3(1), any_colour, 0.05F)).radius, 0.05F);
}

TEST(Clustered, NoVertexMovesFartherThanTheErrorSays) {
    const auto mesh = sphere(1, 20, any_colour);
    for (const float cell : {0.1F, 0.3F, 0.7F}) {
        const auto copy = clustered(mesh, cell);
        EXPECT_LE(copy.error, cell * std::sqrt(3.0F) + 1e-5F);
        // The remaining vertices still lie on the sphere, near their old positions.
        for (const auto& v : copy.mesh.vertices) EXPECT_NEAR(glm::length(v.position), 1, 1e-5F);
        for (const auto& v : copy.mesh.vertices)
            EXPECT_LE(glm::distance(v.position, v.normal), copy.error + 0.35F)
                << "normals must stay those of the full mesh";
    }
}

TEST(Clustered, OddMeshesDoNoHarm) {
    EXPECT_TRUE(clustered({}, 1).mesh.indices.empty());
    EXPECT_TRUE(coarser_copies({}).empty());
    auto mesh = sphere(1, 12, any_colour);
    mesh.vertices[3].position.x = std::numeric_limits<float>::infinity();
    EXPECT_TRUE(coarser_copies(mesh).empty());
    EXPECT_TRUE(clustered(box(fvec3(1), any_colour), 100).mesh.indices.empty()) << "all in one cell";
}

TEST(CoarserCopies, EachHasFewerTrianglesAndAGreaterError) {
    const auto mesh = sphere(2, 24, any_colour);
    const auto copies = coarser_copies(mesh);
    ASSERT_GE(copies.size(), 3U);
    std::size_t last = triangles(mesh);
    for (const auto& copy : copies) {
        EXPECT_LE(4 * triangles(copy.mesh), 3 * last);
        EXPECT_GT(triangles(copy.mesh), 0U);
        last = triangles(copy.mesh);
    }
    EXPECT_LT(copies.front().error, copies.back().error);
    EXPECT_TRUE(coarser_copies(box(fvec3(1), any_colour)).empty());
}

/// The mesh that is drawn for an instance whose mesh has the coarser copies `levels`, at a distance along the
/// view direction (m).
MeshId drawn_at(float distance, const detail::Levels& levels, float scale = 1) {
    const std::vector<Bounds> bounds(4, Bounds{fvec3(0), 1});
    const std::vector<detail::Levels> all{levels, {}, {}, {}};
    const Camera camera{.position = {0, 0, 0}};
    const fmat4 matrix = detail::projection_matrix(camera, 1) * detail::view_matrix(camera);
    const Instance instance{.mesh = 0, .model = translated({0, 0, -distance}) * scaled(fvec3(scale))};
    detail::Batches out;
    detail::collect({&instance, 1}, {bounds, all}, {matrix, fvec3(0), 0.01F}, out);
    EXPECT_EQ(out.batches.size(), 1U);
    return out.batches.at(0).mesh;
}

TEST(Levels, TheCoarsestWhoseErrorIsWithinAPixel) {
    const detail::Levels levels{{1, 0.05F}, {2, 0.2F}, {3, 0.8F}};
    // A pixel is 1 cm wide at a distance of 1 m. The mesh's nearest point is 1 m nearer than its middle.
    EXPECT_EQ(drawn_at(5.9F, levels), 0U);
    EXPECT_EQ(drawn_at(6.1F, levels), 1U);
    EXPECT_EQ(drawn_at(20.9F, levels), 1U);
    EXPECT_EQ(drawn_at(21.1F, levels), 2U);
    EXPECT_EQ(drawn_at(200, levels), 3U);
    EXPECT_EQ(drawn_at(0.5F, levels), 0U) << "around the eye";
    EXPECT_EQ(drawn_at(21.1F, levels, 2), 1U) << "a larger thing must stay detailed for longer";
    EXPECT_EQ(drawn_at(200, {}), 0U);
}

/// Number of cells in which sky may be visible; the code under test gives them as runs of cells.
int open_cells(const Camera& camera, std::span<const Block> blocks) {
    detail::SkyCells cells;
    detail::open_sky_cells(camera, 2, blocks, cells);
    EXPECT_EQ(cells.firsts.size(), cells.counts.size());
    int corners = 0;
    for (const auto count : cells.counts) corners += count;
    EXPECT_EQ(corners % detail::corners_of_sky_cell, 0);
    return corners / detail::corners_of_sky_cell;
}

TEST(SkyCells, CellsCoveredByABlockAreLeftOut) {
    constexpr int all = detail::sky_columns * detail::sky_rows;
    const Camera camera{.position = {0, 0, 0}};
    const auto wall = [](double low, double high) { return Block{{-100, low, -11}, {100, high, -10}}; };
    const auto open = [&](Block block) { return open_cells(camera, {&block, 1}); };
    EXPECT_EQ(open_cells(camera, {}), all);
    EXPECT_EQ(open(wall(-100, 100)), 0);
    EXPECT_EQ(open(wall(-100, 0)), all / 2) << "up to the middle of the picture";
    EXPECT_EQ(open({{-100, -100, 10}, {100, 100, 11}}), all) << "behind the eye";
    EXPECT_EQ(open({{-1, -1, -1}, {1, 1, 1}}), all) << "around the eye";
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_GE(open({vec3(nan), vec3(nan)}), 0);
    const std::vector<Block> many(100, wall(-100, 100));
    EXPECT_EQ(open_cells(camera, many), 0);
}

TEST(SkyCells, NoRayToTheSkyGoesThroughACellThatIsLeftOut) {
    Random random = random_stream(3, 9);
    const auto any = [&](double low, double high) { return random.uniform(low, high); };
    int left_out = 0;
    for (int round = 0; round < 60; ++round) {
        std::vector<Block> blocks;
        for (int i = 0; i < 6; ++i) {
            const vec3 at(any(-20, 20), any(-20, 20), any(-20, 20)), half(any(1, 15), any(1, 15), any(1, 15));
            blocks.push_back({at - half, at + half});
        }
        Camera camera{.position = fvec3(0)};
        camera.orientation = fquat(quat(vec3(any(-1, 1), any(-3, 3), 0)));
        detail::SkyCells cells;
        detail::open_sky_cells(camera, 2, blocks, cells);
        const auto is_open = [&](int cell) {
            for (std::size_t i = 0; i < cells.firsts.size(); ++i) {
                const int first = cell * detail::corners_of_sky_cell;
                if (first >= cells.firsts[i] && first < cells.firsts[i] + cells.counts[i]) return true;
            }
            return false;
        };
        const float high = std::tan(camera.fov_y / 2);
        for (int ray = 0; ray < 200; ++ray) {
            const double x = any(0, 1), y = any(0, 1);
            const int cell = static_cast<int>(y * detail::sky_rows) * detail::sky_columns +
                             static_cast<int>(x * detail::sky_columns);
            if (is_open(cell)) continue;
            ++left_out;
            const auto right = static_cast<float>(2 * x - 1), up = static_cast<float>(2 * y - 1);
            const vec3 way(camera.orientation * fvec3(right * high * 2, up * high, -1));
            EXPECT_TRUE(std::any_of(blocks.begin(), blocks.end(),
                                    [&](const Block& b) { return meets(b, vec3(camera.position), way); }));
        }
    }
    EXPECT_GT(left_out, 500) << "the random cases must include this case";
}

bool hides(const Block& block, vec3 eye, fvec3 centre, fvec3 half) {
    std::vector<detail::Hidden> hidden;
    detail::add_hidden({&block, 1}, eye, hidden);
    return detail::is_hidden(hidden, centre, half);
}

TEST(Hidden, BehindAWallUpToItsOutline) {
    const Block wall{{-2, -2, -5}, {2, 2, -4}};
    const auto at = [&](fvec3 centre) { return hides(wall, vec3(0), centre, fvec3(0.5F)); };
    EXPECT_TRUE(at({0, 0, -6}));
    EXPECT_TRUE(at({0, 0, -100}));
    EXPECT_FALSE(at({0, 0, -3})) << "in front of the block";
    EXPECT_FALSE(at({0, 0, 6})) << "behind the eye";
    // The block's face at z = -4 hides the places behind it with |x| < -z / 2. The near side of a box of half
    // size 0.5 at z = -10 is at z = -9.5, where |x| < 4.75 is hidden.
    EXPECT_TRUE(at({4.2F, 0, -10}));
    EXPECT_FALSE(at({4.3F, 0, -10}));
    EXPECT_FALSE(hides(wall, {0, 0, -4.5}, {0, 0, -6}, fvec3(0.5F))) << "the eye inside the block";
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(hides({vec3(nan), vec3(nan)}, vec3(0), {0, 0, -6}, fvec3(0.5F)));
    EXPECT_FALSE(hides({{-2, -2, -5}, {2, nan, -4}}, vec3(0), {0, 0, -6}, fvec3(0.5F)));
    EXPECT_FALSE(hides(wall, vec3(nan), {0, 0, -6}, fvec3(0.5F)));
    EXPECT_FALSE(at(fvec3(std::numeric_limits<float>::quiet_NaN())));
}

TEST(Hidden, HiddenBoxesHaveNoFreeLineToTheEye) {
    Random random = random_stream(4, 2);
    const auto any = [&](double most) { return random.uniform(-most, most); };
    const auto anywhere = [&](double most) { return vec3(any(most), any(most), any(most)); };
    int hidden = 0;
    for (int round = 0; round < 4000; ++round) {
        const vec3 middle = anywhere(8), size(2 + any(1.9), 2 + any(1.9), 2 + any(1.9));
        const Block block{middle - size, middle + size};
        const vec3 eye = anywhere(8), centre = anywhere(20);
        const vec3 half(0.5 + any(0.4), 0.5 + any(0.4), 0.5 + any(0.4));
        // True if the block lies between the point and the eye. A block beyond the eye hides nothing.
        const auto blocked = [&](vec3 p) { return meets(block, p, eye - p) && !meets(block, eye, eye - p); };
        int corners_blocked = 0;
        for (int corner = 0; corner < 8; ++corner) {
            const vec3 out((corner & 1) - 0.5, (corner >> 1 & 1) - 0.5, (corner >> 2 & 1) - 0.5);
            corners_blocked += blocked(centre + 2.0 * half * out) ? 1 : 0;
        }
        if (hides(block, eye, fvec3(centre), fvec3(half))) {
            ++hidden;
            EXPECT_EQ(corners_blocked, 8) << "round " << round;
            for (int i = 0; i < 20; ++i) EXPECT_TRUE(blocked(centre + half * anywhere(0.999)));
        } else if (corners_blocked == 8) {
            // A slightly smaller box must be hidden; this allows for rounding at the outline.
            EXPECT_TRUE(hides(block, eye, fvec3(centre), fvec3(0.99 * half))) << "round " << round;
        }
        // Tests the same block and box in another frame, which is turned, moved and scaled.
        const fmat4 to_world = translated({1, 2, 3}) * rotated({0, 1, 0}, 0.7F) * scaled(fvec3(2));
        const fvec3 there(glm::inverse(to_world) * fvec4(fvec3(centre), 1));
        std::vector<detail::Hidden> world;
        detail::add_hidden({&block, 1}, eye, world);
        if (world.empty()) continue;
        const auto own = detail::moved(world[0], to_world);
        if (!detail::is_hidden(world, fvec3(centre), fvec3(1e-3F)))
            EXPECT_FALSE(detail::is_hidden({&own, 1}, there, fvec3(1e-3F)));
        else
            EXPECT_TRUE(detail::is_hidden({&own, 1}, there, fvec3(0)));
    }
    EXPECT_GT(hidden, 100) << "the random cases must include this case";
}

}  // namespace
}  // namespace thaum::render
