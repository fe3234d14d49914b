// haptics/detail/felt_patch.h: what the servo feels of a patch of surfaces: its force, what moves and what it
// stores, and whether a body came or went under the tip.
#pragma once
#include "haptics/servo.h"

namespace thaum::haptics {

struct SurfaceForces {
    vec3 force{};       ///< force on the hand (N)
    vec3 world_step{};  ///< motion of the touched body over the tip in the last tick (m)
    double stored{};    ///< energy that a spring of this force and stretch would hold (J)
    double stretch{};   ///< distance from the tip to the proxy (m)
    bool active{};      ///< a texture is an active source
    /// The patch jumped, or a touched body appeared, went or has another stiffness.
    bool switched{};
};

/// Evaluates the model's patch, `age` ticks after it was made.
SurfaceForces feel_surfaces(ServoState& state, const HapticModel& model, std::uint32_t age, const Tip& tip);

}  // namespace thaum::haptics
