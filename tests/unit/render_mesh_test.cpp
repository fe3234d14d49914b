// Tests of mesh generators: the meshes are closed, face outwards, and have the volume of the shape.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "render/mesh.h"

namespace thaum::render {
namespace {

const fvec3 grey(0.5F);

/// Position of a vertex. Vertices at the same position count as one point, even if their normals differ.
using Point = std::tuple<long, long, long>;
Point point(fvec3 p) { return {std::lround(p.x * 1e5F), std::lround(p.y * 1e5F), std::lround(p.z * 1e5F)}; }

std::map<std::pair<Point, Point>, int> directed_edges(const MeshData& mesh) {
    std::map<std::pair<Point, Point>, int> edges;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto at = [&](std::size_t n) {
                return point(mesh.vertices[mesh.indices[i + n % 3]].position);
            };
            ++edges[{at(k), at(k + 1)}];
        }
    }
    return edges;
}

/// Expects that each edge belongs to two triangles with opposite directions along it, so that they agree on
/// the outside.
void expect_closed(const MeshData& mesh) {
    const auto edges = directed_edges(mesh);
    for (const auto& [edge, count] : edges) {
        ASSERT_NE(edge.first, edge.second) << "a triangle without area";
        ASSERT_EQ(count, 1);
        ASSERT_TRUE(edges.contains({edge.second, edge.first}));
    }
}

/// Signed volume; positive if the triangles face outwards.
double volume(const MeshData& mesh) {
    double sum = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto at = [&](std::size_t n) {
            return glm::dvec3(mesh.vertices[mesh.indices[i + n]].position);
        };
        sum += glm::dot(at(0), glm::cross(at(1), at(2))) / 6;
    }
    return sum;
}

void expect_normals_agree(const MeshData& mesh) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto& a = mesh.vertices[mesh.indices[i]];
        const auto& b = mesh.vertices[mesh.indices[i + 1]];
        const auto& c = mesh.vertices[mesh.indices[i + 2]];
        const fvec3 face = glm::normalize(glm::cross(b.position - a.position, c.position - a.position));
        for (const auto& v : {a, b, c}) {
            ASSERT_NEAR(glm::length(v.normal), 1, 1e-4F);
            ASSERT_GT(glm::dot(v.normal, face), 0.2F);
        }
    }
}

std::vector<fvec2> bowl_profile() {
    return {{0, 0}, {0.6F, 0.2F}, {1, 0.8F}, {1, 1}, {0.9F, 1}, {0.85F, 0.8F}, {0.5F, 0.3F}, {0, 0.2F}};
}

struct Shape {
    const char* name;
    MeshData mesh;
    // Exact volume of the flat-faced mesh (m^3); 0: not compared.
    double volume;
};

std::vector<Shape> shapes() {
    // A regular polygon with n sides and radius 1 has the area n/2 sin(2 pi / n).
    const auto polygon = [](int n) { return 0.5 * n * std::sin(2 * std::numbers::pi / n); };
    const std::array loop{fvec2(1, -0.1F), fvec2(1.2F, -0.1F), fvec2(1.2F, 0.1F), fvec2(1, 0.1F),
                          fvec2(1, -0.1F)};
    return {
        {"box", box({1, 2, 3}, grey), 48},
        {"bevelled box", box({1, 2, 3}, grey, 0.1F), 0},
        {"cylinder", cylinder(0.5F, 2, 16, grey), 0.25 * 2 * polygon(16)},
        {"cone", cone(0.5F, 0, 2, 16, grey), 0.25 * 2 * polygon(16) / 3},
        {"frustum", cone(1, 0.5F, 2, 12, grey), 2 * polygon(12) * (1 + 0.5 + 0.25) / 3},
        {"sphere", sphere(1, 16, grey), 0},
        {"capsule", capsule(0.5F, 1, 14, grey), 0},
        {"capsule of few sides", capsule(0.5F, 1, 3, grey), 0},
        {"bowl", revolve(bowl_profile(), 24, grey), 0},
        {"loop", revolve(loop, 20, grey), 0.2 * (1.44 - 1) * polygon(20)},
        {"ring mark", ring_mark(1, grey), (1 - 0.68 * 0.68) * 0.15 * polygon(16)},
        {"triangle mark", triangle_mark(1, grey), (1 - 0.45 * 0.45) * 0.15 * polygon(3)},
    };
}

TEST(Mesh, ShapesAreClosedAndFaceOutwards) {
    for (const auto& shape : shapes()) {
        SCOPED_TRACE(shape.name);
        expect_closed(shape.mesh);
        expect_normals_agree(shape.mesh);
        EXPECT_GT(volume(shape.mesh), 0);
        if (shape.volume == 0) continue;
        EXPECT_NEAR(volume(shape.mesh), shape.volume, 1e-5 * shape.volume);
    }
}

/// Ratio of the volume errors with n and 2 n sides; 4 for second-order convergence to the round shape.
template <class Make>
void expect_second_order(Make make, double exact) {
    double before = exact - volume(make(16));
    EXPECT_LT(before, 0.1 * exact);
    for (const int sides : {32, 64, 128}) {
        const double error = exact - volume(make(sides));
        EXPECT_NEAR(before / error, 4, 0.25) << sides;
        before = error;
    }
}

TEST(Mesh, VolumesApproachTheRoundShape) {
    const double circle = std::numbers::pi;
    expect_second_order([](int n) { return cylinder(1, 2, n, grey); }, 2 * circle);
    expect_second_order([](int n) { return cone(1, 0, 3, n, grey); }, circle);
    expect_second_order([](int n) { return sphere(1, n, grey); }, 4 * circle / 3);
    expect_second_order([](int n) { return capsule(1, 1, n, grey); }, 4 * circle / 3 + circle);
}

TEST(Mesh, BevelKeepsTheBoxWithinItsSizes) {
    const auto mesh = box({1, 1, 1}, grey, 0.2F);
    for (const auto& v : mesh.vertices) {
        EXPECT_LE(std::max({std::abs(v.position.x), std::abs(v.position.y), std::abs(v.position.z)}), 1);
    }
    EXPECT_LT(volume(mesh), 8);
    EXPECT_GT(volume(mesh), 7);
}

TEST(Mesh, TransformsKeepTheOutsideOutside) {
    const auto mirror = scaled({-1, 2, 0.5F}) * rotated({0, 1, 0}, 0.3F);
    const auto mesh = transformed(cone(0.5F, 0.2F, 1, 12, grey), mirror);
    expect_closed(mesh);
    expect_normals_agree(mesh);
    EXPECT_NEAR(volume(mesh), volume(cone(0.5F, 0.2F, 1, 12, grey)), 1e-5);
}

TEST(Mesh, AppendAddsVolumes) {
    MeshData mesh = box(fvec3(0.5F), grey);
    append(mesh, sphere(0.5F, 12, grey), translated({3, 0, 0}));
    EXPECT_NEAR(volume(mesh), 1 + volume(sphere(0.5F, 12, grey)), 1e-5);
    expect_closed(mesh);
}

TEST(Mesh, AFlatFrameFacesForward) {
    const auto mesh = flat_frame(6, 2, 1, grey);
    EXPECT_EQ(mesh.indices.size(), 3U * 12);
    expect_normals_agree(mesh);
    for (const auto& v : mesh.vertices) EXPECT_EQ(v.normal, fvec3(0, 0, 1));
}

TEST(Mesh, FlatShadingGivesEachTriangleItsOwnNormal) {
    const auto mesh = flat_shaded(sphere(1, 8, grey));
    EXPECT_EQ(mesh.vertices.size(), mesh.indices.size());
    expect_closed(mesh);
    for (std::size_t i = 0; i < mesh.vertices.size(); i += 3) {
        EXPECT_EQ(mesh.vertices[i].normal, mesh.vertices[i + 1].normal);
    }
}

TEST(Mesh, BoundsHoldTheMesh) {
    const auto mesh = transformed(box({1, 2, 3}, grey), translated({5, 0, 0}));
    const auto b = bounds(mesh);
    EXPECT_NEAR(b.centre.x, 5, 1e-5F);
    EXPECT_NEAR(b.radius, std::sqrt(14.0F), 1e-4F);
    EXPECT_EQ(bounds(MeshData{}).radius, 0);
}

TEST(Mesh, GridFacesUp) {
    const auto mesh = grid({2, 3}, 4, 5, grey);
    EXPECT_EQ(mesh.indices.size(), 4U * 5 * 6);
    expect_normals_agree(mesh);
}

}  // namespace
}  // namespace thaum::render
