// fluid/cuts.h: where a wall of any shape cuts the faces of a lattice.
//
// The velocity on a face that a wall cuts is the mean over the open part of that face, so that what flows through is exact: the open
// share times the velocity. To second order the mean is the velocity in the middle of the open part. A wall that holds the fluid makes
// the velocity grow in proportion to the distance from the wall, which relates the middle of the open part to the middle of the face.
#pragma once
#include <functional>

#include "core/maths.h"
#include "fluid/lattice.h"

namespace thaum::fluid {

/// Share of a place that is solid, 0 to 1, by the place (m). The wall stands where it is one half.
using SolidShare = std::function<double(vec3)>;

/// The open part of a face.
struct OpenPart {
    double share{};  ///< open area by the whole area
    vec3 middle{};   ///< middle of the open area (m)
};

/// `low`: the corner of the face with the least coordinates (m).
OpenPart open_part(const SolidShare& solid, vec3 low, std::size_t axis, double h);

inline bool is_open(const SolidShare& solid, vec3 place) { return solid(place) < 0.5; }

/// The length of the way from an open place to the wall, as a part of `step` (m); `parts_most` where no wall is found until there.
double way_to_wall(const SolidShare& solid, vec3 from, vec3 step, int parts_most);

/// Distance from a place to the wall (m), by the ways along the axes to a plane; 0 in the solid, `4 h` where no wall is near.
double distance_to_wall(const SolidShare& solid, vec3 place, double h);

}  // namespace thaum::fluid
