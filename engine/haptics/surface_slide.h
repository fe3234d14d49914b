// haptics/surface_slide.h: the proxy's way towards the tip within one tick.
#pragma once
#include "haptics/surface_walls.h"

namespace thaum::haptics {

/// The proxy on its way to the tip.
struct SlideState {
    vec3 x{};       ///< place of the proxy (m)
    Walls walls{};  ///< walls that hold it there
    /// Sweeps against a surface that round paths may still make in this tick, so that it ends in time.
    int sweeps_left{2400};
    bool slid{};     ///< it has moved along a wall
    bool limited{};  ///< it was held at the end of the patch's reach
};

/// Goes from contact to contact until nothing is nearer to the tip, or friction holds.
SlideState slide_to(const Scene& scene, vec3 start, vec3 tip, bool was_sliding);

/// Whether a wall still stands where the proxy is: the proxy may have gone round an edge.
bool stands(const Scene& scene, const Wall& wall, vec3 x);

}  // namespace thaum::haptics
