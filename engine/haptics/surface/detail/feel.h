// haptics/surface/detail/feel.h: depth of the tip behind a textured wall, and the force of all walls.
#pragma once
#include <array>

#include "haptics/surface/detail/walls.h"

namespace thaum::haptics {

/// Push of a wall with its texture.
struct TexturedPush {
    double depth{};    ///< depth that the hand feels (m)
    vec3 direction{};  ///< direction of the push; a unit vector except for bumps, where it is longer
};

TexturedPush textured_push(const Scene& scene, const Wall& wall, vec3 x);

/// Share of a wall in the force on the hand.
struct Share {
    vec3 force{};    ///< N
    double depth{};  ///< depth that is felt (m)
};
using Shares = std::array<Share, max_walls>;

/// Computes the force on the hand (N). Each wall's share is its own push, plus a part of the common force in
/// proportion to its depth.
vec3 force_of(const Scene& scene, const SlideState& slide, const SurfaceTip& tip, Shares& shares);

}  // namespace thaum::haptics
