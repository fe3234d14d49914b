// Compares bodies with closed forms and, without our correction of free flight (which makes falls exact),
// with Bullet's own recurrence: semi-implicit Euler.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/physics_scenes.h"

namespace thaum::physics {
namespace {

using namespace scenes;

constexpr double g = 9.81;

double fall_error(double step, bool exact) {
    Physics physics({.exact_flight = exact});
    physics.add(2, ball(0.1, 1), at({0, 100, 0}));
    const int steps = static_cast<int>(std::lround(1 / step));
    for (int i = 0; i < steps; ++i) physics.step(step);
    return 100 - physics.state(2).position.y - g / 2;
}

TEST(PhysicsAccuracy, FreeFallIsExactAtEveryStep) {
    for (const double step : {0.00025, 0.001, 0.002, 0.004, 0.008})
        EXPECT_NEAR(fall_error(step, true), 0, 1e-11) << step;
}

TEST(PhysicsAccuracy, WithoutTheCorrectionFreeFallFollowsBulletsRecurrence) {
    for (const double step : {0.001, 0.002, 0.004, 0.008})
        // Error of semi-implicit Euler: g t dt / 2.
        EXPECT_NEAR(fall_error(step, false), g * 1 * step / 2, 1e-11) << step;
}

TEST(PhysicsAccuracy, AThrowKeepsItsEnergyAndItsHorizontalMomentum) {
    Physics physics;
    physics.add(2, box({0.1, 0.2, 0.3}, 3), {.velocity = {7, 9, -5}, .spin = {1, 2, 3}});
    const auto energy = [&] {
        const BodyState s = physics.state(2);
        return glm::dot(s.velocity, s.velocity) / 2 + g * s.position.y;  // mechanical energy per mass (J/kg)
    };
    const double before = energy();
    for (int i = 0; i < 3000; ++i) {
        physics.step(dt);
        ASSERT_NEAR(energy(), before, 1e-9) << i;
        ASSERT_NEAR(physics.velocity(2).x, 7, 1e-12);
        ASSERT_NEAR(physics.velocity(2).z, -5, 1e-12);
    }
}

TEST(PhysicsAccuracy, DampedFallFollowsTheClosedFormForAnyDamping) {
    for (const double damping : {1e-12, 1e-6, 0.01, 0.2, 0.9, 0.999999}) {
        for (const double step : {0.001, 0.008}) {
            Physics physics;
            BodyDesc desc = ball(0.1, 2);
            desc.linear_damping = damping;
            physics.add(2, desc, at({0, 0, 0}, {3, 20, 0}));
            for (int i = 0; i < std::lround(2 / step); ++i) physics.step(step);
            const double c = -std::log1p(-damping);
            // Integral over 2 s of the share of the velocity that remains (s)
            const double share = -std::expm1(-2 * c) / c;
            const double fallen = c < 1e-5 ? 2.0 - 4 * c / 3 : (2 - share) / c;
            EXPECT_NEAR(physics.state(2).position.x, 3 * share, 1e-9) << damping << ' ' << step;
            EXPECT_NEAR(physics.state(2).position.y, 20 * share - g * fallen, 2e-9) << damping << ' ' << step;
            EXPECT_NEAR(physics.velocity(2).y, 20 * std::exp(-2 * c) - g * share, 1e-9)
                << damping << ' ' << step;
        }
    }
}

TEST(PhysicsAccuracy, PushedBodiesFollowBulletsStep) {
    // A contact acts on a resting body in every step; the correction that makes free flight exact must not
    // lift the body.
    for (const bool exact : {true, false}) {
        Physics physics({.exact_flight = exact});
        add_floor(physics);
        physics.add(2, box({0.25, 0.25, 0.25}, 8), at({0, 0.25, 0}));
        for (int i = 0; i < 1500; ++i) physics.step(dt);
        EXPECT_NEAR(physics.state(2).position.y, 0.25, 1e-4) << exact;
    }
}

TEST(PhysicsAccuracy, DampingRemovesItsShare) {
    Physics physics({.gravity = {}});
    BodyDesc desc = ball(0.1, 1);
    desc.linear_damping = 0.25;
    desc.angular_damping = 0.5;
    physics.add(2, desc, {.velocity = {3, 0, 0}, .spin = {0, 4, 0}});
    for (int i = 0; i < 2000; ++i) physics.step(dt);
    EXPECT_NEAR(physics.velocity(2).x, 3 * 0.75 * 0.75, 1e-10);
    EXPECT_NEAR(physics.state(2).spin.y, 4 * 0.25, 1e-10);
}

TEST(PhysicsAccuracy, ElasticCollisionKeepsMomentumAndEnergy) {
    Physics physics({.gravity = {}});
    BodyDesc heavy = ball(0.2, 3), light = ball(0.2, 1);
    heavy.restitution = light.restitution = 1;
    heavy.friction = light.friction = heavy.rolling_friction = light.rolling_friction = 0;
    physics.add(1, heavy, at({-1, 0, 0}, {2, 0, 0}));
    physics.add(2, light, at({1, 0, 0}, {-1, 0, 0}));
    double impulse = 0;
    for (int i = 0; i < 1500; ++i) {
        physics.step(dt);
        for (const Contact& c : physics.contacts()) impulse += c.impulse;
        const double momentum = 3 * physics.velocity(1).x + physics.velocity(2).x;
        ASSERT_NEAR(momentum, 5, 1e-12) << i;
    }
    // Elastic collision of the masses m1 and m2: v1 becomes ((m1 - m2) v1 + 2 m2 v2) / (m1 + m2).
    EXPECT_NEAR(physics.velocity(1).x, 0.5, 1e-9);
    EXPECT_NEAR(physics.velocity(2).x, 3.5, 1e-9);
    EXPECT_NEAR(impulse, 4.5, 1e-9);
}

TEST(PhysicsAccuracy, ASlidingBoxStopsWhereCoulombSays) {
    Physics physics;
    physics.add(1, box({50, 1, 5}, 0, 1), at({0, -1, 0}));
    physics.add(2, box({0.5, 0.25, 0.5}, 10, 0.4), at({0, 0.25, 0}));
    for (int i = 0; i < 500; ++i) physics.step(dt);
    const double start = physics.state(2).position.x;
    physics.set_velocity(2, {3, 0, 0});
    for (int i = 0; i < 2000; ++i) physics.step(dt);
    EXPECT_NEAR(physics.state(2).position.x - start, 9 / (2 * 0.4 * g), 0.02 * 9 / (2 * 0.4 * g));
}

TEST(PhysicsAccuracy, ContactImpulsesAreTheMomentumTheyTake) {
    Physics physics;
    add_floor(physics);
    physics.add(2, box({0.25, 0.25, 0.25}, 8), at({0, 1.25, 0}));
    double impulse = 0;
    const double mass = 8;
    int steps = 0;
    for (; steps < 1500; ++steps) {
        physics.step(dt);
        for (const Contact& c : physics.contacts()) impulse += c.impulse * c.normal.y * (c.b == 2 ? -1 : 1);
        // At any time the momentum of the box is that gained by gravity minus that absorbed by the floor.
        ASSERT_NEAR(mass * physics.velocity(2).y, impulse - mass * g * steps * dt - mass * g * dt, 1e-9)
            << steps;
    }
}

TEST(PhysicsAccuracy, AtRestTheFloorCarriesTheWeight) {
    Physics physics;
    add_floor(physics);
    physics.add(2, box({0.25, 0.25, 0.25}, 8), at({0, 0.25, 0}));
    physics.add(3, box({0.2, 0.2, 0.2}, 4), at({0, 0.7, 0}));
    for (int i = 0; i < 500; ++i) physics.step(dt);
    double on_floor = 0, on_box = 0;
    for (int i = 0; i < 1000; ++i) {
        physics.step(dt);
        for (const Contact& c : physics.contacts()) (c.b == 2 ? on_floor : on_box) += c.impulse;
    }
    EXPECT_NEAR(on_floor, 12 * g, 0.01 * 12 * g);
    EXPECT_NEAR(on_box, 4 * g, 0.01 * 4 * g);
}

TEST(PhysicsAccuracy, ASpinningTopKeepsItsMomentum) {
    Physics physics({.gravity = {}});
    // The box spins about its middle principal axis, so it tumbles.
    physics.add(2, box({0.1, 0.3, 0.5}, 6), {.spin = {0.2, 5, 0.1}});
    const auto momentum = [&] {
        const BodyState s = physics.state(2);
        const vec3 inertia = 6.0 / 3 * vec3{0.09 + 0.25, 0.01 + 0.25, 0.01 + 0.09};
        return s.orientation * (inertia * (glm::conjugate(s.orientation) * s.spin));
    };
    const vec3 before = momentum();
    for (int i = 0; i < 3000; ++i) physics.step(dt);
    EXPECT_LT(glm::length(momentum() - before), 0.05 * glm::length(before));
}

}  // namespace
}  // namespace thaum::physics
