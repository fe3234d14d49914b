// Hostile scenes: all bodies must stay finite, within the limits in physics::Settings, and above the floor.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "physics/mover.h"
#include "unit/physics_scenes.h"

namespace thaum::physics {
namespace {

using namespace scenes;

void expect_bounded(const Physics& physics, const Keys& keys) {
    for (const Key key : keys) {
        const BodyState& s = physics.state(key);
        ASSERT_TRUE(is_finite(s.position) && is_finite(s.velocity) && is_finite(s.spin)) << key;
        ASSERT_LE(glm::length(s.velocity), physics.settings().max_speed * (1 + 1e-12)) << key;
        ASSERT_LE(glm::length(s.spin), physics.settings().max_spin * (1 + 1e-12)) << key;
        ASSERT_NEAR(glm::dot(s.orientation, s.orientation), 1, 1e-6) << key;
    }
}

/// Thick walls on all sides, 20 m apart.
void add_room(Physics& physics) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const int side : {0, 1}) {
            vec3 place{};
            place[axis] = side ? 15 : -15;
            physics.add(static_cast<Key>(1 + 2 * axis + side), box({15, 15, 15}, 0), at(place * 1.6667));
        }
    }
}

TEST(PhysicsStability, HardKicksStayInTheRoom) {
    Physics physics;
    add_room(physics);
    Keys keys;
    Random random{1};
    for (Key key = 10; key < 40; ++key) {
        const Key storey = key / 10;
        physics.add(key, box({0.3, 0.3, 0.3}, 1), at({key % 5 - 2.0, storey * 1.0, key % 3 - 1.0}));
        keys.push_back(key);
    }
    for (int tick = 0; tick < 3000; ++tick) {
        if (tick % 10 == 0 && tick < 2000) {
            const vec3 way{random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5};
            const Key key = keys[static_cast<std::size_t>(tick / 10) % keys.size()];
            physics.apply_impulse(key, 1000.0 * way, physics.state(key).position + 0.3 * way);
        }
        physics.step(dt);
        expect_bounded(physics, keys);
        if (HasFatalFailure()) return;
    }
    for (const Key key : keys) {
        const vec3 p = glm::abs(physics.state(key).position);
        EXPECT_LT(std::max({p.x, p.y, p.z}), 10.1) << key;
    }
}

TEST(PhysicsStability, TwentyBoxesInOnePlaceComeApartGently) {
    Physics physics;
    add_floor(physics);
    Keys keys;
    for (Key key = 10; key < 30; ++key) {
        physics.add(key, box({0.25, 0.25, 0.25}, 5), at({0, 1, 0}));
        keys.push_back(key);
    }
    double fastest = 0;
    for (int tick = 0; tick < 4000; ++tick) {
        physics.step(dt);
        expect_bounded(physics, keys);
        if (HasFatalFailure()) return;
        for (const Key key : keys) fastest = std::max(fastest, glm::length(physics.velocity(key)));
    }
    EXPECT_LT(fastest, 15);  // larger speeds would be an explosion of the solver
    for (const Key key : keys) EXPECT_GT(physics.state(key).position.y, 0.2) << key;
}

TEST(PhysicsStability, AGramOnATonneAndATonneOnAGram) {
    Physics physics;
    add_floor(physics);
    physics.add(10, box({0.5, 0.5, 0.5}, 1000), at({0, 0.5, 0}));
    physics.add(11, box({0.05, 0.05, 0.05}, 0.001), at({0, 1.05, 0}));
    physics.add(12, box({0.05, 0.05, 0.05}, 0.001), at({3, 0.05, 0}));
    physics.add(13, box({0.5, 0.5, 0.5}, 1000), at({3, 0.6, 0}));
    for (int tick = 0; tick < 4000; ++tick) {
        physics.step(dt);
        expect_bounded(physics, {10, 11, 12, 13});
        if (HasFatalFailure()) return;
    }
    EXPECT_NEAR(physics.state(11).position.y, 1.05, 0.01);
    EXPECT_GT(physics.state(13).position.y, 0.45);
    EXPECT_GT(physics.state(12).position.y, -0.1);
}

TEST(PhysicsStability, ThousandsOfBodiesAreAddedAndRemoved) {
    Physics physics({.max_bodies = 128});
    add_floor(physics);
    Random random{2};
    Keys keys;
    Key next = 10;
    for (int act = 0; act < 6000; ++act) {
        const bool adding = keys.size() < 20 || (keys.size() < 100 && random.uniform() < 0.5);
        if (adding) {
            const vec3 place{random.uniform() * 6 - 3, 0.5 + random.uniform() * 3, random.uniform() * 6 - 3};
            physics.add(next, act % 2 ? box({0.2, 0.2, 0.2}, 2) : ball(0.2, 2), at(place));
            keys.push_back(next++);
        } else {
            const auto index = static_cast<std::size_t>(random.uniform() * static_cast<double>(keys.size()));
            physics.remove(keys[index]);
            keys.erase(keys.begin() + static_cast<std::ptrdiff_t>(index));
        }
        if (act % 5 == 0) physics.step(dt);
        if (act % 1000 == 999) physics.rebuild();
    }
    expect_bounded(physics, keys);
    EXPECT_EQ(physics.counters().bodies, keys.size() + 1);
}

TEST(PhysicsStability, FarOutsideTheWorld) {
    Physics physics;
    Keys keys;
    for (Key key = 1; key <= 12; ++key) {
        const double far = std::pow(10.0, key);
        physics.add(key, box({0.2, 0.2, 0.2}, 2), at({far, -far, far}, {50, 0, 0}));
        keys.push_back(key);
    }
    for (int tick = 0; tick < 500; ++tick) physics.step(dt);
    physics.rebuild();
    for (int tick = 0; tick < 500; ++tick) physics.step(dt);
    expect_bounded(physics, keys);
    EXPECT_FALSE(physics.ray({0, 0, 0}, {1e6, 0, 0}));
}

TEST(PhysicsStability, ASweptBallStopsAtAThinWall) {
    Physics physics({.gravity = {}});
    physics.add(1, box({0.01, 3, 3}, 0), at({5, 0, 0}));
    BodyDesc shot = ball(0.05, 0.5);
    shot.swept = 1;
    for (Key key = 10; key < 30; ++key)
        physics.add(key, shot, at({0.017 * key, 0.2 * key - 4, 0}, {150, 0, 0}));
    for (int tick = 0; tick < 200; ++tick) physics.step(dt);
    for (Key key = 10; key < 30; ++key) EXPECT_LT(physics.state(key).position.x, 5) << key;
}

TEST(PhysicsStability, AWizardAmongHostileProps) {
    Physics physics;
    add_room(physics);
    physics.add(100, mover_body, at({0, -9, 0}));
    Keys keys{100};
    Random random{6};
    for (Key key = 10; key < 30; ++key) {
        const Key storey = key / 4;
        physics.add(key, box({0.4, 0.4, 0.4}, key % 2 ? 0.1 : 500),
                    at({key % 4 - 2.0, storey - 6.0, key % 3 - 1.0}));
        keys.push_back(key);
    }
    MoverState state;
    for (int tick = 0; tick < 4000; ++tick) {
        const vec3 wish{random.uniform() * 1e6 - 5e5, 1e9, random.uniform() * 1e6 - 5e5};
        move(physics, 100, {wish, random.uniform() < 0.1}, {}, state, dt);
        if (tick % 20 == 0) physics.set_velocity(10 + static_cast<Key>(tick / 20) % 20, {60, 20, -60});
        physics.step(dt);
        expect_bounded(physics, keys);
        if (HasFatalFailure()) return;
    }
    const vec3 p = glm::abs(physics.state(100).position);
    EXPECT_LT(std::max({p.x, p.y, p.z}), 10.1);
}

TEST(PhysicsStability, FreeFlightAtAnyStepAndSpeed) {
    for (const double step : {1e-12, 1e-6, 0.001, 1.0, 1e6}) {
        for (const double speed : {0.0, 1e-300, 199.0, 1e9, 1e300}) {
            Physics physics;
            BodyDesc damped = ball(0.1, 1);
            damped.linear_damping = 0.999;
            physics.add(2, ball(0.1, 1), at({}, {speed, 0, 0}));
            physics.add(3, damped, at({0, 100, 0}, {0, -speed, 0}));
            for (int i = 0; i < 5; ++i) {
                physics.step(step);
                for (const Key key : {2U, 3U}) {
                    ASSERT_TRUE(is_finite(physics.state(key).position)) << step << ' ' << speed;
                    ASSERT_LE(glm::length(physics.velocity(key)), physics.settings().max_speed * (1 + 1e-9));
                }
            }
        }
    }
}

TEST(PhysicsStability, ASweptBallFallingFastStillStopsAtAThinFloor) {
    Physics physics;
    physics.add(1, box({5, 0.005, 5}, 0), at({0, 0, 0}));
    BodyDesc desc = ball(0.05, 1);
    desc.swept = 1;
    for (Key i = 0; i < 50; ++i)
        physics.add(10 + i, desc, at({-4.0 + 0.16 * i, 3 + 0.013 * i, 0}, {0, -190, 0}));
    for (int i = 0; i < 500; ++i) physics.step(0.001);
    for (Key i = 0; i < 50; ++i) EXPECT_GT(physics.state(10 + i).position.y, 0) << i;
}

TEST(PhysicsStability, ThousandsFlyExactlyBesideEachOther) {
    constexpr Key count = 2000;
    Physics physics({.max_bodies = count});
    const auto start = [](Key i) {
        const Key column = i % 13, layer = i / 13 % 13, row = i / 169;
        return vec3(column, 2.0 * layer, 2.0 * row);
    };
    for (Key i = 0; i < count; ++i) physics.add(i, ball(0.1, 1), at(start(i), {0, 0.001 * i, 1}));
    for (int i = 0; i < 100; ++i) physics.step(0.001);
    for (Key i = 0; i < count; ++i) {
        const vec3 exact = start(i) + vec3(0, 0.0001 * i - 9.81 * 0.01 / 2, 0.1);
        ASSERT_LT(glm::length(physics.state(i).position - exact), 1e-11) << i;
    }
}

}  // namespace
}  // namespace thaum::physics
