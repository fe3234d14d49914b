// game/wands/wand_coupling.h: moves a physics body by a virtual coupling, by impulses alone, so that contacts
// still stop the body.
//
// The coupling computes the body's exact path over the step (haptics/coupling.h). The physics moves a free
// body by its velocity at the start of the step and by gravity, so that velocity is chosen to give the right
// displacement. The difference between exact and given velocity at the end of the step is stored as `owed`,
// and added by the next step's impulse.
#pragma once
#include <optional>

#include "ecs/component.h"
#include "haptics/coupling.h"
#include "physics/physics.h"

namespace thaum::game::inline wands {

/// State of a wand coupling between two steps.
struct WandCoupling {
    vec3 owed{};      ///< difference between exact and given velocity at the end of the last step, which the
                      ///< body gets in the next one (m/s)
    vec3 expected{};  ///< velocity of the body after the step if nothing else acts on it (m/s)
    THAUM_FIELDS(WandCoupling, owed, expected);
};

/// Exact velocity of the body: its present velocity plus the part that the last step could not give (`owed`)
/// (m/s).
vec3 coupled_velocity(const physics::Physics& physics, physics::Key body, const WandCoupling& coupling);

/// Gives the body the impulse with which a free body follows `result` over the coming step of dt seconds.
/// `result` must have been computed for that step, from coupled_velocity.
void apply_coupling(physics::Physics& physics, physics::Key body, const haptics::CouplingResult& result,
                    double dt, WandCoupling& coupling);

/// Ends the coupling. The velocity `owed`, which the body would have got in the next step, is added at once.
void end_coupling(physics::Physics& physics, physics::Key body, WandCoupling& coupling);

/// A spring and damper to a fixed point, which only pulls.
struct Rope {
    vec3 anchor{};       ///< position of the rope's fixed end (m, world)
    double length{};     ///< unstretched length of the rope (m)
    double growth{};     ///< rate of change of `length` (m/s)
    double stiffness{};  ///< stiffness of the rope (N/m)
    double damping{};    ///< damping along the rope (N s/m)
};

/// Effect of the rope and of gravity (m/s^2) over dt seconds on a body of `mass` kg that hangs by its point
/// `place` (m, world). std::nullopt if the rope is slack. Second order in dt. Along the rope the result is
/// exact, except for the rotation within the step.
std::optional<haptics::CouplingResult> hang(const Rope& rope, double mass, vec3 place, vec3 velocity,
                                            vec3 gravity, double dt);

}  // namespace thaum::game::inline wands
