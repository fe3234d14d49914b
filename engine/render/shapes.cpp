// The generators of render/mesh.h. Every round shape is one surface of revolution. Every flat shape consists
// of convex faces, which are turned outwards with the help of a point inside.
#include <algorithm>
#include <array>
#include <numbers>

#include "core/assert.h"
#include "render/mesh.h"

namespace thaum::render {
namespace {

constexpr float turn = 2 * std::numbers::pi_v<float>;

std::uint32_t add(MeshData& mesh, fvec3 position, fvec3 normal, fvec3 colour) {
    mesh.vertices.push_back({position, normal, colour});
    return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

void triangle(MeshData& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

/// Adds a convex polygon of existing vertices, in either winding, as a fan that faces away from `inside`.
void convex_face(MeshData& mesh, std::span<const std::uint32_t> corners, fvec3 inside) {
    const auto at = [&](std::size_t i) { return mesh.vertices[corners[i]].position; };
    const bool outwards = glm::dot(glm::cross(at(1) - at(0), at(2) - at(0)), at(0) - inside) > 0;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        if (outwards)
            triangle(mesh, corners[0], corners[i], corners[i + 1]);
        else
            triangle(mesh, corners[0], corners[i + 1], corners[i]);
    }
}

/// Adds a flat convex polygon with vertices of its own; its corners are counter-clockwise seen from outside.
void flat_face(MeshData& mesh, std::span<const fvec3> corners, fvec3 colour) {
    const fvec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const fvec3 corner : corners) add(mesh, corner, normal, colour);
    for (std::uint32_t i = 1; i + 1 < corners.size(); ++i) triangle(mesh, first, first + i, first + i + 1);
}

// A box. Each of its 24 vertices is a pair (corner, axis): the corner of the face across that axis, moved
// inwards by the bevel.

using Corner = std::array<int, 3>;  // -1 or +1 along each axis

std::uint32_t box_vertex(const Corner& corner, int axis) {
    const int bits = (corner[0] > 0 ? 1 : 0) + (corner[1] > 0 ? 2 : 0) + (corner[2] > 0 ? 4 : 0);
    return static_cast<std::uint32_t>(3 * bits + axis);
}

Corner corner_of(int bits) {
    return {(bits & 1) != 0 ? 1 : -1, (bits & 2) != 0 ? 1 : -1, (bits & 4) != 0 ? 1 : -1};
}

void add_box_vertices(MeshData& mesh, fvec3 half, float bevel, fvec3 colour) {
    for (int bits = 0; bits < 8; ++bits) {
        const Corner corner = corner_of(bits);
        for (int axis = 0; axis < 3; ++axis) {
            fvec3 position, normal(0);
            for (int k = 0; k < 3; ++k) {
                const float sign = static_cast<float>(corner[static_cast<std::size_t>(k)]);
                position[k] = sign * (half[k] - (k == axis ? 0 : bevel));
                if (k == axis) normal[k] = sign;
            }
            add(mesh, position, normal, colour);
        }
    }
}

void add_box_faces(MeshData& mesh) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const int side : {-1, 1}) {
            Corner c{};
            std::array<std::uint32_t, 4> face{};
            constexpr int around[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
            for (std::size_t i = 0; i < 4; ++i) {
                c[axis] = side;
                c[(axis + 1) % 3] = around[i][0];
                c[(axis + 2) % 3] = around[i][1];
                face[i] = box_vertex(c, static_cast<int>(axis));
            }
            convex_face(mesh, face, fvec3(0));
        }
    }
}

/// Adds the strip along each of the 12 edges and the triangle at each of the 8 corners.
void add_box_bevels(MeshData& mesh) {
    for (std::size_t along = 0; along < 3; ++along) {
        const std::size_t u = (along + 1) % 3, v = (along + 2) % 3;
        for (const int su : {-1, 1}) {
            for (const int sv : {-1, 1}) {
                Corner low{}, high{};
                low[along] = -1;
                high[along] = 1;
                low[u] = high[u] = su;
                low[v] = high[v] = sv;
                const auto iu = static_cast<int>(u), iv = static_cast<int>(v);
                const std::array strip{box_vertex(low, iu), box_vertex(high, iu), box_vertex(high, iv),
                                       box_vertex(low, iv)};
                convex_face(mesh, strip, fvec3(0));
            }
        }
    }
    for (int bits = 0; bits < 8; ++bits) {
        const Corner c = corner_of(bits);
        convex_face(mesh, std::array{box_vertex(c, 0), box_vertex(c, 1), box_vertex(c, 2)}, fvec3(0));
    }
}

// Revolution. Each edge of the profile becomes a separate band between two rings.

struct Band {
    fvec2 low, high;                // ends of the revolved edge, as (radius, y)
    fvec2 low_normal, high_normal;  // normals in the plane of the profile
};

fvec2 edge_normal(fvec2 from, fvec2 to) {
    const fvec2 along = glm::normalize(to - from);
    return {along.y, -along.x};
}

/// Normal at the point where two edges of the profile (the outline that is revolved) meet: the mean of both
/// if they turn by less than `crease` (rad), else `own`.
fvec2 shared_normal(fvec2 own, fvec2 other, float crease) {
    if (glm::dot(own, other) < std::cos(crease)) return own;
    return glm::normalize(own + other);
}

std::vector<fvec2> without_repeats(std::span<const fvec2> profile) {
    std::vector<fvec2> out;
    for (const fvec2 p : profile) {
        if (out.empty() || p != out.back()) out.push_back(p);
    }
    return out;
}

std::vector<Band> bands(std::span<const fvec2> profile, float crease) {
    const auto points = without_repeats(profile);
    THAUM_ASSERT(points.size() >= 2, "a profile needs two points");
    const std::size_t edges = points.size() - 1;
    const bool loop = points.front() == points.back();
    const auto normal = [&](std::size_t e) { return edge_normal(points[e], points[e + 1]); };
    std::vector<Band> out;
    for (std::size_t e = 0; e < edges; ++e) {
        const fvec2 own = normal(e);
        const bool before = e > 0 || loop, after = e + 1 < edges || loop;
        out.push_back({points[e], points[e + 1],
                       before ? shared_normal(own, normal((e + edges - 1) % edges), crease) : own,
                       after ? shared_normal(own, normal((e + 1) % edges), crease) : own});
    }
    return out;
}

/// A point (radius, y) of the profile (the outline that is revolved), turned about the axis by `step` /
/// `segments` of a full turn. `step` may be a half.
fvec3 turned(fvec2 p, float step, int segments) {
    const float angle = turn * step / static_cast<float>(segments);
    return {p.x * std::cos(angle), p.y, -p.x * std::sin(angle)};
}

/// Adds a ring of one vertex for each side of the shape. Where the ring is a point on the axis, its vertices
/// have separate normals, each turned to the middle of its side.
std::uint32_t add_ring(MeshData& mesh, fvec2 point, fvec2 normal, int segments, fvec3 colour) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const float middle = point.x == 0 ? 0.5F : 0.0F;
    for (int k = 0; k < segments; ++k) {
        const float step = static_cast<float>(k);
        add(mesh, turned(point, step, segments), turned(normal, step + middle, segments), colour);
    }
    return first;
}

void add_band(MeshData& mesh, const Band& band, int segments, fvec3 colour) {
    if (band.low.x == 0 && band.high.x == 0) return;
    const auto low = add_ring(mesh, band.low, band.low_normal, segments, colour);
    const auto high = add_ring(mesh, band.high, band.high_normal, segments, colour);
    const auto count = static_cast<std::uint32_t>(segments);
    for (std::uint32_t k = 0; k < count; ++k) {
        const auto next = (k + 1) % count;
        if (band.low.x != 0) triangle(mesh, low + k, low + next, high + (band.high.x == 0 ? k : next));
        if (band.high.x != 0) triangle(mesh, low + k, high + next, high + k);
    }
}

/// Points of a half circle from the bottom to the top, whose lower and upper halves are moved apart: each by
/// `lift` from the origin.
std::vector<fvec2> half_circle(float radius, float lift, int stacks) {
    std::vector<fvec2> out{{0, -radius - lift}};
    for (int i = 1; i < stacks; ++i) {
        const float angle = turn * (static_cast<float>(i) / static_cast<float>(2 * stacks) - 0.25F);
        const fvec2 p = radius * fvec2(std::cos(angle), std::sin(angle));
        if (2 * i <= stacks) out.push_back(p - fvec2(0, lift));
        if (2 * i >= stacks && (lift > 0 || 2 * i > stacks)) out.push_back(p + fvec2(0, lift));
    }
    out.push_back({0, radius + lift});
    return out;
}

}  // namespace

MeshData box(fvec3 half, fvec3 colour, float bevel) {
    MeshData mesh;
    add_box_vertices(mesh, half, bevel, colour);
    add_box_faces(mesh);
    if (bevel > 0) add_box_bevels(mesh);
    return mesh;
}

MeshData revolve(std::span<const fvec2> profile, int segments, fvec3 colour, float crease) {
    THAUM_ASSERT(segments >= 3, "a surface of revolution needs three sides");
    MeshData mesh;
    for (const auto& band : bands(profile, crease)) add_band(mesh, band, segments, colour);
    return mesh;
}

MeshData cone(float bottom_radius, float top_radius, float height, int segments, fvec3 colour) {
    const float y = height / 2;
    const std::array profile{fvec2(0, -y), fvec2(bottom_radius, -y), fvec2(top_radius, y), fvec2(0, y)};
    return revolve(profile, segments, colour);
}

MeshData cylinder(float radius, float height, int segments, fvec3 colour) {
    return cone(radius, radius, height, segments, colour);
}

MeshData sphere(float radius, int segments, fvec3 colour) {
    return revolve(half_circle(radius, 0, std::max(2, segments / 2)), segments, colour, 1.6F);
}

MeshData capsule(float radius, float height, int segments, fvec3 colour) {
    const int stacks = std::max(2, segments / 2);
    // An even number, so that there is a ring where each half sphere meets the cylinder.
    return revolve(half_circle(radius, height / 2, stacks + stacks % 2), segments, colour, 1.6F);
}

MeshData frame(int sides, float outer_radius, float inner_radius, float thickness, fvec3 colour) {
    THAUM_ASSERT(sides >= 3, "a frame needs three sides");
    const auto corner = [&](int i, float radius, float z) {
        const float angle = turn * (0.25F + static_cast<float>(i % sides) / static_cast<float>(sides));
        return fvec3(radius * std::cos(angle), radius * std::sin(angle), z);
    };
    const float front = thickness / 2, back = -front;
    MeshData mesh;
    for (int i = 0; i < sides; ++i) {
        const fvec3 a = corner(i, outer_radius, front), b = corner(i + 1, outer_radius, front);
        const fvec3 c = corner(i + 1, inner_radius, front), d = corner(i, inner_radius, front);
        const fvec3 deep(0, 0, back - front);
        flat_face(mesh, std::array{a, b, c, d}, colour);
        flat_face(mesh, std::array{d + deep, c + deep, b + deep, a + deep}, colour);
        flat_face(mesh, std::array{a + deep, b + deep, b, a}, colour);
        flat_face(mesh, std::array{d, c, c + deep, d + deep}, colour);
    }
    return mesh;
}

MeshData flat_frame(int sides, float outer_radius, float inner_radius, fvec3 colour) {
    THAUM_ASSERT(sides >= 3, "a frame needs three sides");
    MeshData mesh;
    const auto count = static_cast<std::uint32_t>(sides);
    for (std::uint32_t i = 0; i < count; ++i) {
        const float angle = turn * (0.25F + static_cast<float>(i) / static_cast<float>(sides));
        const fvec3 way(std::cos(angle), std::sin(angle), 0);
        const auto outer = add(mesh, outer_radius * way, {0, 0, 1}, colour);
        const auto inner = add(mesh, inner_radius * way, {0, 0, 1}, colour);
        const auto next = 2 * ((i + 1) % count);
        triangle(mesh, outer, next, next + 1);
        triangle(mesh, outer, next + 1, inner);
    }
    return mesh;
}

MeshData ring_mark(float radius, fvec3 colour) {
    return frame(16, radius, 0.68F * radius, 0.15F * radius, colour);
}

MeshData triangle_mark(float radius, fvec3 colour) {
    return frame(3, radius, 0.45F * radius, 0.15F * radius, colour);
}

MeshData grid(fvec2 half, int cells_x, int cells_z, fvec3 colour) {
    THAUM_ASSERT(cells_x > 0 && cells_z > 0, "a grid needs a cell");
    MeshData mesh;
    for (int j = 0; j <= cells_z; ++j) {
        for (int i = 0; i <= cells_x; ++i) {
            const fvec2 at(static_cast<float>(i) / static_cast<float>(cells_x),
                           static_cast<float>(j) / static_cast<float>(cells_z));
            const fvec2 p = half * (2.0F * at - fvec2(1));
            add(mesh, {p.x, 0, p.y}, {0, 1, 0}, colour);
        }
    }
    const auto row = static_cast<std::uint32_t>(cells_x + 1);
    for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(cells_z); ++j) {
        for (std::uint32_t i = 0; i + 1 < row; ++i) {
            const std::uint32_t a = j * row + i, b = a + 1, c = a + row, d = c + 1;
            triangle(mesh, a, c, d);
            triangle(mesh, a, d, b);
        }
    }
    return mesh;
}

}  // namespace thaum::render
