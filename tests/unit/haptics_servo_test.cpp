// Tests of the servo step: kicks, velocity of the tip, tether (a spring to an anchor point), steady force,
// detents and safety.
#include "haptics/servo.h"

#include <gtest/gtest.h>

#include "core/hash.h"
#include "core/random.h"
#include "unit/haptics_servo_rig.h"

namespace thaum::haptics::servo_tests {
namespace {

TEST(HapticsServo, ATipThatIsHereAndThereInTurnIsTooFast) {
    for (const double apart : {0.0039, 0.0041, 0.03}) {  // distance per tick (m): 4 m/s is the limit of speed
        Rig rig;
        rig.model.steady_force = {{0, 0, 0.5}, 1};
        for (int tick = 0; tick < 50; ++tick) rig.feel();
        ASSERT_EQ(rig.state.safety.output.z, 0.5);
        for (int tick = 0; tick < 50; ++tick) {
            rig.sample.position.x = tick % 2 == 0 ? 0 : apart;
            rig.feel();
            if (tick % 2 == 0 && tick > 8) {
                EXPECT_NEAR(tip_velocity(rig.state).x * 7e-3, -apart, 1e-12);
            }
        }
        EXPECT_EQ(rig.cause() == SafetyCause::over_speed, apart > 0.004) << apart;
    }
}

TEST(HapticsServo, AnEncodersQuantumIsNoSpeed) {
    // Speeds just below the limit, in an oblique direction, rounded to a quantum (step of an encoder). Every
    // second sample may be late. At rest the encoders flicker.
    const double quantum = 2e-4;  // step of the encoders (m): four times the coarsest of the shipped devices
    const auto rounded = [quantum](vec3 place) { return quantum * glm::round(place / quantum); };
    for (const bool late : {false, true}) {
        Rig rig;
        rig.servo.quantum = quantum;
        const double speed = late ? 3.6 : 3.9;
        const vec3 way = speed * tick_seconds * glm::normalize(vec3(1, 0.37, -0.62));
        double least = speed, most = 0;
        for (int tick = 0; tick < 2000; ++tick) {
            rig.sample.position = rounded(static_cast<double>(late ? tick - tick % 2 : tick) * way);
            rig.feel();
            ASSERT_NE(rig.cause(), SafetyCause::over_speed) << tick;
            most = std::max(most, path_speed(rig.state, quantum));
            if (tick > 8) least = std::min(least, path_speed(rig.state, quantum));
        }
        const double allowed = std::sqrt(3.0) * quantum / tick_seconds;
        EXPECT_LE(most, speed * (late ? 8.0 / 7 : 1));
        EXPECT_GE(least, speed * (late ? 6.0 / 7 : 1) - 2 * allowed);  // not far below the real speed
    }
    Rig still;
    still.servo.quantum = quantum;
    Random random{3};
    for (int tick = 0; tick < 2000; ++tick) {
        still.sample.position = quantum * vec3(random.below(2), random.below(2), random.below(2));
        still.feel();
        EXPECT_EQ(path_speed(still.state, quantum), 0) << tick;
    }
    EXPECT_EQ(path_speed(ServoState{}, quantum), 0);
}

TEST(HapticsServo, WhatATetherHoldsIsThatOfWhereItIsByNow) {
    // The tether is a spring to an anchor that moves. The model is 10 ticks old, so the servo extrapolates
    // the anchor, which stretches the spring. The observer counts the energy of that stretch as received, so
    // the spring may give it back, but no more.
    Rig rig;
    rig.feel();
    rig.model.tether = {
        .anchor = {0.001, 0, 0}, .anchor_velocity = {0.5, 0, 0}, .stiffness = 200, .number = 1};
    rig.sample.model_age = 10;
    const double stretch = 0.001 + 0.5 * 10 * tick_seconds;
    rig.state.energy.created = -1;
    rig.feel();
    EXPECT_NEAR(rig.state.energy.created, -200 * stretch * stretch / 2, 1e-15);
    // With a model too old for any force, the anchor (the end of the tether) stops, and the wanted force
    // stays moderate.
    rig.sample.model_age = 4'000'000'000;
    for (int tick = 0; tick < 100; ++tick) rig.feel();
    EXPECT_EQ(rig.state.safety.excess_count, 0U);
}

TEST(HapticsServo, AThingCaughtBehindACornerDoesNotShutTheForcesOff) {
    Rig rig;
    rig.feel();
    for (int time = 0; time < 6; ++time) {
        // The lift wand's spring, stretched to the largest distance that a small object may have, then
        // released.
        rig.model.tether = {.anchor = {0.4, 0, 0}, .stiffness = 300, .number = rig.model.tether.number + 1};
        for (int tick = 0; tick < 200; ++tick) rig.feel();
        // The force becomes smaller after some time, because the motors are warm.
        EXPECT_GT(rig.state.safety.output.x, 0.1) << time;
        rig.model.tether = {.number = rig.model.tether.number + 1};
        for (int tick = 0; tick < 200; ++tick) rig.feel();
    }
    // A tether that the world stretches far beyond any room (40 m) is still a fault.
    for (int time = 0; time < 3; ++time) {
        rig.model.tether = {.anchor = {40, 0, 0}, .stiffness = 300, .number = rig.model.tether.number + 1};
        for (int tick = 0; tick < 50; ++tick) rig.feel();
        rig.model.tether = {.number = rig.model.tether.number + 1};
        for (int tick = 0; tick < 50; ++tick) rig.feel();
    }
    EXPECT_EQ(rig.cause(), SafetyCause::shut_off);
}

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
    EXPECT_GT(fastest, 200);  // change (N/s), far beyond the slew limit of 40
    EXPECT_EQ(rig.cause(), SafetyCause::none);
}

TEST(HapticsServo, ALeanIsFeltAsItIsAndGoesSlowlyWhereItJumps) {
    Rig rig;
    rig.feel();
    rig.model.steady_force = {{0, 0, 0.5}, 1};
    vec3 before{};
    for (int tick = 0; tick < 13; ++tick) {
        const vec3 force = rig.feel();
        // The slew limit of 40 N/s.
        EXPECT_LE(glm::length(force - before), 40 * tick_seconds + 1e-12) << tick;
        before = force;
    }
    EXPECT_EQ(before, vec3(0, 0, 0.5));
    // A larger force of the same source (same number), so it is no switch.
    rig.model.steady_force.force.z = 0.9;
    EXPECT_EQ(rig.feel(), vec3(0, 0, 0.9));
}

TEST(HapticsServo, ATetherIsASpringAndADamper) {
    const Tether tether{
        .anchor = {0.01, 0, 0}, .anchor_velocity = {0, 0.2, 0}, .stiffness = 100, .damping = 2};
    const vec3 force = tether_force(tether, {0.03, -0.01, 0}, {0, 0, 0.1});
    EXPECT_NEAR(force.x, -100 * 0.02, 1e-12);
    EXPECT_NEAR(force.y, 100 * 0.01 + 2 * 0.2, 1e-12);
    EXPECT_NEAR(force.z, -2 * 0.1, 1e-12);
    EXPECT_EQ(tether_force({}, {1, 1, 1}, {1, 1, 1}), vec3(0));
}

TEST(HapticsServo, ByAnOldModelATetheredThingGoesOnAsItMoved) {
    Rig late, fresh;
    late.feel(), fresh.feel();
    late.model.tether = {
        .anchor = {0.001, 0, 0}, .anchor_velocity = {0.5, 0, 0}, .stiffness = 200, .number = 1};
    fresh.model.tether = late.model.tether;
    fresh.model.tether.anchor.x += 0.5 * 2 * tick_seconds;
    late.sample.model_age = 2;
    vec3 a{}, b{};
    for (int tick = 0; tick < 30; ++tick) a = late.feel(), b = fresh.feel();
    EXPECT_NEAR(a.x, 200 * 0.002, 1e-9);
    EXPECT_NEAR(b.x, a.x, 1e-9);
}

TEST(HapticsServo, DetentsDrawToTheirMiddlesAndCreateNoEnergy) {
    const Detents detents{.axis = {0, 0, 1}, .places = {0.01, 0.03, 0.04}, .depth = 0.3, .width = 0.004};
    double work = 0, most = 0;
    constexpr int steps = 100'000;
    constexpr double length = 0.05, step = length / steps;
    for (int i = 0; i < steps; ++i) {
        const double force = detent_force(detents, (i + 0.5) * step);
        work += force * step;
        most = std::max(most, std::abs(force));
    }
    EXPECT_NEAR(work, 0, 1e-9);
    EXPECT_NEAR(most, 0.3, 1e-6);
    for (const double place : detents.places) {
        EXPECT_NEAR(detent_force(detents, place), 0, 1e-12);
        EXPECT_GT(detent_force(detents, place - 0.001), 0) << "before it: onwards";
        EXPECT_LT(detent_force(detents, place + 0.001), 0) << "beyond it: back";
        EXPECT_EQ(detent_force(detents, place + 0.0021), 0) << "elsewhere nothing";
    }
    EXPECT_EQ(detent_force({}, 0.01), 0);
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
    // Kicks are numbered. These numbers are in the middle and at the end of the range, where the difference
    // of two numbers wraps around.
    for (const std::uint32_t number : {1U << 31U, (1U << 31U) + 100, ~0U}) {
        rig.model.pulse.number = number;
        EXPECT_NEAR(impulse(), 2 / pi * 10, 1e-12);
    }
    rig.model.pulse.number = 1;
    EXPECT_NEAR(impulse(), 2 / pi * 10, 1e-12);
    rig.model.pulse = {{1, 0, 0}, 0, 2};  // without a length there is no kick
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
    // The oldest pulse was cut off at 0.3 N, which, like a switch of the source, lets the force change only
    // slowly.
    EXPECT_NEAR(glm::length(force - before), 0.04, 1e-12);
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
    const auto speed_limit = some_servo().limits.max_speed;
    for (const double share : {0.99, 1.01}) {
        Rig rig;
        for (int tick = 0; tick < 50; ++tick) {
            rig.sample.position.y += share * speed_limit * tick_seconds;
            rig.feel();
            EXPECT_EQ(rig.cause() == SafetyCause::over_speed, share > 1 && tick > 0) << tick;
        }
    }
    // A sample that is read twice, as from a device that is read too often, and a single step of an encoder
    // do not count as speed.
    Rig rig;
    for (int tick = 0; tick < 200; ++tick) {
        if (tick % 8 == 0) rig.sample.position.y += 0.02;
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
    std::uint64_t forces = 0;
    const auto run = [&forces] {
        Rig rig;
        Random random{3};
        std::uint64_t hash = 0;
        forces = 0;
        for (int tick = 0; tick < 5000; ++tick) {
            // One random number for each statement, because compilers evaluate arguments in different orders.
            const double back = random.uniform(-1, 1), right = random.uniform(-1, 1);
            rig.sample.position += 3e-3 * vec3(right, 0, back);  // a speed below 4 m/s
            if (random.below(40) == 0) {
                const vec3 peak{random.uniform(-2, 2), 0, random.uniform(-2, 2)};
                rig.feel_pulse(peak, static_cast<std::uint32_t>(1 + random.below(90)));
            } else {
                rig.feel();
            }
            hash = hash_value(rig.state, hash);
            forces = hash_value(rig.state.safety.output, forces);
            EXPECT_EQ(rig.state.proxy, rig.sample.position);
        }
        return hash;
    };
    EXPECT_EQ(run(), run());
    // The hash must be the same in every build and on every processor. It changes only if the servo is
    // changed on purpose.
    EXPECT_EQ(run(), 13800161640574636718ULL);
    EXPECT_EQ(forces, 17329372576814478680ULL);
}

}  // namespace
}  // namespace thaum::haptics::servo_tests
