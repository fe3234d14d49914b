// physics/detail/swept.h: spheres inside a body that stand for it on a long way.
//
// A fast body must not pass through a wall between two steps. Exact casts of spheres exist (cast.h), of other shapes not; so a few
// spheres that fill its corners and its middle are cast instead. They lie `skin` inside the surface: the body stops with so much
// of it in the wall, and the next step finds a contact with the right normal.
#pragma once
#include <array>

#include "physics/physics.h"

namespace thaum::physics::detail {

struct InnerSpheres {
    std::array<vec3, 24> centres{};  ///< (m, body frame)
    std::size_t count{};
    double radius{};      ///< the same for all (m)
    double least_path{};  ///< a shorter way in a step needs no cast: its contacts are found in time (m)
    double centre_gap{};  ///< least distance that the body's centre keeps from a wall (m)

    const vec3* begin() const { return centres.data(); }
    const vec3* end() const { return centres.data() + count; }
};

/// None for a mesh, which never moves.
InnerSpheres inner_spheres(const BodyDesc&);

}  // namespace thaum::physics::detail
