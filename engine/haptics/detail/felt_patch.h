// haptics/detail/felt_patch.h: contact of the tip with the patch, the surfaces near it, in one tick of the
// servo: the force on the hand, the motion of the touched body, the stored energy, and whether a body came or
// went under the tip.
#pragma once
#include "haptics/servo.h"

namespace thaum::haptics {

struct SurfaceForces {
    vec3 force{};  ///< force on the hand (N)
    /// Motion of the touched body in the last tick (m). The change of the contact offset, which shifts the
    /// tip out of walls that the player walks into, is subtracted. The work of the force along this step is
    /// the world's, not the hand's.
    vec3 world_step{};
    double stored{};   ///< energy that a spring of `force` and `stretch` would hold (J)
    double stretch{};  ///< distance from the tip to the proxy, its position outside of the surfaces (m)
    bool active{};     ///< a texture of the patch is an active source: it may give more energy than it got
    /// The force may have jumped: the patch (the surfaces near the tip) is a new one, or a touched body
    /// appeared, went or has another stiffness.
    bool switched{};
};

/// Computes the contact of the tip with the haptic model's patch (surfaces near the tip), `age` ticks after
/// the model was made.
SurfaceForces feel_surfaces(ServoState& state, const HapticModel& model, std::uint32_t age, const Tip& tip);

}  // namespace thaum::haptics
