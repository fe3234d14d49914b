// haptics/surface/detail/slide.h: path of the proxy towards the tip within one tick.
#pragma once
#include "haptics/surface/detail/walls.h"

namespace thaum::haptics {

/// Moves from contact to contact until no place is nearer to the tip, or friction holds the proxy.
SlideState slide_to(const Scene& scene, vec3 start, vec3 tip, bool was_sliding);

}  // namespace thaum::haptics
