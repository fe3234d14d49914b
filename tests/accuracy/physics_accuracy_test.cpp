// Against closed forms, and Bullet's own recurrence: semi-implicit Euler, first order.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/physics_scenes.h"

namespace thaum::physics {
namespace {

using namespace scenes;

constexpr double g = 9.81;

double fall_error(double step) {
    Physics physics;
    physics.add(2, ball(0.1, 1), at({0, 100, 0}));
    const int steps = static_cast<int>(std::lround(1 / step));
    for (int i = 0; i < steps; ++i) physics.step(step);
    return 100 - physics.state(2).position.y - g / 2;
}

TEST(PhysicsAccuracy, FreeFallErrsByItsRecurrenceAndNothingElse) {
    double before = 0;
    for (const double step : {0.001, 0.002, 0.004, 0.008}) {
        const double error = fall_error(step);
        EXPECT_NEAR(error, g * 1 * step / 2, 1e-11) << step;  // g t dt / 2
        if (before > 0) {
            EXPECT_NEAR(std::log2(error / before), 1, 1e-6) << "order";
        }
        before = error;
    }
}

TEST(PhysicsAccuracy, DampingIsItsShare) {
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
    EXPECT_NEAR(physics.velocity(1).x, 0.5, 1e-9);  // (m1 - m2) v1 / M + 2 m2 v2 / M
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
        // At every moment: what gravity gave less what the floor took is what the box has.
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
    physics.add(2, box({0.1, 0.3, 0.5}, 6), {.spin = {0.2, 5, 0.1}});  // about the middle axis: it tumbles
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
