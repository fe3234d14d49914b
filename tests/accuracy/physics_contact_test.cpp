// Tests of bounces against Newton's law of restitution, of swept bodies against thin walls, of stacks under a
// heavy load, and of the contact of a person and a box.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "physics/detail/capsule_box.h"
#include "unit/physics_scenes.h"

namespace thaum::physics {
namespace {

using namespace scenes;

/// Square of 100 m by 100 m in the plane y = 0.
TriangleMesh level_ground() {
    return {{{-50, 0, -50}, {50, 0, -50}, {50, 0, 50}, {-50, 0, 50}}, {{0, 2, 1}, {0, 3, 2}}};
}

double half_height(const BodyDesc& d) {
    if (d.shape == Shape::sphere) return d.size.x;
    return d.shape == Shape::capsule ? d.size.x + d.size.y : d.size.y;
}

/// A body dropped onto the ground. The body and the ground have the same restitution.
struct Drop {
    Physics physics{{}, {level_ground()}};
    double step;
    double rest_height{};  ///< height of the body's centre when it lies on the ground (m)

    Drop(Shape shape, Shape ground, double restitution, double height, double step_s) : step(step_s) {
        BodyDesc floor{.shape = ground, .size = {50, 1, 50}, .restitution = 1};
        physics.add(1, floor, at({0, ground == Shape::mesh ? 0.0 : -1.0, 0}));
        BodyDesc body{
            .shape = shape, .size = {0.1, 0.1, 0.1}, .mass = 1, .friction = 0, .restitution = restitution};
        rest_height = half_height(body);
        physics.add(2, body, at({0, rest_height + height, 0}));
    }

    double above() const { return physics.state(2).position.y - rest_height; }

    /// Speed that the body would have at the ground, from its energy at its present height (m/s).
    double speed_at_ground(double height) const {
        const double speed = physics.velocity(2).y;
        return std::sqrt(std::max(0.0, speed * speed + 2 * 9.81 * height));
    }

    /// Rebound speed divided by approach speed at the next bounce, both at the ground.
    double next_bounce() {
        double before = 0, approach = 0, now = 0;
        for (double s = 0; now <= before + 0.01 && s < 3; s += step) {
            before = physics.velocity(2).y;
            approach = speed_at_ground(above());
            physics.step(step);
            now = physics.velocity(2).y;
        }
        // The solver first moves the body out of the ground, which adds no speed, and a corner may touch a
        // step later. So the fastest of the next steps counts.
        double fastest = speed_at_ground(std::max(0.0, above()));
        for (int i = 0; i < 3; ++i) {
            physics.step(step);
            if (physics.velocity(2).y > 0)
                fastest = std::max(fastest, speed_at_ground(std::max(0.0, above())));
        }
        return fastest / approach;
    }
};

class Restitution : public ::testing::TestWithParam<std::tuple<Shape, Shape, double>> {};

TEST_P(Restitution, ReboundSpeedIsItsShareOfTheApproach) {
    const auto [shape, ground, step] = GetParam();
    const double tolerance = shape == Shape::cylinder ? 0.05 : shape == Shape::box ? 0.02 : 0.001;
    for (const double e : {1.0, 0.7, 0.4}) {
        for (double height = 0.1; height < 4; height *= 1.17) {
            Drop drop(shape, ground, e, height, step);
            EXPECT_NEAR(drop.next_bounce(), e, tolerance) << "from " << height << " m";
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Physics, Restitution,
    ::testing::Combine(::testing::Values(Shape::box, Shape::sphere, Shape::capsule, Shape::cylinder),
                       ::testing::Values(Shape::box, Shape::mesh), ::testing::Values(0.001, 0.002, 0.004)));

/// Each bounce reaches e^2 of the previous height, where e is the restitution. No step adds energy, and
/// little energy is lost.
TEST(PhysicsBounce, BallComesToTheSameHeightAgain) {
    for (const double e : {1.0, 0.8}) {
        Drop drop(Shape::sphere, Shape::box, e, 1, dt);
        double height = 1;
        for (int bounce = 0; bounce < 8; ++bounce) {
            drop.next_bounce();
            double top = 0;
            while (drop.physics.velocity(2).y > 0) {
                drop.physics.step(dt);
                top = std::max(top, drop.physics.state(2).position.y - 0.1);
            }
            EXPECT_NEAR(top / height, e * e, 0.015) << "bounce " << bounce;
            height = top;
        }
    }
}

/// Each bounce leaves the share e^2 of the energy (e: restitution), for every time step and many heights.
TEST(PhysicsBounce, EachBounceKeepsItsShareOfTheEnergyAtEveryStep) {
    for (const double e : {1.0, 0.8}) {
        for (const double step : {0.001, 0.002, 0.004, 0.008}) {
            for (double height = 0.5; height < 3; height *= 1.09) {
                Drop drop(Shape::sphere, Shape::box, e, height, step);
                for (int bounce = 0; bounce < 5; ++bounce) {
                    EXPECT_NEAR(drop.next_bounce(), e, 1e-5)
                        << "bounce " << bounce << " from " << height << " m at a step of " << step << " s";
                }
            }
        }
    }
}

TEST(PhysicsBounce, FastBallAgainstTheSeamOfTwoFloorsBouncesAsOnOne) {
    for (const double speed : {3.0, 17.0, 60.0}) {
        Physics physics({.gravity = {}});
        BodyDesc floor = box({5, 1, 5}, 0, 0);
        floor.restitution = 1;
        physics.add(1, floor, at({-5, -1, 0}));
        physics.add(2, floor, at({5, -1, 0}));
        BodyDesc shot = ball(0.1, 1);
        shot.restitution = 1;
        shot.friction = shot.rolling_friction = 0;
        const double from = 0.1 + speed * 0.01 + 0.0003;
        physics.add(3, shot, at({0, from, 0}, {0, -speed, 0}));
        for (int i = 0; i < 20; ++i) physics.step(dt);
        EXPECT_NEAR(physics.velocity(3).y, speed, 1e-3 * speed);
        // The flight lasts 20 ms in all, so the time upwards is 20 ms minus the time downwards.
        const double down = (from - 0.1) / speed;
        EXPECT_NEAR(physics.state(3).position.y, 0.1 + speed * (0.02 - down), 0.002 * speed * dt) << speed;
    }
}

/// Below 0.2 m/s a ball comes to rest, as in Bullet, and does not tremble forever.
TEST(PhysicsBounce, BouncingBallComesToRestOnTheFloor) {
    Drop drop(Shape::sphere, Shape::box, 0.6, 0.5, dt);
    for (int i = 0; i < 8000; ++i) drop.physics.step(dt);
    EXPECT_TRUE(drop.physics.state(2).asleep);
    EXPECT_NEAR(drop.physics.state(2).position.y, 0.1, 1e-3);
}

/// Throws a body from a random side at a wall of 2 cm, or a wall of triangles without thickness. Returns
/// whether the body passes through.
bool comes_through(Shape shape, vec3 size, Shape wall, double step, std::uint64_t seed) {
    const TriangleMesh sheet{{{0, -3, -3}, {0, 3, -3}, {0, 3, 3}, {0, -3, 3}}, {{0, 2, 1}, {0, 3, 2}}};
    Random random{seed};
    Physics physics({.gravity = {}}, {sheet});
    physics.add(1, {.shape = wall, .size = {0.01, 3, 3}}, {});
    const vec3 axis{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const vec3 way = glm::normalize(vec3{1, random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)});
    const vec3 spin{random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(-50, 50)};
    physics.add(2, {.shape = shape, .size = size, .mass = 0.5, .friction = 0.3, .swept = 1},
                {.position = {-random.uniform(0.5, 0.8), 0, 0},
                 .orientation = rotation(glm::normalize(axis), random.uniform(0, 2 * pi)),
                 .velocity = random.uniform(50, 200) * way,
                 .spin = spin});
    for (int i = 0; i < 100; ++i) {
        physics.step(step);
        const vec3 p = physics.state(2).position;
        if (p.x > 0 && std::abs(p.y) < 2.5 && std::abs(p.z) < 2.5) return true;
    }
    return false;
}

class Swept : public ::testing::TestWithParam<std::tuple<Shape, Shape, double>> {};

TEST_P(Swept, NothingPassesThroughAThinWall) {
    const auto [shape, wall, step] = GetParam();
    int through = 0;
    for (std::uint64_t i = 0; i < 100; ++i) {
        for (const vec3 size : {vec3{0.03, 0.2, 0.03}, vec3{0.05, 0.1, 0.05}, vec3{0.1, 0.03, 0.05}})
            through += comes_through(shape, size, wall, step, i) ? 1 : 0;
    }
    EXPECT_EQ(through, 0) << "of 300";
}

INSTANTIATE_TEST_SUITE_P(
    Physics, Swept,
    ::testing::Combine(::testing::Values(Shape::box, Shape::sphere, Shape::capsule, Shape::cylinder),
                       ::testing::Values(Shape::box, Shape::mesh), ::testing::Values(0.001, 0.004)));

/// A body that passes beside a wall or slides along it is not stopped.
TEST(PhysicsSwept, AFreePathIsNotStopped) {
    Physics physics({.gravity = {}});
    physics.add(1, box({0.01, 3, 3}, 0), {});
    BodyDesc shot = box({0.05, 0.05, 0.05}, 0.5, 0);
    shot.swept = 1;
    physics.add(2, shot, at({-5, 3.2, 0}, {150, 0, 0}));
    physics.add(3, shot, at({-0.0601, -2, 0}, {0, 150, 0}));
    for (int i = 0; i < 50; ++i) physics.step(dt);
    EXPECT_NEAR(physics.state(2).position.x, 2.5, 1e-9);
    EXPECT_NEAR(physics.state(3).position.y, 5.5, 1e-6);
}

/// Distance by which a heavy box on four boxes of 2 kg has sunk at the end (m).
double sunk_stack(double half, double load) {
    Physics physics;
    add_floor(physics);
    for (Key i = 0; i < 5; ++i) {
        const vec3 place{0.003 * i, half + 2 * half * i, 0.002 * (i % 2)};
        physics.add(10 + i, box(vec3(half), i == 4 ? load : 2.0), at(place));
    }
    for (int i = 0; i < 20'000; ++i) physics.step(dt);
    return 9 * half - physics.state(14).position.y;
}

TEST(PhysicsStack, TwoHundredKilogramsOnBoxesOfTwo) {
    for (const double half : {0.1, 0.25}) {
        EXPECT_LT(sunk_stack(half, 200), 0.001) << half;
        EXPECT_LT(sunk_stack(half, 400), 0.001) << half;
    }
}

vec3 some_vector(Random& random, double size) {
    return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

/// Smallest distance of a segment from a box around the origin, by a search of 100 steps (m).
double searched_distance(vec3 centre, vec3 half_axis, vec3 box_half) {
    const auto distance = [&](double t) {
        const vec3 point = centre + t * half_axis;
        return glm::length(point - glm::clamp(point, -box_half, box_half));
    };
    double low = -1, high = 1;
    for (int i = 0; i < 100; ++i) {
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        const bool nearer = distance(a) <= distance(b);
        (nearer ? high : low) = nearer ? b : a;
    }
    return distance(0.5 * (low + high));
}

TEST(PhysicsCapsule, NearestPointsOfASegmentAndABox) {
    Random random{3};
    int crossing = 0;
    for (int i = 0; i < 5000; ++i) {
        const vec3 half = vec3(0.05) + glm::abs(some_vector(random, 1));
        vec3 centre = some_vector(random, 3), axis = some_vector(random, 2);
        if (i % 3 == 0) axis[i / 3 % 3] = 0;
        const auto [on_axis, on_box] = detail::nearest_points(centre, axis, half);
        const double distance = glm::length(on_axis - on_box);
        crossing += distance == 0;
        ASSERT_NEAR(distance, searched_distance(centre, axis, half), 1e-7) << i;
        ASSERT_LT(glm::length(glm::cross(on_axis - centre, axis)), 1e-8) << i;
    }
    EXPECT_GT(crossing, 100);
}

TEST(PhysicsCapsule, AlongAFaceItTouchesWithTheMiddle) {
    for (const double slant : {0.0, 1e-12, -1e-12}) {
        const auto [on_axis, on_box] = detail::nearest_points({1, 0.5, 0}, {slant, 1, 0}, {0.5, 1, 0.5});
        EXPECT_NEAR(on_axis.y, 0.25, 1e-12) << slant;  // middle of the part beside the face, y = -0.5 to 1
        EXPECT_NEAR(on_box.x, 0.5, 1e-12) << slant;
    }
    // At random heights, rounding may put an end of the part beside the face outside of the face.
    Random random{5};
    for (int i = 0; i < 5000; ++i) {
        const double y = some_vector(random, 1).y, tall = 0.05 + std::abs(some_vector(random, 1).y);
        const auto found = detail::nearest_points({1, y, 0}, {0, 0.6, 0}, {0.5, tall, 0.5});
        const double low = std::max(y - 0.6, -tall), high = std::min(y + 0.6, tall);
        const double middle = low < high ? 0.5 * (low + high) : y > 0 ? y - 0.6 : y + 0.6;
        ASSERT_NEAR(found.on_segment.y, middle, 1e-8) << y << " beside a box of half height " << tall;
    }
}

/// The contact of a capsule that falls onto a turned box, in the first step.
std::optional<Contact> capsule_contact(bool upright, bool capsule_first, double box_mass, vec3 place,
                                       const quat& turn) {
    Physics physics({.gravity = {}});
    BodyDesc capsule = wizard();
    capsule.upright = upright ? 1 : 0;
    BodyState stone = at({});
    stone.orientation = turn;
    physics.add(capsule_first ? 1 : 2, capsule, at(place, -10.0 * place));
    physics.add(capsule_first ? 2 : 1, box({0.5, 0.2, 0.4}, box_mass, 0), stone);
    physics.step(dt);
    if (physics.contacts().empty()) return {};
    return physics.contacts()[0];
}

/// A capsule that must stay upright touches a box at the same point as one that can rotate, whose contacts
/// come from Bullet's iteration.
TEST(PhysicsCapsule, UprightOnesTouchBoxesAsBulletsDo) {
    Random random{4};
    int compared = 0;
    for (int i = 0; i < 4000; ++i) {
        const vec3 axis = glm::normalize(some_vector(random, 1) + vec3(0, 0, 1e-3));
        const quat turn = glm::angleAxis(random.uniform(0, 3), axis);
        const vec3 place = some_vector(random, 1.2);
        const bool first = i % 2 == 0;
        const double mass = i % 4 < 2 ? 0 : 20;
        const auto ours = capsule_contact(true, first, mass, place, turn);
        const auto bullets = capsule_contact(false, first, mass, place, turn);
        ASSERT_EQ(ours.has_value(), bullets.has_value()) << i;
        if (!ours) continue;
        ASSERT_LT(glm::length(ours->normal - bullets->normal), 1e-6) << i;
        ASSERT_LT(glm::length(ours->point - bullets->point), 1e-6) << i;
        ++compared;
    }
    EXPECT_GT(compared, 300);
}

}  // namespace
}  // namespace thaum::physics
