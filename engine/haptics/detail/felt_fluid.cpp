#include "haptics/detail/felt_fluid.h"

#include <algorithm>

namespace thaum::haptics {
namespace {

/// Largest change of the felt viscosity in a tick, as a share of the device's largest damping. Without this
/// limit the force would jump: neighbouring materials of a volume may differ tenfold, and the material at the
/// tip changes from one voxel to the next.
constexpr double viscosity_pace = 1.0 / 32;

/// Moves the felt viscosity towards that of the space around the tip. Returns true if the space became
/// viscous, or ceased to be, at which the felt viscosity jumps.
bool follow_viscosity(const Servo& servo, ServoState& state, const HapticModel& model) {
    const double wanted = model.viscosity > 0 ? std::min(model.viscosity, servo.max_damping) : 0;
    const bool jumped = (wanted > 0) != (state.viscosity > 0);
    const double pace = viscosity_pace * servo.max_damping, before = state.viscosity;
    state.viscosity = jumped ? wanted : std::clamp(wanted, before - pace, before + pace);
    return jumped;
}

}  // namespace

FeltFluid feel_space(const Servo& servo, ServoState& state, const HapticModel& model, std::uint32_t age,
                     const Tip& tip, Sources& sources) {
    FeltFluid felt;
    const bool viscous = follow_viscosity(servo, state, model);
    felt.switched = detect_fluid_switch(state.fluid, model.fluid) || viscous;
    if (state.viscosity > 0) sources.passive -= state.viscosity * prompt_velocity(state, servo.quantum);
    if (state.fluid.number == 0) return felt;
    felt.forces = feel_fluid(model.fluid, state.fluid, {tip.position, tip.velocity, age, servo.max_damping});
    sources.passive += felt.forces.passive;
    sources.active += felt.forces.active;
    return felt;
}

}  // namespace thaum::haptics
