// game/arena/basin.h: the space inside a bowl below the surface of its contents.
#pragma once
#include <cmath>
#include <vector>

#include "game/arena/solids.h"

namespace thaum::game::inline arena {

/// The space inside a bowl below the surface of its contents.
struct Basin {
    double radius{};  ///< greatest radius (m)
    double depth{};   ///< greatest depth (m)
    /// Points (radius, height) from the edge of the surface, at height 0, down to the middle of the bottom
    /// (m). Heights are zero or negative.
    std::vector<vec2> profile;
};

/// Height of the contents' surface above the bowl's middle (m).
inline double level_of(const BowlSize& bowl, double filled) { return bowl.height * (filled - 0.5); }

Basin basin_of(const BowlSize& bowl, double filled);

/// Horizontal length of a vector (m).
inline double off_axis(vec3 way) { return std::sqrt(way.x * way.x + way.z * way.z); }

/// Radius of the basin at a height above the surface of the contents (m). 0 below the floor; the radius at
/// the surface for positive heights.
double width_at(const Basin& basin, double height);

}  // namespace thaum::game::inline arena
