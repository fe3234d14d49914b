#include "haptics/surface/detail/walls.h"

#include <utility>

#include "haptics/surface/detail/feel.h"
#include "haptics/surface/detail/texture.h"

namespace thaum::haptics {
namespace {

constexpr double nearly_parallel = 1e-15;  // squared sine below which two planes count as parallel
// Distance that two parallel planes may have and still count as one (m).
constexpr double loose = 0.4 * surface_gap;

/// Up to three walls (planes at touched surfaces) that meet at the proxy. The displacement of the proxy from
/// the tip is the sum of their normals times their depths.
struct ActiveSet {
    std::array<std::size_t, 3> walls{};
    std::array<double, 3> depths{};
    std::size_t count{};
};

/// Whether these walls (planes at touched surfaces) alone hold the proxy: each of them pushes it away from
/// the tip, and the place where they hold it is behind no other wall. `place` becomes that place.
bool holds(const Walls& walls, const ActiveSet& active, vec3 tip, double slack, vec3& place) {
    place = tip;
    unsigned used = 0;  // one bit for each wall
    for (std::size_t i = 0; i < active.count; ++i) {
        if (!(active.depths[i] > 0)) return false;
        place += active.depths[i] * walls.items[active.walls[i]].normal;
        used |= 1U << active.walls[i];
    }
    for (std::size_t i = 0; i < walls.count; ++i) {
        if ((used >> i & 1U) != 0) continue;
        if (glm::dot(walls.items[i].normal, place) < walls.items[i].offset - slack) return false;
    }
    return true;
}

ActiveSet against_one(const Walls& walls, std::size_t i, vec3 tip) {
    return {{i}, {depth_behind(walls.items[i], tip)}, 1};
}

ActiveSet against_two(const Walls& walls, std::size_t i, std::size_t j, vec3 tip) {
    const vec3 along = glm::cross(walls.items[i].normal, walls.items[j].normal);
    const double sine2 = glm::dot(along, along);
    const double g = glm::dot(walls.items[i].normal, walls.items[j].normal);
    if (sine2 < nearly_parallel) return {{i, j}, {-1, -1}, 2};
    const Depths depths =
        depths_of_two(depth_behind(walls.items[i], tip), depth_behind(walls.items[j], tip), g, sine2);
    return {{i, j}, {depths.a, depths.b}, 2};
}

/// Three planes with the normals n meet at sum offset_i (n_j x n_k) / det. The depths are the coordinates of
/// the displacement from the tip to that corner, along the three normals.
ActiveSet against_three(const Walls& walls, std::size_t i, std::size_t j, std::size_t k, vec3 tip) {
    const vec3 a = walls.items[i].normal, b = walls.items[j].normal, c = walls.items[k].normal;
    const vec3 bc = glm::cross(b, c), ca = glm::cross(c, a), ab = glm::cross(a, b);
    const double det = glm::dot(a, bc);
    if (det * det < nearly_parallel) return {{i, j, k}, {-1, -1, -1}, 3};
    const vec3 way = (depth_behind(walls.items[i], tip) * bc + depth_behind(walls.items[j], tip) * ca +
                      depth_behind(walls.items[k], tip) * ab) /
                     det;
    return {{i, j, k}, {glm::dot(way, bc) / det, glm::dot(way, ca) / det, glm::dot(way, ab) / det}, 3};
}

/// Keeps only the walls (planes at touched surfaces) of the active set, with their depths. The set names them
/// in the order of `walls`.
void keep(Walls& walls, const ActiveSet& active) {
    for (std::size_t i = 0; i < active.count; ++i) {
        const std::size_t from = active.walls[i];
        if (from != i) walls.items[i] = walls.items[from];
        walls.items[i].depth = active.depths[i];
    }
    walls.count = active.count;
}

NearestPlace nearest_place(Walls& walls, vec3 tip, double slack) {
    NearestPlace nearest{tip, true};
    const auto try_set = [&](const ActiveSet& active) {
        if (!holds(walls, active, tip, slack, nearest.place)) return false;
        keep(walls, active);
        return true;
    };
    if (try_set({})) return nearest;
    const std::size_t n = walls.count;
    for (std::size_t i = 0; i < n; ++i)
        if (try_set(against_one(walls, i, tip))) return nearest;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j)
            if (try_set(against_two(walls, i, j, tip))) return nearest;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j)
            for (std::size_t k = j + 1; k < n; ++k)
                if (try_set(against_three(walls, i, j, k, tip))) return nearest;
    nearest.found = false;
    return nearest;
}

}  // namespace

NearestPlace nearest_place(Walls& walls, vec3 tip) {
    const NearestPlace nearest = nearest_place(walls, tip, place_tolerance);
    return nearest.found ? nearest : nearest_place(walls, tip, loose);
}

double friction_reach(const Scene& scene, const Walls& walls, vec3 x, bool sliding) {
    double reach = 0;
    for (std::size_t i = 0; i < walls.count; ++i) {
        const Wall& wall = walls.items[i];
        const SurfaceMaterial& m = scene.body_of(wall.surface).material;
        const double friction = sliding ? m.dynamic_friction : m.static_friction;
        if (!(friction > 0)) continue;
        const bool smooth = top_of(m.texture) == 0;
        reach += friction * (smooth ? wall.depth : textured_push(scene, wall, x).depth);
    }
    return reach;
}

bool stands(const Scene& scene, const Wall& wall, vec3 x) {
    constexpr double slack = 10 * place_tolerance;
    const std::uint32_t i = wall.surface;
    const Surface& s = scene.surface(i);
    if (is_triangle(s.kind)) return over_triangle(s, scene.normal[i], x, slack);
    if (is_flat(s.kind)) return true;
    const Distance here = to_solid(s, scene.body_of(i).orientation, x);
    const double turned = glm::length(here.normal - wall.normal) * wall.depth;
    return here.value <= scene.gap[i] + slack && turned <= slack;
}

bool all_stand(const Scene& scene, const Walls& walls, vec3 x) {
    for (std::size_t i = 0; i < walls.count; ++i)
        if (!stands(scene, walls.items[i], x)) return false;
    return true;
}

void most_loaded_first(Walls& walls) {
    for (std::size_t i = 1; i < walls.count; ++i)
        for (std::size_t j = i; j > 0 && walls.items[j - 1].depth < walls.items[j].depth; --j)
            std::swap(walls.items[j - 1], walls.items[j]);
}

}  // namespace thaum::haptics
