// fluid/detail/cuts.h: geometry of the faces of a lattice that a wall of any shape cuts.
//
// The velocity on a cut face is the mean over its open part. The flow through the face is then exactly
// the open share times the velocity. To second order, the mean is the velocity at the centre of the
// open part. At a no-slip wall the velocity grows in proportion to the distance from the wall. This
// relates the velocity at the centre of the open part to the velocity at the centre of the face.
#pragma once
#include <functional>

#include "core/maths.h"
#include "fluid/lattice.h"

namespace thaum::fluid {

/// Function that gives the solid share of a place (m), 0 to 1. The wall is the surface where it is 0.5.
using SolidShare = std::function<double(vec3)>;

/// The part of a face that no solid covers.
struct OpenPart {
    double share{};  ///< open area divided by the whole area
    vec3 middle{};   ///< centre of the open area (m)
};

/// Computes the open part of a face across `axis`, a square of edge h (m). `low` is its corner with the
/// lowest coordinates (m).
OpenPart open_part(const SolidShare& solid, vec3 low, std::size_t axis, double h);

inline bool is_open(const SolidShare& solid, vec3 place) { return solid(place) < 0.5; }

/// Distance from an open place to the wall along `step`, as a multiple of `step`; `max_parts` if no wall is
/// that near.
double way_to_wall(const SolidShare& solid, vec3 from, vec3 step, int max_parts);

/// Distance from a place to the wall (m), assumed to be a plane, from its distances along the axes; 0 in the
/// solid, `4 h` if no wall is near.
double distance_to_wall(const SolidShare& solid, vec3 place, double h);

}  // namespace thaum::fluid
