// Tests of a wand's coupling (spring and damper to a held body) that moves rigid bodies by forces alone.
#include "game/wands/wand_coupling.h"

#include <gtest/gtest.h>

#include <cmath>

namespace thaum::game {
namespace {

constexpr physics::Key body = 1;
constexpr double dt = 1e-3;

physics::Physics world_with(double mass, vec3 place) {
    physics::Physics physics;
    physics.add(body, {.shape = physics::Shape::sphere, .size = {0.2, 0, 0}, .mass = mass},
                {.position = place});
    return physics;
}

/// One step of a spring to `to`. The coupling also cancels gravity.
void step_spring(physics::Physics& physics, const haptics::CouplingStep& step, vec3 to,
                 WandCoupling& coupling) {
    const auto result = haptics::couple(step, {.hand = to,
                                               .hand_velocity = {},
                                               .object = physics.state(body).position,
                                               .object_velocity = coupled_velocity(physics, body, coupling),
                                               .drag_velocity = {},
                                               .object_acceleration = {}});
    apply_coupling(physics, body, result, dt, coupling);
    physics.step(dt);
}

TEST(WandCoupling, AFreeBodyFollowsTheSpringsClosedForm) {
    constexpr double mass = 5, stiffness = 4000, damping = 25, start = 0.3;
    auto physics = world_with(mass, {start, 0, 0});
    const auto step = haptics::coupling_step({stiffness, damping, 0}, 1 / mass, 0, dt);
    WandCoupling coupling;
    const double decay = damping / (2 * mass), rate = std::sqrt(stiffness / mass - decay * decay);
    for (int i = 1; i <= 2000; ++i) {
        step_spring(physics, step, {}, coupling);
        const double t = i * dt;
        const double exact =
            start * std::exp(-decay * t) * (std::cos(rate * t) + decay / rate * std::sin(rate * t));
        ASSERT_NEAR(physics.state(body).position.x, exact, 1e-9) << i;
    }
    EXPECT_NEAR(physics.state(body).position.y, 0, 1e-9) << "its weight is held up";
}

TEST(WandCoupling, TheOwedVelocityIsGivenAtTheEnd) {
    auto physics = world_with(2, {0.1, 0, 0});
    const auto step = haptics::coupling_step({4000, 0, 0}, 0.5, 0, dt);
    WandCoupling coupling;
    for (int i = 0; i < 7; ++i) step_spring(physics, step, {}, coupling);
    const vec3 truly = coupled_velocity(physics, body, coupling);
    const double rate = std::sqrt(2000.0);
    EXPECT_NEAR(truly.x, -0.1 * rate * std::sin(rate * 7 * dt), 1e-9);
    end_coupling(physics, body, coupling);
    EXPECT_NEAR(physics.velocity(body).x, truly.x, 1e-12);
    EXPECT_EQ(coupling.owed, vec3(0));
}

TEST(WandCoupling, AWallHoldsAThingThatIsPulledThroughIt) {
    auto physics = world_with(20, {0, 0, 0});
    physics.add(2, {.shape = physics::Shape::box, .size = {0.05, 5, 5}, .mass = 0},
                {.position = {0.5, 0, 0}});
    const auto step = haptics::coupling_step({4000, 25, 100}, 1.0 / 20, 0, dt);
    WandCoupling coupling;
    for (int i = 0; i < 3000; ++i) {
        step_spring(physics, step, {2, 0, 0}, coupling);
        ASSERT_LT(physics.state(body).position.x, 0.26)
            // surface of the wall (0.45 m) minus the body's radius, plus what Bullet lets it sink in
            << i;
    }
    EXPECT_LT(glm::length(physics.velocity(body)), 0.05);
}

TEST(WandCoupling, ARopeKeepsASwingsEnergyAndIsSlackWithinItsLength) {
    const Rope rope{.anchor = {}, .length = 5, .stiffness = 4000};
    EXPECT_FALSE(hang(rope, 75, {3, 0, 0}, {}, {0, -9.81, 0}, dt));
    EXPECT_FALSE(hang(rope, 75, {0, 0, 0}, {}, {0, -9.81, 0}, dt));
    auto physics = world_with(75, {4, -3.2, 0});
    const auto energy = [&](vec3 velocity) {
        const vec3 place = physics.state(body).position;
        const double stretch = std::max(0.0, glm::length(place) - rope.length);
        return 75 * (glm::dot(velocity, velocity) / 2 + 9.81 * place.y) + 2000 * stretch * stretch;
    };
    const double before = energy({});
    WandCoupling coupling;
    double off = 0, lowest = 0;
    for (int i = 0; i < 20'000; ++i) {
        const auto result = hang(rope, 75, physics.state(body).position,
                                 coupled_velocity(physics, body, coupling), {0, -9.81, 0}, dt);
        result ? apply_coupling(physics, body, *result, dt, coupling) : end_coupling(physics, body, coupling);
        physics.step(dt);
        off = std::max(off, std::abs(energy(coupled_velocity(physics, body, coupling)) - before));
        lowest = std::min(lowest, physics.state(body).position.y);
    }
    EXPECT_LT(lowest, -5) << "it swings";
    EXPECT_LT(off, 1e-3 * 75 * 9.81 * 1.8) << "of the energy that is in the swing";
}

}  // namespace
}  // namespace thaum::game
