// haptics/surface_slide.h: path of the proxy towards the tip within one tick.
#pragma once
#include "haptics/surface_walls.h"

namespace thaum::haptics {

/// State of the proxy on its path to the tip.
struct SlideState {
    vec3 x{};       ///< position of the proxy (m)
    Walls walls{};  ///< walls that hold it there
    /// Remaining sweeps against a surface for round paths in this tick. The limit bounds the time.
    int sweeps_left{2400};
    bool slid{};     ///< the proxy has moved along a wall
    bool limited{};  ///< the end of the patch's reach held the proxy
};

/// Moves from contact to contact until no place is nearer to the tip, or friction holds the proxy.
SlideState slide_to(const Scene& scene, vec3 start, vec3 tip, bool was_sliding);

/// Whether a wall still exists at the proxy, which may have moved round an edge.
bool stands(const Scene& scene, const Wall& wall, vec3 x);

}  // namespace thaum::haptics
