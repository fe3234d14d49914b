// game/wands/tug.h: moves a body of the physics by a virtual coupling, by force alone, so that contacts still hold it.
//
// The coupling knows the body's exact path over the step (haptics/coupling.h). Bullet moves a body by the velocity it has after
// forces, so that velocity is chosen to give the right displacement; what is then missing to the right velocity is owed, and
// given with the next step's impulse.
#pragma once
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

/// Gives the body the impulse by which it follows `result` over the coming step, where it is free. The coupling was solved with
/// tugged_velocity.
void give_tug(physics::Physics& physics, physics::Key body, const haptics::CouplingResult& result, Tug& tug);

/// Pays what is owed: the coupling ends.
void end_tug(physics::Physics& physics, physics::Key body, Tug& tug);

}  // namespace thaum::game
