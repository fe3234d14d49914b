#include "game/wands/wand_coupling.h"

namespace thaum::game::inline wands {

vec3 coupled_velocity(const physics::Physics& physics, physics::Key body, const WandCoupling& coupling) {
    return physics.velocity(body) + coupling.owed;
}

// The physics moves a free body by v0 dt + g dt^2/2, so the velocity v0 is chosen to give exactly the
// displacement of `result`. The velocity at the end, v0 + g dt, may then differ from that of `result`. The
// body gets the difference (`owed`) in the next step.
void apply_coupling(physics::Physics& physics, physics::Key body, const haptics::CouplingResult& result,
                    double dt, WandCoupling& coupling) {
    const auto& state = physics.state(body);
    const vec3 fall = physics.settings().gravity * dt;
    const vec3 start = result.displacement / dt - 0.5 * fall;
    const vec3 end = state.velocity + coupling.owed + result.velocity_change;
    physics.apply_central_impulse(body, physics.desc(body).mass * (start - state.velocity));
    coupling.expected = start + fall;
    coupling.owed = end - coupling.expected;
}

void end_coupling(physics::Physics& physics, physics::Key body, WandCoupling& coupling) {
    physics.apply_central_impulse(body, physics.desc(body).mass * coupling.owed);
    coupling = {};
}

// The rope's length follows the spring, gravity along the rope and the centrifugal acceleration. The equation
// is solved exactly, with gravity and centrifugal acceleration held constant over the step. The force acts
// along the rope's direction in the middle of the step. With the direction at the start, the swing would gain
// energy: 5 % a minute with steps of 1 ms.
std::optional<haptics::CouplingResult> hang(const Rope& rope, double mass, vec3 place, vec3 velocity,
                                            vec3 gravity, double dt) {
    const vec3 to = rope.anchor - place;
    const double distance = glm::length(to);
    if (distance <= rope.length || distance < 1e-9) return std::nullopt;
    const vec3 way = to / distance;
    const double towards = glm::dot(velocity, way);
    const vec3 across = velocity - way * towards;
    const double bend = glm::dot(gravity, way) - glm::dot(across, across) / distance;
    const auto step = haptics::coupling_step({rope.stiffness, rope.damping, 0}, 1 / mass, 0, dt);
    auto result = haptics::couple(step, {.hand = {-rope.length, 0, 0},
                                         .hand_velocity = {-rope.growth, 0, 0},
                                         .object = {-distance, 0, 0},
                                         .object_velocity = {towards, 0, 0},
                                         .drag_velocity = {},
                                         .object_acceleration = {bend, 0, 0}});
    const vec3 middle = rope.anchor - place - velocity * (dt / 2);
    const double span = glm::length(middle);
    const vec3 pull = span > 1e-9 ? middle / span : way;
    const double pulled = result.displacement.x - towards * dt - bend * dt * dt / 2;
    result.displacement = velocity * dt + gravity * (dt * dt / 2) + pull * pulled;
    result.velocity_change = gravity * dt + pull * (result.impulse.x / mass);
    result.mean_force = pull * result.mean_force.x;
    result.impulse = pull * result.impulse.x;
    return result;
}

}  // namespace thaum::game::inline wands
