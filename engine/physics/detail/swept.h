// physics/detail/swept.h: spheres inside a body that represent it on a long path.
//
// A fast body must not pass through a wall between two steps. Exact casts exist for spheres only
// (cast.h), so a few spheres that fill the corners and the middle of the body are cast instead. They
// lie slightly inside its surface. The body therefore stops that far inside the wall, and the next step
// finds a contact with the right normal.
#pragma once
#include <array>

#include "physics/physics.h"

namespace thaum::physics::detail {

/// Spheres that are cast instead of one body, and the path length from which on they are cast.
struct InnerSpheres {
    std::array<vec3, 24> centres{};  ///< centres of the spheres (m, body frame)
    std::size_t count{};
    double radius{};  ///< radius of all spheres (m)
    /// Length of a path up to which a step needs no cast, because Bullet finds the contacts in time (m).
    double min_path{};
    double centre_gap{};  ///< distance from a wall at which the body's centre is stopped (m)

    const vec3* begin() const { return centres.data(); }
    const vec3* end() const { return centres.data() + count; }
};

/// The spheres to cast for a body of this description. A mesh has none, since it never moves.
InnerSpheres inner_spheres(const BodyDesc&);

}  // namespace thaum::physics::detail
