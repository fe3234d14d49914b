#include "render/occlusion.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace thaum::render {
namespace {

/// A convex polygon. A face of the block has four corners and gains at most one corner when clipped.
struct Polygon {
    std::array<vec3, 5> at{};
    std::size_t count{};
};

/// Face of the block across `axis`, at its high or low side. The corners are relative to the point from which
/// the face is seen.
Polygon face(const Block& block, int axis, bool high_side, vec3 point) {
    constexpr int around[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    Polygon out;
    for (const auto& corner : around) {
        vec3 p;
        p[axis] = (high_side ? block.high : block.low)[axis];
        p[u] = (corner[0] != 0 ? block.high : block.low)[u];
        p[v] = (corner[1] != 0 ? block.high : block.low)[v];
        out.at[out.count++] = p - point;
    }
    return out;
}

/// Clips a polygon at the horizon (Sutherland and Hodgman 1974).
Polygon above_horizon(const Polygon& in, vec3 normal) {
    Polygon out;
    for (std::size_t i = 0; i < in.count; ++i) {
        const vec3 a = in.at[i], b = in.at[(i + 1) % in.count];
        const double ha = glm::dot(a, normal), hb = glm::dot(b, normal);
        if (ha >= 0) out.at[out.count++] = a;
        if ((ha >= 0) != (hb >= 0)) out.at[out.count++] = a + (b - a) * (ha / (ha - hb));
    }
    return out;
}

/// Form factor of a polygon, as Lambert's sum over its edges. Its sign depends on the winding of the polygon.
double lambert(const Polygon& p, vec3 normal) {
    double sum = 0;
    for (std::size_t i = 0; i < p.count; ++i) {
        const vec3 a = p.at[i], b = p.at[(i + 1) % p.count];
        const vec3 across = glm::cross(a, b);
        const double length = glm::length(across);
        if (length > 1e-12) sum += std::atan2(length, glm::dot(a, b)) * glm::dot(across, normal) / length;
    }
    return sum / (2 * pi);
}

}  // namespace

double form_factor(const Block& block, vec3 point, vec3 normal) {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const bool above = point[axis] > block.high[axis];
        if (!above && !(point[axis] < block.low[axis]))
            continue;  // the point sees neither face across this axis
        sum += std::abs(lambert(above_horizon(face(block, axis, above, point), normal), normal));
    }
    return std::min(sum, 1.0);
}

bool meets(const Block& block, vec3 point, vec3 way) {
    double enter = 0, leave = 1e300;
    for (int axis = 0; axis < 3; ++axis) {
        if (way[axis] == 0) {
            if (point[axis] < block.low[axis] || point[axis] > block.high[axis]) return false;
            continue;
        }
        const double a = (block.low[axis] - point[axis]) / way[axis];
        const double b = (block.high[axis] - point[axis]) / way[axis];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave;
}

}  // namespace thaum::render
