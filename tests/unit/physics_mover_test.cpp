// Tests of walking wizards against closed forms.
#include "physics/mover.h"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/physics_scenes.h"

namespace thaum::physics {
namespace {

using namespace scenes;

constexpr Key me = 40;
constexpr double standing = 0.9;  // height of the capsule's centre above its soles (m)

struct Walker {
    Physics physics;
    MoverState state;
    MoverSettings settings;
    MoverResult last;
    double landing{};  ///< speed of the last landing (m/s)

    explicit Walker(const std::vector<TriangleMesh>& meshes = {}) : physics({}, meshes) {}
    void enter(vec3 position) { physics.add(me, mover_body, at(position)); }
    void tick(vec3 wish, bool jump = false) {
        last = move(physics, me, {.wish_velocity = wish, .jump = jump}, settings, state, dt);
        if (last.landing_speed > 0) landing = last.landing_speed;
        physics.step(dt);
    }
    void run(int ticks, vec3 wish) {
        for (int i = 0; i < ticks; ++i) tick(wish);
    }
    vec3 position() const { return physics.state(me).position; }
    vec3 velocity() const { return physics.velocity(me); }
    double pace() const { return std::hypot(velocity().x, velocity().z); }
};

struct FloorWalker : Walker {
    FloorWalker() { add_floor(physics); }
};

/// A slope through the origin that rises towards +x.
void add_slope(Physics& physics, double degrees, vec3 foot = {}) {
    const quat tilt = rotation({0, 0, 1}, degrees * radians_per_degree);
    physics.add(9, box({20, 1, 5}, 0), {.position = foot - tilt * vec3{0, 1, 0}, .orientation = tilt});
}

TEST(Mover, ReachesWalkingPace) {
    FloorWalker w;
    w.enter({0, standing, 0});
    w.run(300, {0, 0, -9});  // the wished speed exceeds walk_speed
    EXPECT_NEAR(w.velocity().z, -4.5, 1e-6);
    EXPECT_TRUE(w.last.grounded);
    EXPECT_EQ(w.last.ground, floor_key);
    w.run(300, {});
    EXPECT_NEAR(w.pace(), 0, 1e-6);
}

TEST(Mover, ARopeTakesAsMuchTractionAsWeight) {
    const double weight = 75 * 9.81;
    const auto speed_after = [&](double hung) {
        FloorWalker w;
        w.enter({0, standing, 0});
        w.run(100, {});
        for (int i = 0; i < 50; ++i) {
            w.last = move(w.physics, me, {.wish_velocity = {4.5, 0, 0}, .rope_lift = hung}, w.settings,
                          w.state, dt);
            w.physics.apply_central_impulse(me, {0, std::min(hung, weight) * dt, 0});
            w.physics.step(dt);
        }
        return w.velocity().x;
    };
    EXPECT_NEAR(speed_after(0), 40 * 0.05, 0.02);  // unloaded rope: acceleration as in walking
    EXPECT_NEAR(speed_after(weight / 2), 20 * 0.05, 0.02);
    // If the rope carries the whole weight, the wizard accelerates as in the air.
    EXPECT_NEAR(speed_after(weight), 4 * 0.05, 0.02);
    EXPECT_NEAR(speed_after(3 * weight), 4 * 0.05, 0.02);
}

TEST(Mover, JumpsToItsApex) {
    FloorWalker w;
    w.enter({0, standing, 0});
    w.run(200, {});
    const double ground = w.position().y;
    w.tick({}, true);
    EXPECT_TRUE(w.last.jumped);
    double apex = 0;
    for (int i = 0; i < 1200; ++i) {
        w.tick({});
        apex = std::max(apex, w.position().y - ground);
    }
    EXPECT_NEAR(apex, 1.1, 2e-4);
    EXPECT_NEAR(w.landing, w.settings.jump_speed, 0.1);
}

TEST(Mover, JumpsAsFarAsTheLawSays) {
    FloorWalker w;
    w.enter({0, standing, 0});
    w.run(500, {4.5, 0, 0});
    const double start = w.position().x;
    w.tick({4.5, 0, 0}, true);
    while (!w.last.grounded && w.physics.counters().steps < 5000) w.tick({4.5, 0, 0});
    // Expected distance: 4.26 m.
    EXPECT_NEAR(w.position().x - start, 4.5 * 2 * w.settings.jump_speed / 9.81, 0.05);
}

TEST(Mover, FallsFromFiveMetres) {
    FloorWalker w;
    w.enter({0, 5 + standing, 0});
    int ticks = 0;
    while (w.landing == 0 && ticks < 3000) {
        w.tick({});
        ++ticks;
    }
    EXPECT_NEAR(ticks * dt, std::sqrt(2 * 5 / 9.81), 0.01);
    // Expected: 9.90 m/s, or a little less, because the ground is found 3 cm early.
    EXPECT_NEAR(w.landing, std::sqrt(2 * 9.81 * 5), 0.06);
    w.run(500, {});
    EXPECT_NEAR(w.position().y, standing, 2e-3);
}

TEST(Mover, CrossesASeamWithoutAJolt) {
    for (const double seam : {0.0, 0.013, 0.0271}) {
        Walker w;
        w.physics.add(1, box({5, 1, 5}, 0), at({-5 + seam, -1, 0}));
        w.physics.add(2, box({5, 1, 5}, 0), at({5 + seam, -1, 0}));
        w.enter({-2.5, standing, 0.2});
        w.run(300, {4.5, 0, 0});
        for (int i = 0; i < 700; ++i) {
            w.tick({4.5, 0, 0});
            ASSERT_NEAR(w.velocity().x, 4.5, 0.005) << "at x = " << w.position().x;
            ASSERT_NEAR(w.position().y, standing, 2e-4) << "at x = " << w.position().x;
            ASSERT_TRUE(w.last.grounded);
        }
        EXPECT_GT(w.position().x, 1);
    }
}

TEST(Mover, CrossesTheEdgesOfAMeshWithoutAJolt) {
    Walker w({hills(16, 0)});
    w.physics.add(1, {.shape = Shape::mesh}, at({}));
    w.enter({-6, standing, 0.3});
    w.run(300, {4.4, 0, 0.7});
    for (int i = 0; i < 1800; ++i) {
        w.tick({4.4, 0, 0.7});
        ASSERT_NEAR(w.pace(), std::hypot(4.4, 0.7), 0.003) << "at x = " << w.position().x;
        ASSERT_NEAR(w.position().y, standing, 2e-4) << "at x = " << w.position().x;
    }
}

TEST(Mover, StandsStillOnASlope) {
    Walker w;
    add_slope(w.physics, 35);
    w.enter({0, 1.1, 0});
    w.run(500, {});
    const vec3 start = w.position();
    w.run(1500, {});
    EXPECT_LT(glm::length(w.position() - start), 1e-3);
    EXPECT_TRUE(w.last.grounded);
    EXPECT_NEAR(w.last.ground_normal.y, std::cos(35 * radians_per_degree), 1e-6);
}

TEST(Mover, SlidesOffASteepSlope) {
    Walker w;
    add_slope(w.physics, 60);
    w.enter({0, 1.5, 0});
    w.run(1000, {4.5, 0, 0});  // walks uphill without success
    EXPECT_LT(w.position().y, 1.0);
    EXPECT_FALSE(w.last.grounded);
}

TEST(Mover, WalksUpAndDownASlopeAtItsPace) {
    Walker w;
    add_slope(w.physics, 35);
    w.enter({0, 1.1, 0});
    w.run(500, {});
    for (const double way : {1.0, -1.0}) {
        w.run(400, {4.5 * way, 0, 0});
        EXPECT_NEAR(glm::length(w.velocity()), 4.5, 0.02);
        EXPECT_NEAR(w.velocity().y / w.velocity().x, std::tan(35 * radians_per_degree), 0.01);
        EXPECT_TRUE(w.last.grounded);
    }
}

TEST(Mover, WalksFromFloorToSlopeAndOverTheCrest) {
    FloorWalker w;
    add_slope(w.physics, 30);                                  // the slope rises from x = 0
    w.physics.add(8, box({4, 4, 5}, 0), at({4 + 4, 0.0, 0}));  // a plateau of 4 m height, from x = 4
    w.enter({-2, standing, 0});
    int in_air = 0;
    for (int i = 0; i < 2600; ++i) {
        w.tick({3, 0, 0});
        in_air += !w.last.grounded;
    }
    EXPECT_GT(w.position().y, standing + 2);
    EXPECT_LT(in_air, 60);
}

TEST(Mover, DoesNotClimbWalls) {
    FloorWalker w;
    w.physics.add(2, box({0.5, 5, 5}, 0), at({1.5, 5, 0}));
    w.enter({0, standing, 0});
    double highest = 0;
    for (int i = 0; i < 1500; ++i) {
        w.tick({4.5, 0, 0});
        highest = std::max(highest, w.position().y);
    }
    EXPECT_LT(highest, standing + 0.01);
    EXPECT_NEAR(w.position().x, 1 - 0.35, 0.01);
    w.tick({4.5, 0, 0}, true);
    for (int i = 0; i < 1500; ++i) {
        w.tick({4.5, 0, 0});
        highest = std::max(highest, w.position().y);
    }
    EXPECT_LT(highest, standing + 1.12);
    EXPECT_NEAR(w.position().y, standing, 0.01);
}

TEST(Mover, SlidesAlongAWall) {
    FloorWalker w;
    w.physics.add(2, box({0.5, 5, 50}, 0), at({1.5, 5, 0}));
    w.enter({0.6, standing, 0});
    w.run(1500, {3, 0, 3});
    EXPECT_GT(w.position().z, 2);
}

double pushed_distance(double mass, double friction) {
    FloorWalker w;
    w.physics.add(2, box({0.5, 0.5, 0.5}, mass, friction), at({1, 0.5, 0}));
    w.enter({0, standing, 0});
    w.run(1000, {4.5, 0, 0});  // long enough for the first collision to be over
    const double start = w.physics.state(2).position.x;
    w.run(2000, {4.5, 0, 0});
    return w.physics.state(2).position.x - start;
}

TEST(Mover, PushesWithAPersonsForce) {
    // The wizard pushes with 700 N. The coefficient of friction is 0.7 * 0.7, so a body of 60 kg needs 288 N
    // and moves; one of 300 kg needs 1,442 N and stays.
    EXPECT_GT(pushed_distance(60, 0.7), 1.0);
    EXPECT_LT(pushed_distance(300, 0.7), 0.01);
}

TEST(Mover, IsPushedByHeavyProps) {
    FloorWalker w;
    w.physics.add(2, box({0.5, 0.5, 0.5}, 400, 0), at({-2, 0.5, 0}, {3, 0, 0}));
    w.enter({0, standing, 0});
    w.run(1500, {});
    EXPECT_GT(w.position().x, 0.5);
}

TEST(Mover, AnIdleMoverFallsAsleepAndAWishWakesIt) {
    FloorWalker w;
    w.enter({0, standing, 0});
    w.run(4000, {});
    EXPECT_TRUE(w.physics.state(me).asleep);
    EXPECT_GT(w.physics.counters().skipped, 500U);
    EXPECT_TRUE(w.last.grounded);
    w.run(300, {1, 0, 0});
    EXPECT_NEAR(w.velocity().x, 1, 1e-6);
}

TEST(Mover, SlowWalkIsNotSleep) {
    FloorWalker w;
    w.enter({0, standing, 0});
    w.run(5000, {0.05, 0, 0});
    EXPECT_NEAR(w.position().x, 0.25, 0.02);
}

TEST(Mover, RidesAMovingProp) {
    FloorWalker w;
    w.physics.add(2, box({2, 0.5, 2}, 2000, 0), at({0, 0.5, 0}, {1, 0, 0}));
    w.enter({0, 1 + standing, 0});
    w.run(2000, {});
    EXPECT_NEAR(w.velocity().x, 1, 0.02);
    EXPECT_NEAR(w.position().x, w.physics.state(2).position.x, 0.1);
}

/// Largest speed of a walker who crosses a plank on the floor, and the plank's largest speed (m/s).
std::pair<double, double> fastest_over_plank(double thickness, double mass) {
    FloorWalker w;
    w.physics.add(2, box({0.3, thickness / 2, 1.5}, mass), at({4, thickness / 2, 0}));
    w.enter({0, standing, 0});
    double pace = 0, slide = 0;
    for (int i = 0; i < 1500; ++i) {
        w.tick({4.5, 0, 0});
        pace = std::max(pace, w.pace());
        slide = std::max(slide, w.physics.velocity(2).x);
    }
    EXPECT_GT(w.position().x, 5);
    return {pace, slide};
}

// A foot that strikes the edge of a plank pushes the plank ahead. A former fault: a walker on such a moving
// plank reached 6 m/s.
TEST(Mover, APlankUnderfootMakesNobodyFasterThanWalking) {
    for (const auto& [thickness, mass] : {std::pair(0.04, 12.0), {0.06, 15.0}, {0.1, 30.0}, {0.1, 100.0}}) {
        const auto [pace, slide] = fastest_over_plank(thickness, mass);
        EXPECT_GT(slide, 0.1) << "the plank is driven ahead";
        EXPECT_LE(pace, 4.5 + 0.05) << thickness << " m, " << mass << " kg";
    }
}

TEST(Mover, WalksAheadOnASlowRideAndStaysOnAFastOne) {
    const auto pace_on = [](double speed) {
        FloorWalker w;
        w.physics.add(2, box({20, 0.5, 2}, 20'000, 0), at({0, 0.5, 0}, {speed, 0, 0}));
        w.physics.add(me, mover_body, at({0, 1 + standing, 0}, {speed, 0, 0}));
        w.run(100, {});
        w.run(900, {4.5, 0, 0});
        return w.velocity().x;
    };
    EXPECT_NEAR(pace_on(2), 4.5, 0.02);
    EXPECT_NEAR(pace_on(6), 6, 0.05) << "no brake either";
}

TEST(Mover, WeighsOnWhatItStandsOn) {
    FloorWalker w;
    w.physics.add(2, box({0.5, 0.25, 0.5}, 20), at({0, 0.25, 0}));
    w.enter({0, 0.5 + standing, 0});
    w.run(1000, {});
    double down = 0;
    for (int i = 0; i < 500; ++i) {
        w.tick({});
        for (const Contact& c : w.physics.contacts()) down += c.a == 2 && c.b == me ? c.impulse : 0;
    }
    EXPECT_NEAR(down, 75 * 9.81 * 0.5, 4);
}

TEST(MoverDeath, AWishThatIsNotFinite) {
    Walker w;
    w.enter({});
    EXPECT_DEATH(w.tick({NAN, 0, 0}), "body 40: wish is not finite");
}

}  // namespace
}  // namespace thaum::physics
