#include "haptics/tether.h"

#include <algorithm>
#include <cmath>

#include "haptics/servo.h"

namespace thaum::haptics {
namespace {

/// Moves the anchor of a tether (the point to which the tip is tied) on to the present, since the haptic
/// model is `age` ticks old. The anchor moves for at most `freshest_ticks`, since the safety stage ends the
/// force of an older model.
Tether moved_on(Tether tether, std::uint32_t age) {
    tether.anchor += tether.anchor_velocity * (std::min(age, freshest_ticks) * tick_seconds);
    return tether;
}

}  // namespace

double detent_force(const Detents& detents, double along) {
    if (!(detents.depth > 0)) return 0;
    double force = 0;
    for (const double place : detents.places) {
        const double off = (along - place) / detents.width;
        if (std::abs(off) < 0.5) force -= detents.depth * det::sin(2 * pi * off);
    }
    return force;
}

vec3 tether_force(const Tether& tether, vec3 tip, vec3 velocity) {
    if (!(tether.stiffness > 0)) return vec3(0);
    const vec3 off = tip - tether.anchor;
    const double notch = detent_force(tether.detents, glm::dot(off, tether.detents.axis));
    return -tether.stiffness * off - tether.damping * (velocity - tether.anchor_velocity) +
           notch * tether.detents.axis;
}

TetherForce feel_tether(ServoState& state, const Tether& tether, std::uint32_t age, const Tip& tip) {
    TetherForce felt;
    felt.switched = tether.number != state.tether_number;
    state.tether_number = tether.number;
    if (!(tether.stiffness > 0)) return felt;
    felt.tether = moved_on(tether, age);
    felt.force = tether_force(felt.tether, tip.position, tip.velocity);
    return felt;
}

}  // namespace thaum::haptics
