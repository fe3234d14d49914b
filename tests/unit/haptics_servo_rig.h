// unit/haptics_servo_rig.h: a servo (the step from sample to force) whose model and sample a test sets.
#pragma once
#include "haptics/servo.h"

namespace thaum::haptics::servo_tests {

inline Servo some_servo() {
    DeviceSpec spec;
    spec.peak_force = 3.3;
    spec.continuous_force = 0.88;
    return {safety_limits(spec, 1)};
}

/// A servo with everything that one step of it needs. A test changes `model` (what the world gives the hand
/// to feel) and `sample` (what the device measures of the hand), then calls feel().
struct Rig {
    Servo servo = some_servo();
    ServoState state{};
    HapticModel model{};
    ServoSample sample{};

    vec3 feel() { return servo_step(servo, state, model, sample); }
    vec3 feel_pulse(vec3 peak, std::uint32_t length) {
        model.pulse = {peak, length, model.pulse.number + 1};
        return feel();
    }
    SafetyCause cause() const { return static_cast<SafetyCause>(state.safety.cause); }
};

}  // namespace thaum::haptics::servo_tests
