// Tests of the passivity observer and controller: created energy, removed energy, and the energy that active
// sources (forces that push by themselves) may give.
#include "haptics/energy.h"

#include <gtest/gtest.h>

#include "haptics/servo.h"
#include "haptics/simulated.h"

namespace thaum::haptics {
namespace {

/// The reference device of the Z-width test (how stiff a wall may be): 0.1 kg, 0.5 N s/m, no hand, no dry
/// friction, exact encoders.
DeviceSpec reference_device(int latency) {
    DeviceSpec spec;
    spec.peak_force = 1000;
    spec.continuous_force = 1000;
    spec.max_damping = 30;
    spec.workspace = {0.4, 0.4, 0.4};
    spec.mass = 0.1;
    spec.damping = 0.5;
    spec.latency = latency;
    return spec;
}

struct Outcome {
    double created{};   ///< sum of F dx, computed independently here (J)
    double most{};      ///< largest value of `created` (J)
    double farthest{};  ///< largest distance of the tip from x = 0 in the last quarter of the run (m)
};

/// Moves a tip at 0.1 m/s into a spring along x, with or without the passivity controller.
Outcome meet_spring(double stiffness, bool controlled, int latency) {
    const auto spec = reference_device(latency);
    const auto device = simulated_device(spec, no_hand);
    Servo servo = servo_of(spec, 1);
    servo.limits.slew = 1e9;
    servo.limits.max_speed = 1e9;
    if (!controlled) servo.max_damping = 0;
    ServoState state{};
    HapticModel model{};
    model.tether = {.anchor = {}, .stiffness = stiffness};
    auto tip = resting_at({});
    tip.velocity = {0.1, 0, 0};
    Outcome outcome;
    constexpr int ticks = 4000;
    for (int t = 0; t < ticks; ++t) {
        const vec3 force = servo_step(servo, state, model, {tip.position, 0});
        const vec3 from = tip.position;
        tip = step(device, tip, {}, force);
        outcome.created += glm::dot(tip.force, tip.position - from);
        outcome.most = std::max(outcome.most, outcome.created);
        if (t > ticks * 3 / 4) outcome.farthest = std::max(outcome.farthest, std::abs(tip.position.x));
    }
    return outcome;
}

TEST(HapticsEnergy, CreatedEnergyIsTheSumOfForceTimesDisplacement) {
    PassivityObserver observer;
    observe(observer, {0, 0, 0}, {}, 0, 0);
    record_output(observer, {2, 0, 0}, {2, 0, 0}, {}, {});
    observe(observer, {0.01, 0, 0}, {}, 0, 0);
    EXPECT_NEAR(observer.created, 0.02, 1e-15) << "the hand went where the force pushed it";
    record_output(observer, {2, 0, 0}, {2, 0, 0}, {}, {});
    observe(observer, {0.0, 0, 0}, {}, 1, 0);
    EXPECT_NEAR(observer.created, 0, 1e-15) << "and back against it";
    record_output(observer, {2, 0, 0}, {2, 0, 0}, {}, {2, 0, 0});
    observe(observer, {0.01, 0, 0}, {0.01, 0, 0}, 0, 0);
    EXPECT_NEAR(observer.created, 0, 1e-15)
        << "the world moved the other end as far: the energy is the world's";
    EXPECT_NEAR(observer.most_created, 0.02, 1e-15);
}

TEST(HapticsEnergy, APoseThatJumpsIsNoWork) {
    for (const double away : {0.06, 1.0, 1e6}) {
        PassivityObserver observer;
        const auto tick = [&](double x) {
            observe(observer, {x, 0, 0}, {}, 0, 0);
            record_output(observer, {3, 0, 0}, {2, 0, 0}, {1, 0, 0}, {});
        };
        tick(0), tick(0.001), tick(0.002);
        const double created = observer.created, given = observer.active_work;
        EXPECT_GT(created, 0.003);
        tick(0.002 + away), tick(0.002);
        EXPECT_EQ(observer.created, created) << away;
        EXPECT_EQ(observer.active_work, given) << away;
        tick(0.003);
        EXPECT_NEAR(observer.created, created + 0.002, 1e-12) << "and on it goes";
    }
}

TEST(HapticsEnergy, WhatDampingTookIsNoReserve) {
    PassivityObserver observer;
    observe(observer, {}, {}, 0, 0);
    record_output(observer, {-5, 0, 0}, {-5, 0, 0}, {}, {});
    observe(observer, {0.02, 0, 0}, {}, 0.02, 0);
    EXPECT_NEAR(observer.created, -0.02, 1e-15) << "0.1 J went in, and 0.02 J are stored";
}

TEST(HapticsEnergy, CapAndHeatScaleAllSourcesAlikeAndTheRestIsActive) {
    PassivityObserver observer;
    record_output(observer, {1, 0, 0}, {3, 0, 0}, {1, 0, 0}, {3, 0, 0});
    const auto now = [&observer] { return observer.forces[observer.newest]; };
    EXPECT_NEAR(now().passive.x, 0.75, 1e-15);
    EXPECT_NEAR(now().world.x, 0.75, 1e-15);
    EXPECT_NEAR(now().active.x, 0.25, 1e-15);
    record_output(observer, {0, 1, 0}, {}, {}, {});
    EXPECT_EQ(now().passive, vec3(0));
    EXPECT_EQ(now().active, vec3(0, 1, 0));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    record_output(observer, {1, 0, 0}, {nan, 0, 0}, {}, {});
    EXPECT_EQ(now().passive, vec3(0));
}

TEST(HapticsEnergy, WhatFadesAfterASwitchIsPassive) {
    PassivityObserver observer;
    observe(observer, {}, {}, 0, 0);
    // The spring asks for 1 N and gets it. 2 N of the source that was just removed remain.
    record_output(observer, {3, 0, 0}, {1, 0, 0}, {}, {1, 0, 0}, {2, 0, 0});
    EXPECT_EQ(observer.forces[observer.newest].passive, vec3(3, 0, 0));
    EXPECT_EQ(observer.forces[observer.newest].world, vec3(1, 0, 0))
        << "nothing of the world holds what is left";
    EXPECT_EQ(observer.forces[observer.newest].active, vec3(0));
    observe(observer, {0.01, 0, 0}, {}, 0, 0);
    EXPECT_NEAR(observer.created, 0.03, 1e-15);
    EXPECT_EQ(observer.active_work, 0);
}

TEST(HapticsEnergy, TheControllerTakesOutWhatWasCreatedAndNoMore) {
    PassivityObserver observer;
    observer.created = 1e-4;
    const vec3 velocity{0.5, 0, 0};
    const vec3 force = passivity_control(observer.created, velocity, 30);
    EXPECT_NEAR(-glm::dot(force, velocity) * 0.001, 1e-4, 1e-12);
    EXPECT_NEAR(passivity_control(observer.created, {0.01, 0, 0}, 30).x, -0.3, 1e-12)
        << "at most the device's damping";
    EXPECT_EQ(passivity_control(observer.created, {}, 30), vec3(0));
    observer.created = -1;
    EXPECT_EQ(passivity_control(observer.created, velocity, 30), vec3(0));
}

TEST(HapticsEnergy, TheControllerBeginsWhileASpringStillHoldsWhatItMayGive) {
    PassivityObserver observer;
    // The springs have got 0.05 J from the hand that they have not given back. They hold 5 mJ more than that,
    // which they must have created.
    observer.created = -0.05;
    EXPECT_NEAR(surplus(observer, 0.055), 0.005 - energy_slack, 1e-15);
    EXPECT_LE(surplus(observer, 0.05), 0) << "a spring that created nothing is left alone";
    observer.created = 1e-4;
    EXPECT_EQ(surplus(observer, 0), 1e-4) << "with nothing left to give there is no slack";
}

TEST(HapticsEnergy, PendingWorkIsThatOfForcesNotYetFelt) {
    PassivityObserver observer;
    record_output(observer, {2, 0, 0}, {2, 0, 0}, {}, {});
    record_output(observer, {3, 0, 0}, {3, 0, 0}, {}, {});
    const vec3 step{0.001, 0, 0};
    EXPECT_EQ(pending_work(observer, step, 0), 0);
    EXPECT_NEAR(pending_work(observer, step, 1), 0.003, 1e-15);
    EXPECT_NEAR(pending_work(observer, step, 2), 0.005, 1e-15);
}

TEST(HapticsEnergy, ThePromptVelocityIsLateByHalfATickInATurnAndQuietAtRest) {
    const double quantum = 5.5e-5, radius = 0.01,
                 rate = 150;  // step of the Omni arm's encoders (m), radius (m) and rate (rad/s) of a circle
    const auto rounded = [quantum](vec3 place) { return quantum * glm::round(place / quantum); };
    const Servo servo = servo_of(reference_device(0), 1);
    ServoState state;
    vec3 place{};
    double prompt = 0, late = 0;
    for (int tick = 0; tick < 500; ++tick) {
        const double phase = rate * tick * tick_seconds;
        place = rounded(radius * vec3(std::cos(phase), std::sin(phase), 0));
        servo_step(servo, state, {}, {place, 0});
        const vec3 exact = radius * rate * vec3(-std::sin(phase), std::cos(phase), 0);
        if (tick < 10) continue;
        prompt = std::max(prompt, glm::length(prompt_velocity(state, quantum) - exact));
        late = std::max(late, glm::length(tip_velocity(state) - exact));
    }
    EXPECT_GT(late, 0.7) << "3.5 ms behind";
    EXPECT_LT(prompt, 0.3) << "a tick behind, and the quantum's noise";
    for (int tick = 0; tick < 100; ++tick) {
        place = vec3(tick % 2 == 0 ? quantum : 0, 0, 0);
        servo_step(servo, state, {}, {place, 0});
        if (tick < 10) continue;
        EXPECT_LE(glm::length(prompt_velocity(state, quantum)), quantum / 6e-3) << "flicker is no motion";
    }
}

TEST(HapticsEnergy, AnActiveSourceIsHeldToItsBudget) {
    PassivityObserver observer;
    observer.active_work = active_budget + 0.01;
    EXPECT_EQ(within_budget(observer, {1, 1, 0}), vec3(0)) << "it may not push any more";
    observer.active_work = 0.9 * active_budget;
    EXPECT_NEAR(within_budget(observer, {1, 1, 0}).x, 0.5, 1e-12) << "it fades in the last fifth";
    observer.active_work = 0.75 * active_budget;
    EXPECT_EQ(within_budget(observer, {1, 1, 0}), vec3(1, 1, 0)) << "it is whole before";
    // A steady force pushes a tip that nothing holds, without end.
    const auto spec = reference_device(0);
    auto device = simulated_device(spec, no_hand);
    device.reach = vec3(100);
    Servo servo = servo_of(spec, 1);
    servo.limits.max_speed = 1e9;
    ServoState state{};
    HapticModel model{};
    model.steady_force.force = {3, 0, 0};
    auto tip = resting_at({});
    double work = 0;
    for (int t = 0; t < 1000; ++t) {
        const vec3 force = servo_step(servo, state, model, {tip.position, 0});
        const vec3 from = tip.position;
        tip = step(device, tip, {}, force);
        work += glm::dot(tip.force, tip.position - from);
    }
    EXPECT_GT(work, 0.9 * active_budget);
    EXPECT_LE(work, active_budget);
}

TEST(HapticsEnergy, NoSecondSeesMoreThanTheActiveBudget) {
    // Kicks and a steady force of changing direction act on a hand that oscillates, so that each force pushes
    // the hand at some times and resists it at others.
    for (const double rate : {0.3, 0.9, 2.2, 7.0}) {
        auto spec = reference_device(0);
        spec.workspace = {0.2, 0.2, 0.2};
        const auto device = simulated_device(spec, {.mass = 0.3, .stiffness = 60, .damping = 2});
        const Servo servo = servo_of(spec, 1);
        ServoState state;
        HapticModel model;
        auto tip = resting_at({});
        std::vector<double> given{0};
        for (int t = 0; t < 6000; ++t) {
            const double phase = 2 * pi * rate * t * tick_seconds;
            model.steady_force.force = vec3(4 * std::sin(1.7 * phase), 3, 0);
            if (t % 90 == 0) model.pulse = {{0, 9, 0}, 60, model.pulse.number + 1};
            const vec3 force = servo_step(servo, state, model, {tip.position, 0});
            const vec3 from = tip.position;
            tip = step(device, tip, {0.08 * std::sin(phase), 0, 0}, force);
            given.push_back(given.back() + glm::dot(tip.force, tip.position - from));
        }
        double most = 0;
        for (std::size_t end = 1000; end < given.size(); ++end)
            for (std::size_t ago = 10; ago <= 1000; ago += 10)
                most = std::max(most, given[end] - given[end - ago]);
        EXPECT_LE(most, active_budget) << rate;
        EXPECT_GT(most, 0.7 * active_budget) << rate;
    }
}

TEST(HapticsEnergy, ARampKeepsThePartsOfTheForceThatItEnds) {
    PassivityObserver observer;
    record_output(observer, {3, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0});
    record_ramp(observer, {1.5, 0, 0});
    const auto& force = observer.forces[observer.newest];
    EXPECT_NEAR(force.active.x, 1, 1e-15) << "else forces that go off and on push without a budget";
    EXPECT_NEAR(force.passive.x, 0.5, 1e-15);
    EXPECT_EQ(force.world, vec3(0)) << "the world stands still";
    record_ramp(observer, {});
    EXPECT_EQ(observer.forces[observer.newest].active, vec3(0));
    record_ramp(observer, {1, 0, 0});
    EXPECT_EQ(observer.forces[observer.newest].passive, vec3(1, 0, 0));
}

TEST(HapticsEnergy, AStiffSpringThatWouldRingForEverIsKeptPassive) {
    for (const int latency : {0, 1}) {
        // The stiffness is beyond the passive bound 2 b / T for damping b and tick T, or with a tick of delay
        // beyond the smaller bound that this delay leaves.
        const double stiffness = latency == 0 ? 2500 : 1500;
        const auto bare = meet_spring(stiffness, false, latency);
        const auto kept = meet_spring(stiffness, true, latency);
        EXPECT_GT(bare.most, 1.0) << latency << ": without the controller it grows";
        EXPECT_LE(kept.most, 0.02) << latency;
        EXPECT_LT(kept.farthest, 0.01) << latency;
    }
}

TEST(HapticsEnergy, ALateForceIsBookedWhenItActs) {
    PassivityObserver observer;
    observe(observer, {}, {}, 0, 2);
    for (int tick = 0; tick < 6; ++tick) {
        record_output(observer, {tick == 1 ? 1.0 : 0.0, 0, 0}, {tick == 1 ? 1.0 : 0.0, 0, 0}, {}, {});
        observe(observer, {tick == 3 ? 0.01 : 0.0, 0, 0}, {}, 1, 2);
        EXPECT_NEAR(observer.created, tick == 3 ? 0.01 : 0.0, 1e-15) << tick;
        observer.created = 0;
    }
}

TEST(HapticsEnergy, OfAWeakSpringItTakesWhatTheTickAddsAndNoMore) {
    const auto bare = meet_spring(100, false, 0);
    const auto kept = meet_spring(100, true, 0);
    EXPECT_GT(bare.most, 2e-5) << "half the stiffness times the square of a tick's way, each tick";
    EXPECT_LE(kept.most, 0.1 * bare.most);
    // The device's damping alone decides how long a spring oscillates in continuous time. A tick T adds K T /
    // 2 of negative damping at the stiffness K.
    const double continuous = bare.farthest * std::exp(-(100 * tick_seconds / 2) / (2 * 0.1) * 3);
    EXPECT_GT(kept.farthest, 0.7 * continuous) << "hardly more damping than that";
}

TEST(SteadyBrake, EndsByStepsWhereTheForceItBrakedIsNothingButRounding) {
    // A proxy in free space leaves a force of some femtonewtons, in any direction.
    for (const vec3 rounding : {vec3(0), vec3(3e-15, 0, 0), vec3(-3e-15, 0, 0), vec3(0, 2e-12, -1e-13)}) {
        PassivityObserver observer;
        observer.brake = {2, -1, 0.5};
        for (int t = 0; t < 12; ++t) {
            const vec3 before = observer.brake;
            steady_brake(observer, vec3(0), rounding, before);
            EXPECT_LE(glm::distance(observer.brake, before), brake_step + 1e-12);
        }
        EXPECT_EQ(observer.brake, vec3(0));
    }
}

}  // namespace
}  // namespace thaum::haptics
