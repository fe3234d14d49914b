#include "render/mesh.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "core/assert.h"

namespace thaum::render {
namespace {

struct Ray {
    fvec3 origin, direction;
};

/// Moller and Trumbore 1997; double-sided.
bool hits(const Ray& ray, fvec3 a, fvec3 b, fvec3 c, float reach) {
    const fvec3 ab = b - a, ac = c - a, p = glm::cross(ray.direction, ac);
    const float det = glm::dot(ab, p);
    if (std::abs(det) < 1e-12F) return false;
    const fvec3 t = ray.origin - a;
    const float u = glm::dot(t, p) / det;
    if (u < 0 || u > 1) return false;
    const fvec3 q = glm::cross(t, ab);
    const float v = glm::dot(ray.direction, q) / det;
    if (v < 0 || u + v > 1) return false;
    const float along = glm::dot(ac, q) / det;
    return along > 0 && along < reach;
}

/// The i-th of n directions over the hemisphere about `normal`, denser near it as the cosine law asks; a golden-angle
/// spiral is even without random numbers.
fvec3 spiral_direction(fvec3 normal, int i, int n) {
    const float square = (static_cast<float>(i) + 0.5F) / static_cast<float>(n);
    const float angle = static_cast<float>(i) * 2.39996323F;
    const fvec3 other = std::abs(normal.y) < 0.9F ? fvec3(0, 1, 0) : fvec3(1, 0, 0);
    const fvec3 x = glm::normalize(glm::cross(other, normal)), z = glm::cross(normal, x);
    return std::sqrt(square) * (std::cos(angle) * x + std::sin(angle) * z) + std::sqrt(1 - square) * normal;
}

struct Triangle {
    fvec3 a, b, c;
};

/// The triangles that rays of length `reach` from `origin` can meet at all.
void gather_near(const std::vector<Triangle>& all, fvec3 origin, float reach, std::vector<Triangle>& near) {
    near.clear();
    for (const auto& t : all) {
        const fvec3 low = glm::min(t.a, glm::min(t.b, t.c)), high = glm::max(t.a, glm::max(t.b, t.c));
        const fvec3 closest = glm::clamp(origin, low, high) - origin;
        if (glm::dot(closest, closest) < reach * reach) near.push_back(t);
    }
}

float covered(const Vertex& vertex, const std::vector<Triangle>& near, int rays, float reach) {
    int blocked = 0;
    for (int i = 0; i < rays; ++i) {
        const Ray ray{vertex.position + 1e-3F * vertex.normal, spiral_direction(vertex.normal, i, rays)};
        blocked += std::any_of(near.begin(), near.end(),
                               [&](const Triangle& t) { return hits(ray, t.a, t.b, t.c, reach); });
    }
    return static_cast<float>(blocked) / static_cast<float>(rays);
}

std::vector<Triangle> triangles(const MeshData& mesh) {
    std::vector<Triangle> out;
    out.reserve(mesh.indices.size() / 3);
    const auto at = [&](std::size_t i) { return mesh.vertices[mesh.indices[i]].position; };
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        out.push_back({at(i), at(i + 1), at(i + 2)});
    }
    return out;
}

}  // namespace

Bounds bounds(const MeshData& mesh) {
    if (mesh.vertices.empty()) return {};
    fvec3 low(std::numeric_limits<float>::max()), high(std::numeric_limits<float>::lowest());
    for (const auto& v : mesh.vertices) {
        low = glm::min(low, v.position);
        high = glm::max(high, v.position);
    }
    Bounds out{0.5F * (low + high), 0};
    for (const auto& v : mesh.vertices) {
        out.radius = std::max(out.radius, glm::distance(out.centre, v.position));
    }
    return out;
}

fmat4 translated(fvec3 by) { return glm::translate(fmat4(1), by); }
fmat4 rotated(fvec3 axis, float angle) { return glm::rotate(fmat4(1), angle, axis); }
fmat4 scaled(fvec3 by) { return glm::scale(fmat4(1), by); }

MeshData transformed(MeshData mesh, const fmat4& by) {
    const glm::mat3 linear(by);
    const float determinant = glm::determinant(linear);
    THAUM_ASSERT(determinant != 0, "a mesh cannot be transformed by a matrix without an inverse");
    const glm::mat3 of_normals = glm::transpose(glm::inverse(linear));
    for (auto& v : mesh.vertices) {
        v.position = fvec3(by * fvec4(v.position, 1));
        v.normal = glm::normalize(of_normals * v.normal);
    }
    if (determinant < 0) {
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
        }
    }
    return mesh;
}

void append(MeshData& to, const MeshData& part, const fmat4& placed) {
    const auto moved = transformed(part, placed);
    const auto base = static_cast<std::uint32_t>(to.vertices.size());
    to.vertices.insert(to.vertices.end(), moved.vertices.begin(), moved.vertices.end());
    for (const auto index : moved.indices) to.indices.push_back(base + index);
}

MeshData painted(MeshData mesh, fvec3 colour) {
    for (auto& v : mesh.vertices) v.colour = colour;
    return mesh;
}

MeshData flat_shaded(const MeshData& mesh) {
    MeshData out;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        Vertex corner[3];
        for (std::size_t k = 0; k < 3; ++k) corner[k] = mesh.vertices[mesh.indices[i + k]];
        const fvec3 across =
            glm::cross(corner[1].position - corner[0].position, corner[2].position - corner[0].position);
        const float length = glm::length(across);
        for (auto& v : corner) {
            if (length > 0) v.normal = across / length;
            out.indices.push_back(static_cast<std::uint32_t>(out.vertices.size()));
            out.vertices.push_back(v);
        }
    }
    return out;
}

void bake_ambient(MeshData& mesh, int rays, float reach, float strength) {
    THAUM_ASSERT(rays > 0, "bake_ambient needs at least one ray");
    const auto all = triangles(mesh);
    std::vector<Triangle> near;
    for (auto& v : mesh.vertices) {
        gather_near(all, v.position, reach, near);
        v.colour *= 1 - strength * covered(v, near, rays, reach);
    }
}

}  // namespace thaum::render
