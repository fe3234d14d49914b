#include "haptics/coupling.h"

#include "core/assert.h"

namespace thaum::haptics {
namespace {

bool is_valid(const Coupling& c) { return c.stiffness >= 0 && c.damping >= 0 && c.drag >= 0; }

}  // namespace

CouplingStep coupling_step(Coupling coupling, double inverse_object, double inverse_hand, double dt) {
    THAUM_ASSERT(is_valid(coupling) && inverse_object >= 0 && inverse_hand >= 0 && dt > 0,
                 "a coupling needs a step and nothing negative");
    THAUM_ASSERT(coupling.drag == 0 || inverse_hand == 0, "a drag needs a prescribed hand");
    // Inverse mass of the relative motion of object and hand (1/kg).
    const double inverse_mass = inverse_object + inverse_hand;
    CouplingStep step{.coupling = coupling, .inverse_object = inverse_object, .inverse_hand = inverse_hand};
    step.share = inverse_mass > 0 ? inverse_object / inverse_mass : 0;
    step.relative = {.decay = (coupling.damping * inverse_mass + coupling.drag * inverse_object) / 2,
                     .frequency2 = coupling.stiffness * inverse_mass};
    step.response = response(step.relative, dt);
    return step;
}

// With e = P_HIP - P_obj (hand's point minus object), object and hand obey e'' + 2 decay e' + frequency2 e =
// g, where g comes from constant forces and from the drag alone. The integral of stiffness e + damping e'
// over the step gives the impulse. The coefficients of this integral are all positive, so no digits are lost.
// The object moves like the centre of mass minus its share of e. With a prescribed hand, the centre of mass
// is the hand.
CouplingResult couple(const CouplingStep& step, const CouplingState& state) {
    const auto& [k, b, drag] = step.coupling;
    const auto& [t, s, s1, s2] = step.response;
    const vec3 e = state.hand - state.object;
    const vec3 e_rate = state.hand_velocity - state.object_velocity;
    const vec3 g =
        drag * step.inverse_object * (state.hand_velocity - state.drag_velocity) - state.object_acceleration;
    const vec3 e_bend = g - 2 * step.relative.decay * e_rate - step.relative.frequency2 * e;

    CouplingResult result;
    result.impulse =
        k * (s + drag * step.inverse_object * s1) * e + (b * s + k * s1) * e_rate + (b * s1 + k * s2) * g;
    result.mean_force = result.impulse / t;

    const vec3 e_rate_change = s * e_bend - step.relative.frequency2 * s1 * e_rate;
    const vec3 e_change = t * e_rate + s1 * e_bend - step.relative.frequency2 * s2 * e_rate;
    const vec3 centre_velocity = state.object_velocity + step.share * e_rate;
    const vec3 centre_acceleration = (1 - step.share) * state.object_acceleration;
    result.velocity_change = centre_acceleration * t - step.share * e_rate_change;
    result.displacement = centre_velocity * t + centre_acceleration * (t * t / 2) - step.share * e_change;
    result.drag_impulse = drag * (state.drag_velocity * t - result.displacement);
    return result;
}

vec3 interface_point(const CouplingFrame& f, vec3 device) {
    return f.player + f.player_to_world * (f.taken_object + f.device_to_player * (f.metres_per_metre *
                                                                                  (device - f.taken_device)));
}

vec3 to_device(const CouplingFrame& f, vec3 world) {
    return glm::transpose(f.device_to_player) * (glm::transpose(f.player_to_world) * world);
}

double felt_stiffness(const CouplingFrame& f, double stiffness) {
    return f.newtons_per_newton * f.metres_per_metre * stiffness;
}

}  // namespace thaum::haptics
