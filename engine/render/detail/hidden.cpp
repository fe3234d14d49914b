#include "render/detail/hidden.h"

#include <algorithm>

namespace thaum::render::detail {
namespace {

/// For each axis, the side on which the eye sees a face: -1, 1, or 0 for none.
std::array<int, 3> faces_seen(const Block& block, vec3 eye) {
    std::array<int, 3> seen{};
    for (int axis = 0; axis < 3; ++axis)
        seen[static_cast<std::size_t>(axis)] =
            static_cast<int>(eye[axis] > block.high[axis]) - static_cast<int>(eye[axis] < block.low[axis]);
    return seen;
}

void add_plane(vec3 inwards, vec3 through, Hidden& out) {
    const vec3 n = glm::normalize(inwards);
    out.planes[out.count++] = fvec4(fvec3(n), static_cast<float>(-glm::dot(n, through)));
}

/// Adds the planes of the visible faces; the hidden region is behind them.
void add_faces(const Block& block, const std::array<int, 3>& seen, Hidden& out) {
    for (int axis = 0; axis < 3; ++axis) {
        const int side = seen[static_cast<std::size_t>(axis)];
        if (side == 0) continue;
        vec3 n(0);
        n[axis] = -side;
        add_plane(n, side > 0 ? block.high : block.low, out);
    }
}

/// Adds the plane through the edge where the face across axes[0] meets the face across axes[1]. Does so only
/// if the edge is part of the outline, that is if one face is visible and the other is not.
void add_edge(const Block& block, vec3 eye, const std::array<int, 3>& seen, glm::ivec2 axes, glm::ivec2 sides,
              Hidden& out) {
    const auto is_seen = [&](int i) { return seen[static_cast<std::size_t>(axes[i])] == sides[i]; };
    if (is_seen(0) == is_seen(1)) return;
    vec3 from = block.low;
    for (int i = 0; i < 2; ++i) from[axes[i]] = sides[i] > 0 ? block.high[axes[i]] : block.low[axes[i]];
    vec3 along(0);
    along[3 - axes[0] - axes[1]] = 1;
    const vec3 n = glm::cross(along, from - eye);
    const vec3 middle = 0.5 * (block.low + block.high);
    add_plane(glm::dot(n, middle - eye) < 0 ? -n : n, eye, out);
}

}  // namespace

void add_hidden(std::span<const Block> blocks, vec3 eye, std::vector<Hidden>& out) {
    for (const auto& block : blocks) {
        const auto seen = faces_seen(block, eye);
        if (seen == std::array<int, 3>{}) continue;
        Hidden hidden;
        add_faces(block, seen, hidden);
        for (const glm::ivec2 axes : {glm::ivec2(0, 1), glm::ivec2(1, 2), glm::ivec2(2, 0)}) {
            for (const int a : {-1, 1}) {
                for (const int b : {-1, 1}) add_edge(block, eye, seen, axes, {a, b}, hidden);
            }
        }
        out.push_back(hidden);
    }
}

Hidden moved(const Hidden& hidden, const fmat4& to_world) {
    Hidden out = hidden;
    for (std::size_t i = 0; i < out.count; ++i) out.planes[i] = hidden.planes[i] * to_world;
    return out;
}

bool is_hidden(std::span<const Hidden> hidden, fvec3 centre, fvec3 half) {
    const auto within = [&](const fvec4& plane) {
        return glm::dot(plane, fvec4(centre, 1)) >= glm::dot(glm::abs(fvec3(plane)), half);
    };
    return std::any_of(hidden.begin(), hidden.end(), [&](const Hidden& h) {
        return std::all_of(h.planes.data(), h.planes.data() + h.count, within);
    });
}

}  // namespace thaum::render::detail
