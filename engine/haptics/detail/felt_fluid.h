// haptics/detail/felt_fluid.h: forces on the hand by the space around the tip in one tick of the servo: by
// its viscosity, and by a stirred fluid.
#pragma once
#include "haptics/detail/sources.h"
#include "haptics/servo.h"

namespace thaum::haptics {

/// Forces of a stirred fluid on the hand in one tick.
struct FeltFluid {
    FluidForces forces{};
    bool switched{};  ///< the fluid, or the viscosity of the space, appeared, ended or jumped
};

/// Adds the forces of a viscous space and of a stirred fluid to `sources`, the tick's forces by kind. The
/// haptic model is `age` ticks old.
FeltFluid feel_space(const Servo& servo, ServoState& state, const HapticModel& model, std::uint32_t age,
                     const Tip& tip, Sources& sources);

}  // namespace thaum::haptics
