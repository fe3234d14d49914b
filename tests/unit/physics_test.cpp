// Tests of the interface of Physics: keys of bodies, sleep and waking, contacts, rays.
#include "physics/physics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "unit/physics_scenes.h"

namespace thaum::physics {
namespace {

using namespace scenes;

void run(Physics& physics, int steps) {
    for (int i = 0; i < steps; ++i) physics.step(dt);
}

const Contact* contact_of(const Physics& physics, Key a, Key b) {
    for (const Contact& c : physics.contacts()) {
        if (c.a == a && c.b == b) return &c;
    }
    return nullptr;
}

TEST(Physics, FindsBodiesByKey) {
    Physics physics;
    physics.add(5, ball(0.1, 1), at({1, 2, 3}));
    EXPECT_TRUE(physics.has(5));
    EXPECT_FALSE(physics.has(4));
    EXPECT_EQ(physics.state(5).position, vec3(1, 2, 3));
    EXPECT_EQ(physics.desc(5).mass, 1);
    physics.remove(5);
    EXPECT_FALSE(physics.has(5));
}

TEST(PhysicsDeath, WrongUseNamesTheKey) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Physics physics({.max_bodies = 2});
    physics.add(5, ball(0.1, 1), at({}));
    EXPECT_DEATH(physics.add(5, ball(0.1, 1), at({})), "body 5: added twice");
    EXPECT_DEATH(physics.add(6, ball(0.1, 1), at({nan, 0, 0})), "body 6: position is not finite");
    EXPECT_DEATH(physics.add(6, ball(-1, 1), at({})), "body 6: size is not positive");
    EXPECT_DEATH(physics.add(6, {.shape = Shape::mesh}, at({})), "body 6: unknown mesh");
    EXPECT_DEATH(physics.set_state(5, at({0, nan, 0})), "body 5: position is not finite");
    EXPECT_DEATH(physics.set_velocity(5, {0, 0, nan}), "body 5: velocity is not finite");
    EXPECT_DEATH(physics.apply_impulse(5, {nan, 0, 0}, {}), "body 5: impulse is not finite");
    EXPECT_DEATH(physics.state(9), "body 9: unknown");
    physics.add(7, ball(0.1, 1), at({3, 0, 0}));
    EXPECT_DEATH(physics.add(8, ball(0.1, 1), at({6, 0, 0})), "body 8: more bodies");
}

TEST(PhysicsDeath, AFullWorldIsAnErrorAndNotAnAllocation) {
    Physics physics({.max_contacts = 2});
    add_pile(physics);
    EXPECT_DEATH(run(physics, 1000), "more touching pairs than Settings.max_contacts");
}

TEST(Physics, ImpulsesTurnAndMove) {
    Physics physics;
    physics.add(1, ball(0.5, 2), at({}));
    physics.apply_impulse(1, {4, 0, 0}, {0, 0.5, 0});
    EXPECT_NEAR(physics.velocity(1).x, 2, 1e-15);
    EXPECT_NEAR(physics.state(1).spin.z, -0.5 * 4 / (0.4 * 2 * 0.25), 1e-12);  // inertia of a ball: 2/5 m r^2
}

TEST(Physics, UprightBodiesNeverTurn) {
    Physics physics;
    add_floor(physics);
    physics.add(2, wizard(), at({0, 0.95, 0}));
    physics.add(3, box({0.3, 0.3, 0.3}, 40), at({0.2, 1.6, -2}, {0, 0, 12}));
    run(physics, 1500);
    EXPECT_EQ(physics.state(2).orientation, quat(1, 0, 0, 0));
    EXPECT_EQ(physics.state(2).spin, vec3(0));
    EXPECT_GT(physics.state(2).position.z, 0.1);  // the box hit the wizard
}

TEST(Physics, LayersDecideWhichBodiesCollide) {
    Physics physics;
    add_floor(physics);
    BodyDesc ghost = ball(0.2, 1);
    ghost.layer = 4;
    ghost.collides_with = 8;
    physics.add(2, ghost, at({0, 1, 0}));
    BodyDesc one_sided = ball(0.2, 1);
    // This body would collide with the body `ghost`, but the ghost does not collide with this body's layer.
    // So it lands on the floor.
    one_sided.layer = 4;
    physics.add(3, one_sided, at({0, 2, 0}));
    run(physics, 2000);
    EXPECT_LT(physics.state(2).position.y, -5);
    EXPECT_NEAR(physics.state(3).position.y, 0.2, 0.01);
}

TEST(Physics, PropsSlideOverInnerEdges) {
    BodyDesc ground{.shape = Shape::mesh, .friction = 0};
    for (const BodyDesc& desc : {box({0.25, 0.25, 0.25}, 5, 0), ball(0.25, 3)}) {
        Physics physics({}, {hills(32, 0)});
        physics.add(1, ground, at({0.2, 0, 0}));
        physics.add(2, desc, at({-3, 0.25, 0.2}, {4, 0, 0.7}));
        for (int i = 0; i < 1500; ++i) {
            physics.step(dt);
            ASSERT_NEAR(physics.state(2).position.y, 0.25, 5e-4) << "at x = " << physics.state(2).position.x;
        }
        EXPECT_NEAR(physics.velocity(2).x, 4, 0.01);
    }
}

TEST(Physics, BallsRollOverSeams) {
    for (const double seam : {0.0, 0.013, 0.0271, 0.2}) {
        Physics physics;
        physics.add(1, box({5, 1, 5}, 0), at({-5 + seam, -1, 0}));
        physics.add(2, box({5, 1, 5}, 0), at({5 + seam, -1, 0}));
        physics.add(3, {.shape = Shape::sphere, .size = {0.2, 0, 0}, .mass = 3},
                    at({-1, 0.2, 0}, {4.5, 0, 0}));
        for (int i = 0; i < 600; ++i) {
            physics.step(dt);
            ASSERT_NEAR(physics.state(3).position.y, 0.2, 5e-4) << "at x = " << physics.state(3).position.x;
        }
        EXPECT_GT(physics.state(3).position.x, 0.5);
    }
}

TEST(PhysicsSleep, ABodyAddedAsleepStaysAsleep) {
    Physics physics;
    BodyState moving_sleeper = at({0, 5, 0}, {1, 1, 1});
    moving_sleeper.asleep = 1;
    // A body in mid-air, with a velocity that a sleeping body cannot have.
    physics.add(2, ball(0.2, 1), moving_sleeper);
    run(physics, 100);
    EXPECT_EQ(physics.state(2).position, vec3(0, 5, 0));
    EXPECT_EQ(physics.velocity(2), vec3(0));
    physics.wake(2);
    run(physics, 100);
    EXPECT_LT(physics.state(2).position.y, 5);
}

TEST(PhysicsSleep, ARestingSceneIsNotStepped) {
    Physics physics;
    add_pile(physics);
    run(physics, 12000);
    EXPECT_EQ(physics.counters().awake, 0U);
    EXPECT_GT(physics.counters().skipped, 1000U);
    EXPECT_TRUE(physics.contacts().empty());
}

struct Asleep : testing::Test {
    Physics physics;
    Asleep() {
        add_floor(physics);
        physics.add(2, box({0.5, 0.5, 0.5}, 10), at({0, 0.5, 0}));
        physics.add(3, box({0.3, 0.3, 0.3}, 5), at({0, 1.3, 0}));
        physics.add(4, box({0.3, 0.3, 0.3}, 5), at({9, 0.3, 0}));
        run(physics, 4000);
    }
    void SetUp() override {
        for (const Key key : {2U, 3U, 4U}) ASSERT_TRUE(physics.state(key).asleep) << key;
    }
};

TEST_F(Asleep, AnImpulseWakesWhatItTouches) {
    physics.apply_central_impulse(2, {3, 0, 0});
    run(physics, 3);
    EXPECT_FALSE(physics.state(2).asleep);
    EXPECT_FALSE(physics.state(3).asleep);
    EXPECT_TRUE(physics.state(4).asleep);
}

TEST_F(Asleep, ANudgeDoesNotWake) {
    physics.nudge(2, {3, 0, 0});
    run(physics, 3);
    EXPECT_TRUE(physics.state(2).asleep);
    EXPECT_EQ(physics.velocity(2), vec3(0));
}

TEST_F(Asleep, ARemovedSupportLetsFall) {
    physics.remove(2);
    run(physics, 1000);
    EXPECT_NEAR(physics.state(3).position.y, 0.3, 0.01);
}

TEST_F(Asleep, ARemovedFloorLetsFallEvenAfterARebuild) {
    physics.rebuild();
    EXPECT_TRUE(physics.state(4).asleep);
    physics.remove(floor_key);
    run(physics, 500);
    EXPECT_LT(physics.state(4).position.y, -0.5);
}

TEST_F(Asleep, AMovedSupportLetsFall) {
    physics.set_state(2, at({4, 0.5, 0}));
    run(physics, 1000);
    EXPECT_NEAR(physics.state(3).position.y, 0.3, 0.01);
}

/// The bounding box of a body at rest is not computed again until the body is moved.
TEST_F(Asleep, AMovedWallStopsWhatMeetsIt) {
    physics.add(8, box({0.2, 1, 1}, 0), at({40, 1, 0}));
    run(physics, 10);
    physics.set_state(8, at({20, 1, 0}));
    physics.add(9, ball(0.2, 5), at({18, 1, 0}, {10, 0, 0}));
    run(physics, 500);
    EXPECT_LT(physics.state(9).position.x, 19.7);
}

TEST_F(Asleep, ANewBodyWakesWhatItHits) {
    physics.add(9, ball(0.2, 5), at({0, 2.2, 0}));
    run(physics, 600);
    EXPECT_FALSE(physics.state(3).asleep);
}

TEST(PhysicsContacts, BeginOnceAndPointUp) {
    Physics physics;
    physics.add(7, box({5, 1, 5}, 0), at({0, -1, 0}));
    physics.add(2, box({0.5, 0.5, 0.5}, 10), at({0, 0.7, 0}));
    int began = 0;
    for (int i = 0; i < 1000; ++i) {
        physics.step(dt);
        if (const Contact* c = contact_of(physics, 2, 7)) began += c->began;
    }
    EXPECT_EQ(began, 1);
    const Contact* c = contact_of(physics, 2, 7);
    ASSERT_TRUE(c);
    EXPECT_NEAR(c->normal.y, 1, 1e-9);  // the normal points from body 7 towards body 2
    EXPECT_NEAR(c->point.y, 0, 1e-3);
    EXPECT_NEAR(c->impulse, 10 * 9.81 * dt, 1e-3);
    physics.rebuild();
    physics.step(dt);
    c = contact_of(physics, 2, 7);
    ASSERT_TRUE(c);
    EXPECT_FALSE(c->began) << "a rebuild is not an impact";
}

TEST(PhysicsContacts, AreSortedByKeys) {
    Physics physics;
    add_pile(physics);
    run(physics, 600);
    const auto contacts = physics.contacts();
    ASSERT_GT(contacts.size(), 10U);
    for (std::size_t i = 1; i < contacts.size(); ++i) {
        EXPECT_LT(std::pair(contacts[i - 1].a, contacts[i - 1].b), std::pair(contacts[i].a, contacts[i].b));
    }
}

// A ray from +x hits one body of each shape at x = 10.
struct RayShapes : testing::TestWithParam<Shape> {
    static BodyDesc desc(Shape shape) {
        if (shape == Shape::box) return box({0.5, 1, 1}, 0);
        return {.shape = shape, .size = {0.5, 1, 0}};
    }
};

TEST_P(RayShapes, HitTheSurfaceExactly) {
    Physics physics;
    physics.add(3, desc(GetParam()), {.position = {1, 2, 3}, .orientation = rotation({0, 1, 0}, pi)});
    const auto hit = physics.ray({10, 2, 3}, {-10, 2, 3});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->key, 3U);
    EXPECT_NEAR(hit->point.x, 1.5, 2e-9);
    EXPECT_NEAR(hit->fraction, 8.5 / 20, 1e-10);
    EXPECT_NEAR(hit->normal.x, 1, 1e-6);
    EXPECT_FALSE(physics.ray({10, 2, 3}, {1.6, 2, 3})) << "too short";
    EXPECT_FALSE(physics.ray({10, 5, 3}, {-10, 5, 3})) << "above";
    const auto thick = physics.sweep_sphere({10, 2, 3}, {-10, 2, 3}, 0.25);
    ASSERT_TRUE(thick);
    EXPECT_NEAR(thick->point.x, 1.5, 2e-9);
    EXPECT_NEAR(thick->fraction, 8.25 / 20, 1e-10);
}

TEST_P(RayShapes, FromInsideHitsAtOnce) {
    Physics physics;
    physics.add(3, desc(GetParam()), at({0, 0, 0}));
    const auto hit = physics.ray({0.1, 0.05, 0.02}, {5, 0, 0});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->fraction, 0);
    EXPECT_LT(hit->normal.x, -0.99);
    EXPECT_FALSE(physics.ray({0.1, 0, 0}, {5, 0, 0}, all_layers, 3));
    EXPECT_FALSE(physics.ray({0.1, 0, 0}, {5, 0, 0}, 2));
}

INSTANTIATE_TEST_SUITE_P(All, RayShapes,
                         testing::Values(Shape::box, Shape::sphere, Shape::capsule, Shape::cylinder));

TEST(PhysicsRay, AgreesWithFineSampling) {
    // The oracle moves along the ray in steps of 0.1 mm and tests whether the point is inside the rotated
    // box.
    Physics physics;
    const quat turn = rotation(glm::normalize(vec3{1, 2, 3}), 0.7);
    physics.add(3, box({0.4, 0.05, 0.8}, 0), {.position = {0.1, 0.2, 0.3}, .orientation = turn});
    Random random{3};
    int hits = 0;
    for (int i = 0; i < 300; ++i) {
        const auto coordinate = [&] { return random.uniform() * 4 - 2; };
        const vec3 from{coordinate(), coordinate(), coordinate()},
            to{coordinate() / 2, coordinate() / 2, coordinate() / 2};
        double first = -1;
        const double length = glm::length(to - from);
        const int samples = static_cast<int>(length / 1e-4);
        for (int s = 0; s <= samples && first < 0; ++s) {
            const vec3 p =
                glm::conjugate(turn) * (from + (to - from) * (double(s) / samples) - vec3{0.1, 0.2, 0.3});
            if (std::abs(p.x) <= 0.4 && std::abs(p.y) <= 0.05 && std::abs(p.z) <= 0.8)
                first = double(s) / samples;
        }
        const auto hit = physics.ray(from, to);
        if (first >= 0) {
            ASSERT_TRUE(hit) << i;
            EXPECT_NEAR(hit->fraction * length, first * length, 2e-4) << i;
            ++hits;
        } else if (hit) {
            // The oracle's steps may miss a corner; the hit must then still be on the surface.
            const vec3 p = glm::abs(glm::conjugate(turn) * (hit->point - vec3{0.1, 0.2, 0.3}));
            EXPECT_NEAR(glm::length(glm::max(p - vec3{0.4, 0.05, 0.8}, vec3(0))), 0, 1e-8);
        }
    }
    EXPECT_GT(hits, 30);
}

TEST(PhysicsRay, NothingTunnelsThroughACentimetre) {
    Physics physics;
    physics.add(2, box({0.005, 2, 2}, 0), at({0, 0, 0}));
    Random random{4};
    const double step = 400 * dt;
    for (int i = 0; i < 2000; ++i) {  // a fast projectile, moved 0.4 m in each tick
        vec3 from{-1 - random.uniform(), random.uniform() - 0.5, random.uniform() - 0.5};
        const vec3 way = glm::normalize(vec3{1, random.uniform() - 0.5, random.uniform() - 0.5}) * step;
        bool hit = false;
        for (int tick = 0; tick < 10 && !hit; ++tick, from += way)
            hit = physics.ray(from, from + way).has_value();
        ASSERT_TRUE(hit) << i;
    }
    // A ray along the edge hits the body; a ray 10 nm beside the edge misses it.
    EXPECT_TRUE(physics.ray({0, 500, 0}, {0, -500, 0}));
    EXPECT_TRUE(physics.ray({0.005, 500, 0}, {0.005, -500, 0}));
    EXPECT_FALSE(physics.ray({0.00500001, 500, 0}, {0.00500001, -500, 0}));
}

TEST(PhysicsRay, AmongEqualsTheLowerKeyWins) {
    for (const bool swapped : {false, true}) {
        Physics physics;
        physics.add(swapped ? 8 : 2, ball(1, 0), at({}));
        physics.add(swapped ? 2 : 8, ball(1, 0), at({}));
        EXPECT_EQ(physics.ray({5, 0, 0}, {-5, 0, 0})->key, 2U);
    }
}

TEST(PhysicsRay, HitsMeshes) {
    Physics physics({}, {hills(8, 0)});
    physics.add(2, {.shape = Shape::mesh}, {.position = {0, 1, 0}, .orientation = rotation({0, 1, 0}, 0.3)});
    Random random{5};
    for (int i = 0; i < 200; ++i) {  // hits on the seam of two triangles must be exact
        const double x = std::floor(random.uniform() * 5) - 2, z = random.uniform() * 4 - 2;
        const vec3 seam = rotation({0, 1, 0}, 0.3) * vec3{x, 0, z};
        const auto hit = physics.ray(seam + vec3{0, 300, 0}, seam - vec3{0, 300, 0});
        ASSERT_TRUE(hit);
        EXPECT_NEAR(hit->point.y, 1, 2e-9);
        EXPECT_NEAR(hit->normal.y, 1, 1e-6);
    }
    const auto sphere = physics.sweep_sphere({0.2, 4, 0.1}, {0.3, -4, 0.2}, 0.5);
    ASSERT_TRUE(sphere);
    EXPECT_NEAR(sphere->point.y, 1, 2e-9);
    EXPECT_NEAR(sphere->fraction, 2.5 / 8, 1e-9);
    EXPECT_FALSE(physics.ray({9, 5, 9}, {9, -5, 9}));
}

}  // namespace
}  // namespace thaum::physics
