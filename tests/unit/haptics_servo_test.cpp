// The servo step: pulses and the tip's velocity.
#include "haptics/servo.h"

#include <gtest/gtest.h>

#include "core/hash.h"
#include "core/random.h"

namespace thaum::haptics {
namespace {

Servo some_servo() {
    DeviceSpec spec;
    spec.peak_force = 3.3;
    spec.continuous_force = 0.88;
    return {safety_limits(spec, 1)};
}

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

TEST(HapticsServo, TheMeanOfAHalfSineIsExact) {
    for (const std::uint32_t length : {1U, 2U, 3U, 15U, 60U, 1000U, 12'345U}) {
        double sum = 0;
        for (std::uint32_t at = 0; at < length; ++at) {
            const double part = half_sine(at, length);
            EXPECT_GT(part, 0);
            EXPECT_LE(part, 1);
            const long double n = length, pi_l = 3.141592653589793238462643L;
            const long double exact = n / pi_l * (std::cos(pi_l * at / n) - std::cos(pi_l * (at + 1.0L) / n));
            EXPECT_NEAR(part, static_cast<double>(exact), 1e-14) << at << " of " << length;
            sum += part;
        }
        EXPECT_NEAR(sum / length, 2 / pi, 1e-12) << length;
        EXPECT_EQ(half_sine(length, length), 0);
    }
    EXPECT_EQ(half_sine(0, 0), 0);
    const std::uint32_t longest = ~0U;
    EXPECT_GT(half_sine(0, longest), 0);
    EXPECT_GT(half_sine(longest - 1, longest), 0);
}

TEST(HapticsServo, ABoltsKickHasItsWholeImpulse) {
    Rig rig;
    rig.feel();
    double impulse = 0, fastest = 0, before = 0;
    vec3 force = rig.feel_pulse({0, 0, 1.2}, 15);
    for (int tick = 0; tick < 100; ++tick, force = rig.feel()) {
        impulse += force.z * tick_seconds;
        fastest = std::max(fastest, std::abs(force.z - before) / tick_seconds);
        before = force.z;
        EXPECT_EQ(force.z > 0, tick < 15) << tick;
    }
    EXPECT_NEAR(impulse, 2 / pi * 1.2 * 0.015, 1e-12);
    EXPECT_GT(fastest, 200);  // N/s: no slew limit is in its way
    EXPECT_EQ(rig.cause(), SafetyCause::none);
}

TEST(HapticsServo, APulseIsPlayedOnceAndOnlyIfItIsNewer) {
    Rig rig;
    rig.feel();
    const auto impulse = [&rig] {
        double sum = 0;
        for (int tick = 0; tick < 50; ++tick) sum += rig.feel().x;
        return sum;
    };
    rig.model.pulse = {{1, 0, 0}, 10, 7};
    EXPECT_NEAR(impulse(), 2 / pi * 10, 1e-12);
    EXPECT_EQ(impulse(), 0);
    rig.model.pulse.number = 6;
    EXPECT_EQ(impulse(), 0);
    rig.model.pulse.number = 12;
    EXPECT_NEAR(impulse(), 2 / pi * 10, 1e-12);
    for (const std::uint32_t number : {1U << 31U, (1U << 31U) + 100, ~0U}) {  // up to where the numbers wrap
        rig.model.pulse.number = number;
        EXPECT_NEAR(impulse(), 2 / pi * 10, 1e-12);
    }
    rig.model.pulse.number = 1;
    EXPECT_NEAR(impulse(), 2 / pi * 10, 1e-12);
    rig.model.pulse = {{1, 0, 0}, 0, 2};  // no length, no kick
    EXPECT_EQ(impulse(), 0);
}

TEST(HapticsServo, PulsesAddAndAFifthTakesTheOldestsPlaceWithoutAJump) {
    Rig rig;
    rig.feel();
    rig.feel_pulse({0.3, 0, 0}, 200);
    rig.feel_pulse({0, 0.4, 0}, 200);
    EXPECT_GT(rig.state.safety.output.x, rig.state.safety.output.y);
    rig.feel_pulse({0.3, 0, 0}, 200);
    rig.feel_pulse({0.3, 0, 0}, 200);
    vec3 before;
    for (int tick = 0; tick < 100; ++tick) before = rig.feel();
    EXPECT_NEAR(before.y, 0.4, 0.001);
    EXPECT_NEAR(before.x, 0.9, 0.001);
    const vec3 force = rig.feel_pulse({0, 0, 0.1}, 200);
    EXPECT_NEAR(glm::length(force - before), 0.04, 1e-12);  // the oldest was cut off at 0.3 N: a switch
    for (int tick = 0; tick < 20; ++tick) before = rig.feel();
    EXPECT_NEAR(before.x, 0.57, 0.01);
}

TEST(HapticsServo, AWildPulseIsHeldBackLikeAnythingElse) {
    Rig rig;
    rig.feel();
    rig.feel_pulse(vec3(std::numeric_limits<double>::quiet_NaN()), 30);
    EXPECT_EQ(rig.state.safety.output, vec3(0));
    EXPECT_EQ(rig.state.safety.excess_count, 1U);
    for (int tick = 0; tick < 40; ++tick) rig.feel();
    rig.feel_pulse({10, 0, 0}, 30);
    for (int tick = 0; tick < 14; ++tick) rig.feel();
    EXPECT_NEAR(rig.state.safety.output.x, 3.3, 1e-12);
    EXPECT_EQ(rig.cause(), SafetyCause::capped);
}

TEST(HapticsServo, TheVelocityIsThatOfTheWindow) {
    const auto speed_limit = some_servo().limits.fastest;
    for (const double share : {0.99, 1.01}) {
        Rig rig;
        for (int tick = 0; tick < 50; ++tick) {
            rig.sample.position.y += share * speed_limit * tick_seconds;
            rig.feel();
            EXPECT_EQ(rig.cause() == SafetyCause::over_speed, share > 1 && tick > 0) << tick;
        }
    }
    // A sample that is read twice, as from a device that is served slower, and an encoder's quantum are no speed.
    Rig rig;
    for (int tick = 0; tick < 200; ++tick) {
        rig.sample.position.y = 0.02 * (tick / 8);
        rig.feel();
        EXPECT_EQ(rig.cause(), SafetyCause::none);
    }
}

TEST(HapticsServo, APositionThatIsNoNumberCutsOutAndIsForgotten) {
    for (const int when : {0, 5, 300}) {
        Rig rig;
        for (int tick = 0; tick < when; ++tick) rig.feel();
        rig.sample.position.x = std::numeric_limits<double>::quiet_NaN();
        EXPECT_EQ(rig.feel(), vec3(0));
        EXPECT_EQ(rig.cause(), SafetyCause::over_speed);
        rig.sample.position.x = 0;
        int ticks = 0;
        for (; rig.cause() == SafetyCause::over_speed && ticks < 1000; ++ticks) rig.feel();
        EXPECT_LE(ticks, 110);
        EXPECT_GE(ticks, 100);
    }
}

TEST(HapticsServo, FlagsAndAgeReachTheSafetyStage) {
    Rig rig;
    rig.feel();
    rig.model.on = false;
    rig.feel();
    EXPECT_EQ(rig.cause(), SafetyCause::off);
    rig.model.panic = true;
    rig.feel();
    EXPECT_EQ(rig.cause(), SafetyCause::panic);
    rig.model = {.rearm = true};
    rig.feel();
    EXPECT_EQ(rig.cause(), SafetyCause::none);
    rig.sample.model_age = 21;
    rig.feel();
    EXPECT_EQ(rig.cause(), SafetyCause::stale);
}

TEST(HapticsServo, TheSameTicksGiveTheSameBits) {
    const auto run = [] {
        Rig rig;
        Random random{3};
        std::uint64_t hash = 0;
        for (int tick = 0; tick < 5000; ++tick) {
            rig.sample.position = {random.uniform(0, 0.01), 0, random.uniform(0, 0.01)};
            if (random.below(40) == 0) {
                const vec3 peak{random.uniform(-2, 2), 0, random.uniform(-2, 2)};
                rig.feel_pulse(peak, static_cast<std::uint32_t>(1 + random.below(90)));
            } else {
                rig.feel();
            }
            hash = hash_value(rig.state, hash);
        }
        return hash;
    };
    EXPECT_EQ(run(), run());
    // Those of every build and processor. A change of the rules changes them: let it be on purpose.
    EXPECT_EQ(run(), 8627562975896150790ULL);
}

}  // namespace
}  // namespace thaum::haptics
