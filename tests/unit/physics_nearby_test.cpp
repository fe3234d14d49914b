// Tests of surfaces near a point: exact distances for every shape, meshes compared with a search of all
// triangles, and arrays that are too small.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "physics/physics.h"
#include "unit/physics_scenes.h"

namespace thaum::physics {
namespace {

using namespace scenes;

constexpr double exact = 1e-12;  // tolerance of distances (m)

std::vector<Nearby> near_point(const Physics& physics, vec3 point, double radius) {
    std::array<Nearby, 64> found{};
    const NearbyResult all = physics.nearby(point, radius, found);
    EXPECT_EQ(all.reach, radius);
    return {found.begin(), found.begin() + static_cast<std::ptrdiff_t>(all.count)};
}

vec3 some_place(Random& random, double size) {
    return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

TEST(PhysicsNearby, TheDistanceOfEachSolidIsExact) {
    struct Case {
        BodyDesc desc;
        vec3 local;
        double distance;
    };
    const BodyDesc capsule{.shape = Shape::capsule, .size = {0.1, 0.3, 0}, .mass = 1};
    const BodyDesc cylinder{.shape = Shape::cylinder, .size = {0.1, 0.3, 0}, .mass = 1};
    const std::array cases{
        Case{box({0.1, 0.2, 0.3}, 1), {0.13, 0.24, 0}, 0.05},
        Case{box({0.1, 0.2, 0.3}, 1), {0, 0.1, 0.2}, 0},
        Case{ball(0.1, 1), {0.3, 0.4, 0}, 0.4},
        Case{ball(0.1, 1), {0.01, 0, 0}, 0},
        Case{capsule, {0.15, 0.2, 0}, 0.05},
        Case{capsule, {0.3, 0.7, 0}, 0.4},
        Case{cylinder, {0.15, 0.2, 0}, 0.05},
        Case{cylinder, {0.13, 0.34, 0}, 0.05},
        Case{cylinder, {0.05, 0.32, 0}, 0.02},
        Case{cylinder, {0.05, 0.1, 0.01}, 0},
    };
    for (const Case& c : cases) {
        const quat turn = rotation({0.6, 0, 0.8}, 0.7);
        const vec3 place(3, -2, 5);
        Physics physics;
        physics.add(7, c.desc, {.position = place, .orientation = turn});
        const vec3 point = place + turn * c.local;
        const auto found = near_point(physics, point, 0.5);
        ASSERT_EQ(found.size(), 1U);
        EXPECT_EQ(found[0].key, 7U);
        EXPECT_EQ(found[0].shape, c.desc.shape);
        EXPECT_NEAR(found[0].distance, c.distance, exact);
        EXPECT_EQ(found[0].a, place);
        EXPECT_EQ(found[0].b, c.desc.size);
        if (c.distance > 0.001) {
            EXPECT_TRUE(near_point(physics, point, c.distance - 1e-9).empty());
        }
        EXPECT_EQ(near_point(physics, point, c.distance + 1e-9).size(), 1U);
    }
}

vec3 corner_of(const TriangleMesh& mesh, std::uint32_t triangle, std::size_t corner) {
    return mesh.vertices[mesh.triangles[triangle][corner]];
}

/// Distance of a point from a triangle of a mesh, computed with a fine grid of points (m). In this test it is
/// at most 4 cm too large.
double sampled_distance(const TriangleMesh& mesh, std::uint32_t triangle, vec3 place) {
    double nearest = 1e9;
    for (int u = 0; u <= 40; ++u) {
        for (int v = 0; u + v <= 40; ++v) {
            const vec3 p = corner_of(mesh, triangle, 0) * (u / 40.0) +
                           corner_of(mesh, triangle, 1) * (v / 40.0) +
                           corner_of(mesh, triangle, 2) * ((40.0 - u - v) / 40.0);
            nearest = std::min(nearest, glm::length(p - place));
        }
    }
    return nearest;
}

/// Checks that exactly those triangles were found that are within the radius. If a triangle's distance
/// differs from the radius by less than the grid's error, it may be found or not.
void expect_all_within(const TriangleMesh& mesh, const std::vector<Nearby>& found, vec3 place,
                       double radius) {
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const double nearest = sampled_distance(mesh, i, place);
        const bool in = std::ranges::find(found, i, &Nearby::part) != found.end();
        if (nearest <= radius) {
            EXPECT_TRUE(in) << "triangle " << i;
        }
        if (nearest > radius + 0.04) {
            EXPECT_FALSE(in) << "triangle " << i;
        }
    }
}

/// Checks that the triangles found have the corners of the mesh, moved to its place in the world.
void expect_corners(const TriangleMesh& mesh, const std::vector<Nearby>& found, vec3 place, quat turn) {
    for (const Nearby& t : found) {
        EXPECT_EQ(t.shape, Shape::mesh);
        EXPECT_LE(glm::length(t.a - place - turn * corner_of(mesh, t.part, 0)), exact);
        EXPECT_LE(glm::length(t.b - place - turn * corner_of(mesh, t.part, 1)), exact);
        EXPECT_LE(glm::length(t.c - place - turn * corner_of(mesh, t.part, 2)), exact);
    }
}

TEST(PhysicsNearby, AMeshGivesTheSameTrianglesAsASearchOfAll) {
    const TriangleMesh mesh = hills(16, 1.0);
    const quat turn = rotation({0, 0.6, 0.8}, 1.1);
    const vec3 place(2, 1, -3);
    Physics physics({}, {mesh});
    physics.add(3, {.shape = Shape::mesh}, {.position = place, .orientation = turn});
    Random random{1};
    std::size_t most = 0;
    for (int n = 0; n < 80; ++n) {
        SCOPED_TRACE(n);
        const vec3 local = some_place(random, 8) * vec3(1, 0.2, 1);
        const double radius = random.uniform(0.1, 1.5);
        const auto found = near_point(physics, place + turn * local, radius);
        expect_all_within(mesh, found, local, radius);
        expect_corners(mesh, found, place, turn);
        most = std::max(most, found.size());
    }
    EXPECT_GT(most, 10U);
}

TEST(PhysicsNearby, AFullArrayKeepsTheNearestAndReducesTheReach) {
    Physics physics;
    Random random{2};
    for (Key key = 1; key <= 40; ++key) physics.add(key, ball(0.1, 1), at(some_place(random, 2)));
    std::array<Nearby, 64> all{};
    std::array<Nearby, 10> few{};
    for (int n = 0; n < 100; ++n) {
        const vec3 point = some_place(random, 2);
        const auto whole = physics.nearby(point, 10, all);
        ASSERT_EQ(whole.count, 40U);
        EXPECT_EQ(whole.reach, 10);
        const auto part = physics.nearby(point, 10, few);
        ASSERT_EQ(part.count, few.size());
        std::vector<double> distances;
        for (std::size_t i = 0; i < whole.count; ++i) distances.push_back(all[i].distance);
        std::ranges::sort(distances);
        EXPECT_EQ(part.reach, distances[few.size()]);
        for (std::size_t i = 0; i < few.size(); ++i) {
            EXPECT_LE(few[i].distance, distances[few.size() - 1]);
            if (i > 0) {
                EXPECT_LT(few[i - 1].key, few[i].key);
            }
        }
    }
    EXPECT_EQ(physics.nearby({}, 10, {}).count, 0U);
}

/// A fan of triangles around a place, so that very many are at one distance from a point above it.
TriangleMesh fan(std::uint32_t sides) {
    TriangleMesh mesh{.vertices = {{0, 0, 0}}, .triangles = {}};
    for (std::uint32_t i = 0; i < sides; ++i) {
        const double turn = 2 * pi * i / sides;
        mesh.vertices.push_back({det::cos(turn), -1, det::sin(turn)});
        mesh.triangles.push_back({0, i + 1, 1 + (i + 1) % sides});
    }
    mesh.triangles.push_back({0, 0, 1});  // without area: no distance from some places
    return mesh;
}

/// Compares a search with little room to one that finds all triangles, which another test compares with the
/// mesh.
void expect_the_nearest(const Physics& physics, vec3 point, std::span<Nearby> all) {
    const auto whole = physics.nearby(point, 20, all);
    ASSERT_LT(whole.count, all.size());
    std::vector<double> distances;
    for (const Nearby& t : all.first(whole.count)) distances.push_back(t.distance);
    std::ranges::sort(distances);
    std::array<Nearby, 32> few{};
    const auto part = physics.nearby(point, 20, few);
    ASSERT_EQ(part.count, few.size());
    EXPECT_EQ(part.reach, distances[few.size()]);
    std::size_t next = 0, nearer = 0;  // those found are in the order of all
    for (const Nearby& t : few) {
        EXPECT_LE(t.distance, distances[few.size() - 1]);
        nearer += t.distance < part.reach ? 1 : 0;
        while (next < whole.count && all[next].part != t.part) ++next;
        EXPECT_LT(next++, whole.count);
    }
    EXPECT_EQ(nearer, std::ranges::count_if(distances, [&](double d) { return d < part.reach; }));
}

TEST(PhysicsNearby, AmongManyTrianglesAFullArrayHasTheNearest) {
    std::vector<Nearby> all(4000);
    Random random{3};
    for (const std::uint32_t mesh : {0U, 1U}) {
        Physics world({}, {hills(40, 1.0), fan(500)});
        world.add(1, {.shape = Shape::mesh, .mesh = mesh}, {});
        for (int n = 0; n < 50; ++n) expect_the_nearest(world, some_place(random, 3), all);
        expect_the_nearest(world, {0, 1, 0}, all);
    }
}

TEST(PhysicsNearby, ABodysVelocityIsTheOneAtThePoint) {
    Physics physics;
    physics.add(1, box({1, 1, 1}, 5), {.position = {1, 0, 0}, .velocity = {0, 2, 0}, .spin = {0, 0, 3}});
    const auto found = near_point(physics, {1, 2, 0}, 2);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_LE(glm::length(found[0].velocity - vec3(-6, 2, 0)), exact);
}

TEST(PhysicsNearby, LayersAndOneBodyCanBeLeftOut) {
    Physics physics;
    BodyDesc other = ball(0.1, 1);
    other.layer = 2;
    physics.add(1, ball(0.1, 1), at({}));
    physics.add(2, other, at({0.5, 0, 0}));
    std::array<Nearby, 4> found{};
    EXPECT_EQ(physics.nearby({}, 1, found).count, 2U);
    EXPECT_EQ(physics.nearby({}, 1, found, 2).count, 1U);
    EXPECT_EQ(found[0].key, 2U);
    EXPECT_EQ(physics.nearby({}, 1, found, all_layers, 2).count, 1U);
    EXPECT_EQ(found[0].key, 1U);
}

}  // namespace
}  // namespace thaum::physics
