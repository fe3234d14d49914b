// physics/detail/gather.h: the nearest surfaces in an array of fixed size.
#pragma once
#include <span>

#include "physics/physics.h"

namespace thaum::physics::detail {

/// Grows up to the array's size; then what is farther makes room.
struct NearestSurfaces {
    std::span<Nearby> into;
    NearbyResult found;  ///< reach: begins as the radius asked for
};

inline bool wanted(const NearestSurfaces& gathering, double distance) {
    return distance <= gathering.found.reach;
}

/// What is wanted.
void add(NearestSurfaces&, const Nearby&);

}  // namespace thaum::physics::detail
