// game/arena/basin.h: the space inside a bowl below the surface of its contents.
#pragma once
#include <cmath>
#include <vector>

#include "game/arena/solids.h"

namespace thaum::game::inline arena {

/// The space inside a bowl below the surface of its contents.
struct Basin {
    double radius{};  ///< greatest radius of the contents (m)
    double depth{};   ///< greatest depth of the contents, below their surface (m)
    /// Outline of the space as points (radius, height) from the edge of the surface, at height 0, down to the
    /// middle of the bottom (m). Heights are zero or negative.
    std::vector<vec2> profile;
};

/// Height of the contents' surface above the middle of the bowl's height (m). `filled`: height of the surface
/// above the bowl's lowest point, as a share of the bowl's height.
inline double level_of(const BowlSize& bowl, double filled) { return bowl.height * (filled - 0.5); }

Basin basin_of(const BowlSize& bowl, double filled);

/// Horizontal length of a vector, which is its distance from the vertical axis (m).
inline double off_axis(vec3 way) { return std::sqrt(way.x * way.x + way.z * way.z); }

/// Radius of the basin at a height above the surface of the contents (m). 0 below the floor; the radius at
/// the surface for positive heights.
double width_at(const Basin& basin, double height);

}  // namespace thaum::game::inline arena
