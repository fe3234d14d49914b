// haptics/surface/detail/motion.h: motion of the proxy by moving bodies, before it moves towards the tip.
#pragma once
#include "haptics/surface/detail/scene.h"

namespace thaum::haptics {

/// Position to which the body on which the proxy pressed most in the last tick carries it (m).
vec3 carried(const Scene& scene, const SurfaceState& state);

/// Position of the proxy after the bodies' motion, outside all of them (m). If two bodies close on it, the
/// proxy stays inside one of them.
vec3 pushed_out(const Scene& scene, const SurfaceState& state, vec3 start);

}  // namespace thaum::haptics
