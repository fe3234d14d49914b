// game/wands/tug.h: moves a body of the physics by a virtual coupling, by force alone, so that contacts still hold it.
//
// The coupling knows the body's exact path over the step (haptics/coupling.h). Bullet moves a body by the velocity it has after
// forces, so that velocity is chosen to give the right displacement; what is then missing to the right velocity is owed, and
// given with the next step's impulse.
#pragma once
#include <optional>

#include "ecs/component.h"
#include "haptics/coupling.h"
#include "physics/physics.h"

namespace thaum::game {

/// What one step leaves for the next.
struct Tug {
    vec3 owed{};      ///< m/s
    vec3 expected{};  ///< m/s, of the body after the step if nothing else touches it
    static constexpr auto fields() {
        return std::tuple(ecs::field("owed", &Tug::owed), ecs::field("expected", &Tug::expected));
    }
};

/// Velocity of the body with what is owed to it, m/s.
vec3 tugged_velocity(const physics::Physics& physics, physics::Key body, const Tug& tug);

/// Gives the body the impulse by which it follows `result` over the coming step of dt seconds, where it is free. The coupling was
/// solved for that step and with tugged_velocity.
void give_tug(physics::Physics& physics, physics::Key body, const haptics::CouplingResult& result, double dt,
              Tug& tug);

/// Pays what is owed: the coupling ends.
void end_tug(physics::Physics& physics, physics::Key body, Tug& tug);

/// A spring and damper to a point that stands still; it only pulls.
struct Rope {
    vec3 anchor{};       ///< m
    double length{};     ///< m, of the rope when it is slack
    double growth{};     ///< m/s, of that length
    double stiffness{};  ///< N/m
    double damping{};    ///< N s/m, along the rope
};

/// What the rope and gravity (m/s^2) do in dt seconds to a body of `mass` kg whose point `place` (m) hangs on it; nothing where it is
/// slack. Of second order in dt; along the rope exact but for the turn within the step.
std::optional<haptics::CouplingResult> hang(const Rope& rope, double mass, vec3 place, vec3 velocity,
                                            vec3 gravity, double dt);

}  // namespace thaum::game
