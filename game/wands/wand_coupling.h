// game/wands/wand_coupling.h: moves a physics body by a virtual coupling, by impulses alone, so that contacts
// still stop the body.
//
// The coupling computes the body's exact path over the step (haptics/coupling.h). Bullet moves a body by the
// velocity after all forces. So that velocity is chosen to give the right displacement. The difference to the
// right velocity is kept as owed and given with the next step's impulse.
#pragma once
#include <optional>

#include "ecs/component.h"
#include "haptics/coupling.h"
#include "physics/physics.h"

namespace thaum::game {

/// State of a wand coupling between two steps.
struct WandCoupling {
    vec3 owed{};      ///< velocity still owed to the body (m/s)
    vec3 expected{};  ///< velocity of the body after the step if nothing else touches it (m/s)
    THAUM_FIELDS(WandCoupling, owed, expected);
};

/// Velocity of the body plus the velocity owed to it (m/s).
vec3 coupled_velocity(const physics::Physics& physics, physics::Key body, const WandCoupling& coupling);

/// Gives the body the impulse by which a free body follows `result` over the coming step of dt seconds.
/// `result` must be solved for that step and with coupled_velocity.
void apply_coupling(physics::Physics& physics, physics::Key body, const haptics::CouplingResult& result,
                    double dt, WandCoupling& coupling);

/// Gives the body the velocity still owed and ends the coupling.
void end_coupling(physics::Physics& physics, physics::Key body, WandCoupling& coupling);

/// A spring and damper to a fixed point, which only pulls.
struct Rope {
    vec3 anchor{};       ///< fixed end (m, world)
    double length{};     ///< length of the slack rope (m)
    double growth{};     ///< rate of change of `length` (m/s)
    double stiffness{};  ///< stiffness (N/m)
    double damping{};    ///< damping along the rope (N s/m)
};

/// Effect of rope and gravity (m/s^2) over dt seconds on a body of `mass` kg that hangs at its point `place`
/// (m, world). std::nullopt if the rope is slack. Second order in dt. Along the rope the result is exact,
/// except for the rotation within the step.
std::optional<haptics::CouplingResult> hang(const Rope& rope, double mass, vec3 place, vec3 velocity,
                                            vec3 gravity, double dt);

}  // namespace thaum::game
