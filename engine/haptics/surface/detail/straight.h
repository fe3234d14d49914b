// haptics/surface/detail/straight.h: one straight move of the proxy, where no wall (plane at a surface) is
// round.
#pragma once
#include "haptics/surface/detail/walls.h"

namespace thaum::haptics {

enum class Straight : std::uint8_t { met_a_wall, arrived, limited };

/// Moves straight towards the goal until a surface, friction, or the end of the space whose surfaces are
/// known stops the proxy.
Straight go_straight(const Scene& scene, SlideState& slide, vec3 goal, bool was_sliding);

}  // namespace thaum::haptics
