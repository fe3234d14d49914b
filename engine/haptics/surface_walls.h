// haptics/surface_walls.h: planes that hold the proxy, and the place before all of them that is nearest to the tip.
#pragma once
#include "haptics/surface_scene.h"

namespace thaum::haptics {

inline constexpr std::size_t most_walls = 4;

/// Plane through the place where the proxy touches a surface: x is free where normal.x >= offset.
struct Wall {
    vec3 normal{};
    double offset{};  ///< m
    double depth{};   ///< how far it pushes the proxy from the tip (m); 0 until the next place is sought
    std::uint32_t surface{};  ///< index in the patch
    bool met_here{};          ///< the proxy has not moved since it met the wall
};

struct Walls {
    std::array<Wall, most_walls> items{};
    std::size_t count{};
};

/// Tangent plane of a surface at its gap, from the distance known at p.
inline Wall wall_at(const Scene& scene, vec3 p, Distance d, std::uint32_t i) {
    return {d.normal, glm::dot(d.normal, p) - d.value + scene.gap[i], 0, i};
}

/// Adds a wall; it replaces an earlier one of the same surface, since a round surface has another plane at each place.
void add_wall(Walls& walls, const Wall& wall);

/// Distance of the tip behind a wall (m).
inline double depth_behind(const Wall& wall, vec3 tip) { return wall.offset - glm::dot(wall.normal, tip); }

/// Depths of two walls that both push: the tip's depth behind them is `a` and `b` (m), their normals have the product
/// g.
struct Depths {
    double a{}, b{};
};
inline Depths depths_of_two(double a, double b, double g, double sine2) {
    return {(a - g * b) / sine2, (b - g * a) / sine2};
}

struct NearestPlace {
    vec3 place{};
    bool found{};  ///< false where no place is before all walls
};

/// Finds the only place before all walls that is nearest to the tip, by trying every set of up to three walls. Keeps
/// the walls
/// that push, with their depths.
NearestPlace nearest_place(Walls& walls, vec3 tip);

}  // namespace thaum::haptics
