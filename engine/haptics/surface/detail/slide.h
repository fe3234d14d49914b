// haptics/surface/detail/slide.h: path of the proxy towards the tip within one tick.
#pragma once
#include "haptics/surface/detail/walls.h"

namespace thaum::haptics {

/// Moves the proxy from contact to contact until no place that it can reach is nearer to the tip, or friction
/// holds it.
SlideState slide_to(const Scene& scene, vec3 start, vec3 tip, bool was_sliding);

}  // namespace thaum::haptics
