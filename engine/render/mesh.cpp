#include "render/mesh.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "core/assert.h"

namespace thaum::render {
namespace {

struct Extent {
    fvec3 low{0}, high{0};
};

Extent extent(const MeshData& mesh) {
    if (mesh.vertices.empty()) return {};
    Extent out{mesh.vertices[0].position, mesh.vertices[0].position};
    for (const auto& v : mesh.vertices) {
        out.low = glm::min(out.low, v.position);
        out.high = glm::max(out.high, v.position);
    }
    return out;
}

}  // namespace

Bounds bounds(const MeshData& mesh) {
    if (mesh.vertices.empty()) return {};
    const auto [low, high] = extent(mesh);
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

}  // namespace thaum::render
