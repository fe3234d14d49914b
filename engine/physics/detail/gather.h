// physics/detail/gather.h: collects the nearest surfaces in an array of fixed size.
#pragma once
#include <span>

#include "physics/physics.h"

namespace thaum::physics::detail {

/// Surfaces found so far. When the array is full, the farthest surface is replaced.
struct NearestSurfaces {
    std::span<Nearby> into;
    NearbyResult found;  ///< what was found; the caller first sets its `reach` to the requested radius
};

inline bool wanted(const NearestSurfaces& gathering, double distance) {
    return distance <= gathering.found.reach;
}

/// Adds a surface that is not farther than the `reach` of the search.
void add(NearestSurfaces&, const Nearby&);

}  // namespace thaum::physics::detail
