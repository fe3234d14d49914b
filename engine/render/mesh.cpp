#include "render/mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <map>

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

namespace {

/// Cuts from `low` to `high` evenly into pieces not longer than `size`.
struct Cuts {
    float low{}, length{};
    int pieces = 1;

    Cuts(float from, float to, float size)
        : low(from), length(to - from), pieces(std::max(1, static_cast<int>(std::ceil(length / size)))) {}
    int piece_of(float at) const {
        if (pieces == 1) return 0;
        const float share = (at - low) / length;
        return std::clamp(static_cast<int>(share * static_cast<float>(pieces)), 0, pieces - 1);
    }
};

}  // namespace

std::vector<MeshData> split(const MeshData& mesh, float size) {
    constexpr auto unused = std::numeric_limits<std::uint32_t>::max();
    const auto [low, high] = extent(mesh);
    const Cuts along_x(low.x, high.x, size), along_z(low.z, high.z, size);
    std::map<std::pair<int, int>, std::vector<std::size_t>> cells;  // the first index of each triangle
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        fvec3 middle(0);
        for (std::size_t k = 0; k < 3; ++k) middle += mesh.vertices[mesh.indices[i + k]].position / 3.0F;
        cells[{along_x.piece_of(middle.x), along_z.piece_of(middle.z)}].push_back(i);
    }
    std::vector<MeshData> parts;
    std::vector<std::uint32_t> number(mesh.vertices.size(), unused);
    for (const auto& [place, triangles] : cells) {
        auto& part = parts.emplace_back();
        for (const auto first : triangles) {
            for (std::size_t k = 0; k < 3; ++k) {
                const auto old = mesh.indices[first + k];
                if (number[old] == unused) {
                    number[old] = static_cast<std::uint32_t>(part.vertices.size());
                    part.vertices.push_back(mesh.vertices[old]);
                }
                part.indices.push_back(number[old]);
            }
        }
        std::fill(number.begin(), number.end(), unused);
    }
    return parts;
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
