// haptics/surface/detail/walls.h: planes that hold the proxy, the place in front of all of them that is
// nearest to the tip, and the pull up to which their friction holds.
#pragma once
#include "haptics/surface/detail/scene.h"

namespace thaum::haptics {

inline constexpr std::size_t max_walls = 4;

/// Plane through the place where the proxy touches a surface. A point x is in front of it if the dot product
/// of normal and x is >= offset.
struct Wall {
    vec3 normal{};
    double offset{};  ///< distance of the plane from the origin along the normal (m)
    /// Displacement of the proxy from the tip by this wall (m); 0 until nearest_place() has computed it.
    double depth{};
    std::uint32_t surface{};  ///< index of the wall's surface in the patch
    bool met_here{};          ///< the proxy has not moved since it met the wall
};

struct Walls {
    std::array<Wall, max_walls> items{};
    std::size_t count{};
};

/// Tangent plane of the surface `i` near p, moved out by the gap that the proxy keeps. `d` is the distance of
/// p from the surface.
inline Wall wall_at(const Scene& scene, vec3 p, Distance d, std::uint32_t i) {
    return {d.normal, glm::dot(d.normal, p) - d.value + scene.gap[i], 0, i};
}

/// Adds a wall (plane at a touched surface). It replaces an earlier wall of the same surface, because a round
/// surface has another plane at each place.
inline void add_wall(Walls& walls, const Wall& wall) {
    for (std::size_t i = 0; i < walls.count; ++i) {
        if (walls.items[i].surface != wall.surface) continue;
        walls.items[i] = wall;
        return;
    }
    if (walls.count < max_walls) walls.items[walls.count++] = wall;
}

/// Distance of the tip behind a wall (m).
inline double depth_behind(const Wall& wall, vec3 tip) { return wall.offset - glm::dot(wall.normal, tip); }

/// Displacements of the proxy by two walls together (m).
struct Depths {
    double a{}, b{};
};
/// Displacements by two walls that both push. `a` and `b` are the distances of the tip behind each wall (m),
/// g is the cosine of the angle between their normals, and sine2 the square of its sine.
inline Depths depths_of_two(double a, double b, double g, double sine2) {
    return {(a - g * b) / sine2, (b - g * a) / sine2};
}

struct NearestPlace {
    vec3 place{};
    bool found{};  ///< false: no place is in front of all walls
};

/// Finds the unique place in front of all walls that is nearest to the tip. Tries every set of up to three
/// walls. Keeps the walls that push, with their depths, or all of them if no place was found.
NearestPlace nearest_place(Walls& walls, vec3 tip);

/// Largest pull along the walls (planes at touched surfaces) at which friction holds a proxy at x: the sum of
/// depth times friction (m). With one stiffness, forces are in proportion to lengths.
double friction_reach(const Scene& scene, const Walls& walls, vec3 x, bool sliding);

/// Whether the surface of a wall (a plane that holds the proxy) still is at the proxy, which may have moved
/// past an edge.
bool stands(const Scene& scene, const Wall& wall, vec3 x);

/// Whether the proxy still is at the surfaces of all walls (planes that hold it).
bool all_stand(const Scene& scene, const Walls& walls, vec3 x);

/// Sorts the walls (planes at touched surfaces) by the depth of the tip behind them, the deepest first. There
/// are at most four.
void most_loaded_first(Walls& walls);

/// State of the proxy on its path to the tip.
struct SlideState {
    vec3 x{};       ///< position of the proxy (m)
    Walls walls{};  ///< walls (planes at touched surfaces) that hold it there
    /// Number of sweeps (tests of a path against one surface) that the proxy's motion on round bodies may
    /// still make in this tick. It bounds the time that a tick takes.
    int sweeps_left{2400};
    bool slid{};     ///< the proxy has moved along a wall
    bool limited{};  ///< the proxy was held at the end of the space whose surfaces are known
};

}  // namespace thaum::haptics
