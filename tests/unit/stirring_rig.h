// A simulated hand and device that stir a fluid which the test defines.
#pragma once
#include "haptics/servo.h"
#include "haptics/simulated.h"
#include "tests/scenes/stirring_attack.h"

namespace thaum::haptics {

using bench::uniform_flow;

/// A device without friction, damping or hand.
inline DeviceSpec bare_device(double mass = 0.1) {
    DeviceSpec spec;
    spec.peak_force = 1000;
    spec.continuous_force = 1000;
    spec.max_damping = 30;
    spec.max_stiffness = 1000;
    spec.workspace = vec3(100);
    spec.mass = mass;
    return spec;
}

inline FluidModes no_modes() { return {0, 0, 0, 0, 0, 0, 0}; }

inline FluidTouch some_fluid() {
    FluidTouch fluid{.number = 1, .modes = no_modes()};
    fluid.frame = {.origin = {0.5, -0.25, 0.125},
                   .turn = mat3(rotation(glm::normalize(vec3(1, 2, -0.5)), 0.9)),
                   .metres_per_metre = 16,
                   .newtons_per_newton = 1.0 / 256};
    fluid.drag = {.viscous = 2, .form = 0.5};
    add_fluid_step(fluid, uniform_flow({}, 4, 8));
    return fluid;
}

/// A tip that stirs, moved one tick at a time by the test or by the device.
struct StirringRig {
    DeviceSpec spec = bare_device();
    SimulatedDevice device = simulated_device(spec, no_hand);
    Servo servo = [this] {
        Servo result = servo_of(spec, 1);
        result.limits.max_speed = 1e9;
        result.limits.slew = 1e12;
        return result;
    }();
    ServoState state{};
    HapticModel model{};
    SimulatedState tip = resting_at({});
    std::uint32_t model_age{};

    StirringRig() { model.fluid = some_fluid(); }

    FluidTouch& fluid() { return model.fluid; }
    vec3 feel_at(vec3 position) { return servo_step(servo, state, model, {position, model_age}); }
    /// The device moves by the force of the servo. Returns that force.
    vec3 tick() {
        const vec3 force = feel_at(tip.position);
        tip = step(device, tip, {}, force);
        return force;
    }
    /// The force of the last tick on a tip that has moved evenly and is now at `to`.
    vec3 feel_moving(vec3 to, vec3 velocity) {
        vec3 force{};
        for (int back = 20; back >= 0; --back) force = feel_at(to - velocity * (back * tick_seconds));
        return force;
    }
};

}  // namespace thaum::haptics
