// haptics/surface/detail/feel.h: depth of the tip behind a textured wall, and the reach of friction.
#pragma once
#include "haptics/surface/detail/walls.h"

namespace thaum::haptics {

/// Push of a wall with its texture.
struct TexturedPush {
    double depth{};    ///< depth that the hand feels (m)
    vec3 direction{};  ///< direction of the push; a unit vector except for bumps, where it is longer
};

TexturedPush textured_push(const Scene& scene, const Wall& wall, vec3 x);

/// Largest pull along the walls at which friction holds a proxy at x: the sum of depth times friction (m).
double friction_reach(const Scene& scene, const Walls& walls, vec3 x, bool sliding);

}  // namespace thaum::haptics
