// haptics/detail/sources.h: forces of the servo's sources in one tick, which the energy account limits.
#pragma once
#include "core/maths.h"

namespace thaum::haptics {

/// Forces on the tip by kind of source (N). Passive sources give back at most the energy that they received;
/// active ones have a budget (haptics/energy.h).
struct Sources {
    vec3 passive{}, active{};
    /// Part of the passive force by springs whose other end is tied to a movable thing of the world.
    vec3 world{};
    vec3 springs{};  ///< part of the passive force by springs, which can give energy back
    vec3 tether{};   ///< the part of `springs` by the tether, a spring from the tip to a thing of the world
};

}  // namespace thaum::haptics
