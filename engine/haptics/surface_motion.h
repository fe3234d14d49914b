// haptics/surface_motion.h: how moving bodies take the proxy along before it goes towards the tip.
#pragma once
#include "haptics/surface_scene.h"

namespace thaum::haptics {

/// Place to which the body that bore most of the last push carries the proxy (m).
vec3 carried(const Scene& scene, const SurfaceState& state);

/// Place of the proxy after the bodies' motion, outside all of them (m). Between two bodies that close on it one must
/// give.
vec3 pushed_out(const Scene& scene, const SurfaceState& state, vec3 start);

}  // namespace thaum::haptics
