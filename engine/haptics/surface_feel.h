// haptics/surface_feel.h: how deep the tip feels to be behind a wall, and how far friction holds the proxy.
#pragma once
#include <span>

#include "haptics/surface_walls.h"

namespace thaum::haptics {

/// A wall's push with its texture.
struct TexturedPush {
    double depth{};    ///< depth that is felt (m)
    vec3 direction{};  ///< direction of the push; unit, but longer for bumps
};

TexturedPush textured_push(const Scene& scene, const Wall& wall, vec3 x);

/// Pull along the walls up to which friction holds a proxy at x: the sum of the depths times the friction (m).
double friction_reach(const Scene& scene, std::span<const Wall> walls, vec3 x, bool sliding);

inline double friction_reach(const Scene& scene, const Walls& walls, vec3 x, bool sliding) {
    return friction_reach(scene, std::span(walls.items).first(walls.count), x, sliding);
}

}  // namespace thaum::haptics
