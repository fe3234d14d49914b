// A sphere felt with a simulated force feedback device. A hand lowers the stylus onto the sphere, then
// strokes it. Prints a table with one row per millisecond: position of the tip (m) and force on it (N), in
// the device's frame.
#include <algorithm>
#include <iostream>

#include "core/hash.h"
#include "core/text.h"
#include "haptics/servo.h"
#include "haptics/simulated.h"

namespace {

using namespace thaum;

/// Values of a common desktop force feedback device.
haptics::DeviceSpec desktop_arm() {
    haptics::DeviceSpec spec;
    spec.peak_force = 3.3, spec.continuous_force = 0.88;
    spec.max_damping = 4;
    spec.workspace = {0.16, 0.12, 0.07};
    spec.position_quantum = 5.5e-5;
    spec.mass = 0.045, spec.damping = 0.2, spec.coulomb_friction = 0.26;
    return spec;
}

/// The haptic model of one sphere with some friction, 3 cm in radius, in the middle of the workspace.
haptics::HapticModel sphere() {
    haptics::HapticModel model;
    model.patch.bodies[0].material = {.stiffness = 300, .static_friction = 0.3, .dynamic_friction = 0.2};
    model.patch.surfaces[0] = {.kind = haptics::SurfaceKind::sphere, .b = {0.03, 0, 0}};
    model.patch.body_count = model.patch.count = 1;
    return model;
}

/// Target of the hand (m): from above down into the sphere in half a second, then to and fro.
vec3 hand_target(Tick tick) {
    const double depth = 0.02 * std::min(seconds(tick) / 0.5, 1.0);
    return {0.015 * det::sin(pi * std::max(seconds(tick) - 0.5, 0.0)), 0.045 - depth, 0};
}

}  // namespace

int main() {
    const auto spec = desktop_arm();
    const auto model = sphere();
    const auto device = haptics::simulated_device(spec, haptics::Hand{});
    const auto servo = haptics::servo_of(spec, 1.0);
    haptics::ServoState servo_state;
    auto hand = haptics::resting_at(hand_target(0));

    std::cout << "tick,x,y,z,force_x,force_y,force_z\n";
    for (Tick tick = 0; tick < 3 * ticks_per_second; ++tick) {
        const vec3 tip = haptics::measured_position(device, hand);
        const vec3 force = haptics::servo_step(servo, servo_state, model, {.position = tip, .model_age = 1});
        hand = haptics::step(device, hand, hand_target(tick), force);
        std::cout << text(tick, ',', tip.x, ',', tip.y, ',', tip.z) << ','
                  << text(force.x, ',', force.y, ',', force.z, '\n');
    }
    std::cerr << "hash " << hex(hash_value(hand)) << '\n';
}
