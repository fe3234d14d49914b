// Stability of the simulated device and the coupling (spring and damper between hand and object): they stay
// finite, bounded and passive for hostile input.
#include <gtest/gtest.h>

#include "core/file.h"
#include "core/random.h"
#include "haptics/coupling.h"
#include "unit/haptics_rig.h"
#include "unit/shipped_devices.h"

namespace thaum::haptics {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double hostile_number(Random& random) {
    switch (random.below(8)) {
        case 0: return nan;
        case 1: return random.below(2) == 0 ? inf : -inf;
        case 2: return random.uniform(-1, 1) * 1e308;
        case 3: return random.uniform(-1, 1) * 1e-310;
        case 4: return 0;
        default: return random.uniform(-20, 20);
    }
}

vec3 hostile_vector(Random& random) {
    return {hostile_number(random), hostile_number(random), hostile_number(random)};
}

TEST(HapticsHostile, NothingMakesTheSimulatedDeviceLeaveItsLimits) {
    for (const auto& spec : shipped_devices()) {
        for (const Hand& hand :
             {Hand{}, no_hand, Hand{.mass = 0.01, .stiffness = 1e4, .damping = 0, .max_target_speed = inf}}) {
            const auto device = simulated_device(spec, hand);
            Random random{9};
            auto state = resting_at({});
            double fastest = 0;
            for (int tick = 0; tick < 60'000; ++tick) {
                // In every second period of 500 ticks no force acts, so that the motion also stops, stays and
                // starts again.
                const bool quiet = (tick / 500) % 2 == 1;
                state = step(device, state, quiet ? vec3(0) : hostile_vector(random),
                             quiet ? vec3(0) : hostile_vector(random));
                ASSERT_TRUE(is_finite(state.position) && is_finite(state.velocity) &&
                            is_finite(state.target));
                ASSERT_LE(glm::length(state.force), spec.peak_force * (1 + 1e-12));
                ASSERT_TRUE(glm::all(glm::lessThanEqual(glm::abs(state.position), device.reach)));
                ASSERT_TRUE(is_finite(measured_position(device, state)));
                fastest = std::max(fastest, glm::length(state.velocity));
            }
            // limit (m/s); the spring of the third hand alone reaches about 100 m/s
            EXPECT_LE(fastest, 200) << spec.name;
        }
    }
}

TEST(HapticsHostile, APassiveHandAndDeviceNeverGainEnergy) {
    Random random{4};
    for (int run = 0; run < 400; ++run) {
        auto spec = reference_spec();
        spec.mass = random.uniform(0.02, 0.5);
        spec.damping = run % 3 == 0 ? 0 : random.uniform(0, 5);
        spec.coulomb_friction = run % 2 == 0 ? 0 : random.uniform(0, 1);
        spec.workspace = vec3(run % 5 == 0 ? 0.05 : 1);
        const Hand hand{.mass = 0.1, .stiffness = random.uniform(0, 3000), .damping = run % 4 == 0 ? 0 : 8.0};
        const auto device = simulated_device(spec, hand);
        auto state = resting_at({});
        state.position = {random.uniform(-0.02, 0.02), 0.01, random.uniform(-0.02, 0.02)};
        state.velocity = {random.uniform(-2, 2), random.uniform(-2, 2), 0};
        const double start = energy(device, state);
        double before = start;
        for (int tick = 0; tick < 1000; ++tick) {
            state = step(device, state, {}, {});
            const double current = energy(device, state);
            ASSERT_LE(current, before + 1e-14 * start) << run << " at " << tick;
            before = current;
        }
    }
}

// ---- the coupling of hand and object ----------------------------------------------------------------------

double pair_energy(const Coupling& c, double mass, const CouplingState& s) {
    const vec3 e = s.hand - s.object;
    return (mass * glm::dot(s.object_velocity, s.object_velocity) + c.stiffness * glm::dot(e, e)) / 2;
}

void advance(const CouplingStep& step, CouplingState& s, double dt) {
    const auto r = couple(step, s);
    s.hand += s.hand_velocity * dt;
    s.object += r.displacement;
    s.object_velocity += r.velocity_change;
}

TEST(HapticsHostile, ACouplingToAStillHandNeverGainsEnergy) {
    for (const double k : {10.0, 4e3, 1e6}) {
        for (const double m : {1e-3, 1.0, 1e3}) {
            for (const double ratio : {0.0, 0.1, 1.0, 50.0}) {
                for (const double dt : {1e-3, 8e-3, 0.1}) {
                    const Coupling c{k, ratio * 2 * std::sqrt(k * m), 0};
                    const auto step = coupling_step(c, 1 / m, 0, dt);
                    CouplingState s{.hand = {1, 0, 0}, .object_velocity = {0, 3, 0}};
                    const double start = pair_energy(c, m, s);
                    double before = start;
                    for (int i = 0; i < 2000; ++i) {
                        advance(step, s, dt);
                        const double current = pair_energy(c, m, s);
                        ASSERT_LE(current, before + 1e-11 * start)
                            << k << " " << m << " " << ratio << " " << dt;
                        before = current;
                    }
                    if (ratio > 0) continue;
                    EXPECT_NEAR(before, start, 1e-8 * start);  // the energy must stay the same
                }
            }
        }
    }
}

TEST(HapticsHostile, WhateverTheHandDoesTheObjectStaysNearIt) {
    // A hand that jumps to a random place in a box of 2 m at each step, and rests within the step, so that
    // only the spring moves the object.
    Random random{21};
    for (const double k : {10.0, 4e3, 1e6}) {
        for (const double m : {1e-3, 1.0, 1e3}) {
            const Coupling c{k, 2 * 0.2 * std::sqrt(k * m), 0};
            const auto step = coupling_step(c, 1 / m, 0, 4e-3);
            CouplingState s;
            double farthest = 0;
            for (int i = 0; i < 100'000; ++i) {
                s.hand = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
                advance(step, s, 4e-3);
                ASSERT_TRUE(is_finite(s.object) && is_finite(s.object_velocity));
                farthest = std::max(farthest, glm::length(s.object));
            }
            // Worst case for the damping ratio 0.2: each jump of the hand by 1 comes just when it amplifies
            // the oscillation. The overshoots then form a geometric series, whose sum contains 1 / tanh(pi
            // 0.2 / 2).
            EXPECT_LE(farthest, 2 * std::sqrt(3.0) / std::tanh(pi * 0.2 / 2)) << k << " " << m;
        }
    }
}

}  // namespace
}  // namespace thaum::haptics
