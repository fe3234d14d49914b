#include "game/wands/tug.h"

#include "game/match/stage.h"

namespace thaum::game {

vec3 tugged_velocity(const physics::Physics& physics, physics::Key body, const Tug& tug) {
    return physics.velocity(body) + tug.owed;
}

// A free body flies exactly: v0 dt + g dt^2/2, and v0 + g dt at the end.
void give_tug(physics::Physics& physics, physics::Key body, const haptics::CouplingResult& result, Tug& tug) {
    const auto& state = physics.state(body);
    const vec3 fall = physics.settings().gravity * physics_dt;
    const vec3 start = result.displacement / physics_dt - 0.5 * fall;
    const vec3 end = state.velocity + tug.owed + result.velocity_change;
    physics.apply_central_impulse(body, physics.desc(body).mass * (start - state.velocity));
    tug.expected = start + fall;
    tug.owed = end - tug.expected;
}

void end_tug(physics::Physics& physics, physics::Key body, Tug& tug) {
    physics.apply_central_impulse(body, physics.desc(body).mass * tug.owed);
    tug = {};
}

}  // namespace thaum::game
