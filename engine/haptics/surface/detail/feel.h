// haptics/surface/detail/feel.h: depth of the tip behind a textured wall (a plane at a touched surface), and
// the force of all walls on the hand.
#pragma once
#include <array>

#include "haptics/surface/detail/walls.h"

namespace thaum::haptics {

/// Push of a wall (a plane at a touched surface, walls.h) on the tip, with the surface's texture.
struct TexturedPush {
    double depth{};    ///< depth of the tip that the hand feels, texture included (m)
    vec3 direction{};  ///< direction of the push; a unit vector except for bumps, where it is longer
};

TexturedPush textured_push(const Scene& scene, const Wall& wall, vec3 x);

/// Part of the force on the hand that one wall exerts.
struct Share {
    vec3 force{};    ///< part of the force on the hand by this wall (N)
    double depth{};  ///< depth of the tip behind the wall that the hand feels, texture included (m)
};
using Shares = std::array<Share, max_walls>;

/// Computes the force on the hand (N), and each wall's share of it. A share is the force of the wall's own
/// push plus a part of friction and damping. Friction and damping belong to all walls together, and are
/// divided in proportion to depth.
vec3 force_of(const Scene& scene, const SlideState& slide, const SurfaceTip& tip, Shares& shares);

}  // namespace thaum::haptics
