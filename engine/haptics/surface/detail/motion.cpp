#include "haptics/surface/detail/motion.h"

#include <algorithm>

#include "haptics/surface/detail/sweep.h"

namespace thaum::haptics {
namespace {

// Distance by which a touched triangle may move over the proxy in a tick beyond what its body's velocity
// explains (m).
constexpr double resting_slack = 5e-4;
constexpr int max_pushes = 4;

bool was_touched(const Scene& scene, const SurfaceState& state, std::uint32_t i) {
    for (std::uint32_t c = 0; c < std::min<std::uint32_t>(state.contacts, 3); ++c) {
        if (state.touched[c].key == scene.body_of(i).key && state.touched[c].part == scene.surface(i).part)
            return true;
    }
    return false;
}

/// Whether a flat surface moved over the proxy, which was in front of it before. A touched triangle also
/// counts if it moved slightly farther than its body's velocity says. `wall` becomes the surface's plane.
bool moved_over(const Scene& scene, const SurfaceState& state, const Facet& flat, vec3 from, vec3 x,
                Wall& wall) {
    if (from != x) {
        Hit hit;
        sweep_flat(scene, flat, Sweep(from, x - from), hit);
        wall = hit.wall;
        if (hit.at <= 1) return true;
    }
    const double height = glm::dot(flat.normal, x) - flat.offset;
    if (height >= flat.gap - place_tolerance) return false;
    wall = {flat.normal, flat.offset + flat.gap, 0, flat.surface};
    if (flat.kind == SurfaceKind::plane) return true;
    return flat.kind == SurfaceKind::triangle && height < 0 && height > -resting_slack &&
           was_touched(scene, state, flat.surface) &&
           over_triangle(scene.surface(flat.surface), flat.normal, x, place_tolerance);
}

/// Whether a solid moved over the proxy, so that the proxy must leave it. `wall` becomes its tangent plane.
bool moved_over(const Scene& scene, std::uint32_t i, vec3 from, vec3 x, Wall& wall) {
    if (from != x) {
        Hit hit;
        sweep_solid(scene, i, Sweep(from, x - from), hit);
        wall = hit.wall;
        if (hit.at <= 1) return true;
    }
    if (scene.beyond(i, x, 0)) return false;
    const Distance d = to_solid(scene.surface(i), scene.body_of(i).orientation, x);
    wall = wall_at(scene, x, d, i);
    return d.value < scene.gap[i] - place_tolerance;
}

using Places = std::array<vec3, surface_body_capacity>;

/// Adds walls (planes, walls.h) of the surfaces that moved over the proxy. Returns false if there are none.
/// `from` has, for each body, the place where the proxy would now be if it had moved with that body since the
/// last tick (m).
bool add_walls_that_moved_over(const Scene& scene, const SurfaceState& state, const Places& from, vec3 x,
                               Walls& walls) {
    bool pushed = false;
    Wall wall;
    for (std::uint32_t i = 0; i < scene.flat_count && walls.count < max_walls; ++i) {
        const Facet& flat = scene.flats[i];
        if (!moved_over(scene, state, flat, from[scene.surface(flat.surface).body], x, wall)) continue;
        add_wall(walls, wall);
        pushed = true;
    }
    for (std::uint32_t i = 0; i < scene.solid_count && walls.count < max_walls; ++i) {
        const std::uint32_t solid = scene.solids[i];
        if (!moved_over(scene, solid, from[scene.surface(solid).body], x, wall)) continue;
        add_wall(walls, wall);
        pushed = true;
    }
    return pushed;
}

}  // namespace

vec3 carried(const Scene& scene, const SurfaceState& state) {
    if (state.contacts == 0) return state.proxy;
    for (std::uint32_t i = 0; i < scene.body_count; ++i) {
        if (scene.patch->bodies[i].key == state.touched[0].key) return scene.motions[i].moved(state.proxy);
    }
    return state.proxy;
}

vec3 pushed_out(const Scene& scene, const SurfaceState& state, vec3 start) {
    Places from;
    for (std::uint32_t i = 0; i < scene.body_count; ++i) from[i] = scene.motions[i].moved(state.proxy);
    Walls walls;
    vec3 x = start;
    for (int round = 0; round < max_pushes; ++round) {
        const std::size_t before = walls.count;
        if (!add_walls_that_moved_over(scene, state, from, x, walls)) return x;
        const NearestPlace goal = nearest_place(walls, start);
        if (!goal.found) return x;
        x = goal.place;
        if (walls.count == max_walls && walls.count == before) return x;
    }
    return x;
}
}  // namespace thaum::haptics
