// Tests of the viscous space around a hand that draws.
#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "haptics/servo.h"
#include "haptics/simulated.h"
#include "unit/shipped_devices.h"

namespace thaum::haptics {
namespace {

constexpr double viscosity = 3.5;  // viscosity of the space (N s/m)

TEST(Viscosity, AnEvenMotionIsResistedInProportionToItsSpeed) {
    for (const auto& spec : shipped_devices()) {
        const Servo servo = servo_of(spec, 1);
        const double felt = std::min(viscosity, servo.max_damping);
        for (const double speed : {0.05, 0.2}) {
            ServoState state;
            const HapticModel model{.viscosity = viscosity};
            vec3 force{};
            // Long enough for the force to fade in after the viscosity is switched on, short enough for the
            // motors to stay cold.
            for (int tick = 0; tick < 400; ++tick)
                force = servo_step(servo, state, model, {vec3(0, speed * tick * tick_seconds, 0), 0});
            EXPECT_NEAR(force.y, -felt * speed, 1e-9) << spec.name << ", " << speed;
            EXPECT_NEAR(force.x, 0, 1e-12);
        }
    }
}

TEST(Viscosity, AThrownDeviceSlowsDownExponentially) {
    // A mass m with the velocity v in the viscosity b obeys m v' = -b v. The servo knows v as a mean over up
    // to eight ticks (dt), up to 4.5 ticks old: the decay is faster by the factor 1 + 4.5 b dt / m, or 2.6 %.
    DeviceSpec spec = shipped_devices().front();
    spec.mass = 0.6;
    spec.damping = spec.coulomb_friction = 0;
    spec.position_quantum = 0;
    spec.latency = 0;
    const auto device = simulated_device(spec, no_hand);
    const Servo servo = servo_of(spec, 1);
    const double b = std::min(viscosity, servo.max_damping);
    auto hand = resting_at({-0.05, 0, 0});
    ServoState state;
    const HapticModel model{.viscosity = viscosity};
    // The hand moves the device evenly until the forces have faded in, then releases it.
    double at_400 = 0, at_600 = 0;
    for (int tick = 0; tick <= 600; ++tick) {
        if (tick <= 300) hand.velocity.x = 0.1;
        if (tick == 400) at_400 = hand.velocity.x;
        if (tick == 600) at_600 = hand.velocity.x;
        const vec3 force = servo_step(servo, state, model, {measured_position(device, hand), 0});
        hand = step(device, hand, hand.position, force);
    }
    const double exact = std::exp(-b * 0.2 / spec.mass);
    EXPECT_NEAR(std::log(at_600 / at_400) / std::log(exact), 1.013, 0.015);
    EXPECT_LT(at_400, 0.1);
}

TEST(Viscosity, CreatesNoEnergyForAnyHandAndDevice) {
    Random random{5};
    for (const auto& spec : shipped_devices()) {
        const auto device = simulated_device(spec, Hand{});
        const Servo servo = servo_of(spec, 1);
        auto hand = resting_at({});
        ServoState state;
        HapticModel model;
        vec3 target{};
        double fastest = 0;
        for (int tick = 0; tick < 8000; ++tick) {
            if (tick % 100 == 0)
                target = 0.025 * vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
            if (tick % 700 == 0) model.viscosity = model.viscosity > 0 ? 0 : viscosity;
            const vec3 force = servo_step(servo, state, model, {measured_position(device, hand), 0});
            hand = step(device, hand, target, force);
            fastest = std::max(fastest, glm::length(hand.velocity));
        }
        EXPECT_LE(state.energy.most_created, 0.02) << spec.name;
        EXPECT_GT(fastest, 0.1) << spec.name;
    }
}

TEST(Viscosity, ABorderBetweenTwoSpacesMakesNoJump) {
    for (const auto& spec : shipped_devices()) {
        const Servo servo = servo_of(spec, 1);
        ServoState state;
        HapticModel model{.viscosity = spec.max_damping};
        const double speed = std::min(0.1, 0.5 * spec.peak_force / spec.max_damping);
        double before = 0;
        for (int tick = 0; tick < 1000; ++tick) {
            if (tick % 100 == 0) model.viscosity = (tick % 200 == 0 ? 1 : 0.1) * spec.max_damping;
            const vec3 tip(speed * tick_seconds * tick, 0, 0);
            const double force = servo_step(servo, state, model, {tip, 0}).x;
            if (tick > 200) EXPECT_LE(std::abs(force - before), 0.2) << spec.name << " at " << tick;
            if (tick > 200 && tick % 100 == 99)
                EXPECT_NEAR(force, -model.viscosity * speed, 1e-6) << spec.name << " at " << tick;
            before = force;
        }
    }
}

TEST(Viscosity, ABadPlaceGivesNoForce) {
    const Servo servo = servo_of(shipped_devices().front(), 1);
    ServoState state;
    const HapticModel model{.viscosity = viscosity};
    for (int tick = 0; tick < 200; ++tick) servo_step(servo, state, model, {vec3(1e-4 * tick, 0, 0), 0});
    const vec3 force = servo_step(servo, state, model, {vec3(std::nan(""), 0, 0), 0});
    EXPECT_EQ(force, vec3(0));
}

}  // namespace
}  // namespace thaum::haptics
