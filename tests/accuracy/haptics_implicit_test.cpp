// Tests implicit surfaces, and the contact with a surface on which a field has a given value.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "field/analytic.h"
#include "haptics/volume/implicit.h"
#include "haptics/volume/level_contact.h"
#include "tests/scenes/scanned_volumes.h"

namespace thaum::haptics {
namespace {

using bench::TouchedModes;
using field::field_of;
using field::Scalar;
using field::ScalarField;

ModeUse wall_of(ScalarField potential, double strength) {
    ModeUse use{find_mode("isosurface"), any_field(potential), {}};
    use.settings.strength = field::constant(strength);
    use.settings.solid_below = true;
    use.settings.reach = 0.002;
    return use;
}

const Ball ball{.centre = {0.01, -0.02, 0}, .radius = 0.03};
const Bar bar{.from = {-0.02, 0, 0}, .to = {0.03, 0.01, 0}, .radius = 0.008};
const Block block{.centre = {0, 0.01, 0}, .half = {0.03, 0.02, 0.01}, .round = 0.004};
const Ring ring{.centre = {0, 0, 0.01}, .axis = {0, 0.6, 0.8}, .radius = 0.03, .thickness = 0.008};
const HalfSpace ground{.place = {0, -0.01, 0}, .normal = {0.6, 0.8, 0}};

/// Largest difference between a field's gradient and central differences of its value.
template <class Source>
double gradient_error(const Source& source, vec3 place) {
    constexpr double h = 1e-6;
    vec3 differences;
    for (int axis = 0; axis < 3; ++axis) {
        vec3 step(0);
        step[axis] = h;
        differences[axis] = (source(place + step).value - source(place - step).value) / (2 * h);
    }
    return glm::distance(differences, source(place).gradient);
}

std::vector<vec3> some_places() {
    Random random{3};
    std::vector<vec3> places(200);
    for (vec3& p : places)
        p = {random.uniform(-0.06, 0.06), random.uniform(-0.06, 0.06), random.uniform(-0.06, 0.06)};
    return places;
}

TEST(ImplicitSurfaces, GradientsAreThoseOfTheValuesAndShapesAreDistances) {
    for (const vec3 place : some_places()) {
        for (const ScalarField shape :
             {field_of<Scalar>(ball), field_of<Scalar>(bar), field_of<Scalar>(block), field_of<Scalar>(ring),
              field_of<Scalar>(ground)}) {
            const Scalar here = shape(place);
            EXPECT_NEAR(glm::length(here.gradient), 1, 1e-12);
            // Skips places inside, because a block's distance has creases there, and places near the surface.
            if (here.value < 0.001) continue;
            EXPECT_LE(gradient_error(shape, place), 1e-5);
            // A step against the gradient, whose length is the value, ends on the surface.
            EXPECT_NEAR(shape(place - here.value * here.gradient).value, 0, 1e-12);
        }
    }
}

TEST(ImplicitSurfaces, MergedObjectsMakeOneSmoothSurface) {
    const Ball left{{-0.02, 0, 0}, 0.022}, right{{0.02, 0, 0}, 0.022};
    const std::array parts{field_of<Scalar>(left), field_of<Scalar>(right)};
    const std::array swapped{parts[1], parts[0]};
    const Merged merged{parts, 0.002}, other{swapped, 0.002};
    for (const vec3 place : some_places()) {
        EXPECT_LE(gradient_error(merged, place), 1e-5);
        EXPECT_NEAR(merged(place).value, other(place).value, 1e-15);
        const double least = std::min(left(place).value, right(place).value);
        EXPECT_LE(merged(place).value, least + 1e-15);
        EXPECT_GE(merged(place).value, least - 0.002 * std::log(2.0) - 1e-15);
    }
    // In the waist between the balls, where their union has a crease, the merged surface is smooth.
    const vec3 waist = merged({0, 0.012, 0}).gradient;
    EXPECT_LE(glm::distance(waist / glm::length(waist), vec3(0, 1, 0)), 1e-12);
}

TEST(ImplicitSurfaces, FarObjectsDoNotOverflowAMerger) {
    const Ball far{{1e5, 0, 0}, 1};
    const std::array parts{field_of<Scalar>(far), field_of<Scalar>(ball)};
    const Merged merged{parts, 1e-4};
    const vec3 place = ball.centre + vec3(0.05, 0, 0);
    EXPECT_NEAR(merged(place).value, ball(place).value, 1e-12);
    EXPECT_LE(glm::distance(merged(place).gradient, ball(place).gradient), 1e-12);
}

TEST(ImplicitSurfaces, ATextureIsOnThePotential) {
    const Texture grating{TextureKind::vibration, 0.0002, 0.004, {}, {vec3{1, 0, 0}, vec3{0, 0, 1}}};
    const ScalarField plain = field_of<Scalar>(ball);
    const Decorated decorated{plain, grating, nullptr};
    for (const vec3 place : some_places()) EXPECT_LE(gradient_error(decorated, place), 1e-4);
    // At a crest the textured surface is higher than the one without texture by twice the amplitude.
    const vec3 crest(0.001, 0.02, 0);
    EXPECT_NEAR(decorated(crest).value, ball(crest).value - 0.0004, 1e-15);
}

TEST(LevelContact, TheForcePointsAlongTheNormalOfASphereToRounding) {
    for (int i = 0; i < 100; ++i) {
        const vec3 out = bench::even_direction(i, 100);
        TouchedModes hand{{wall_of(field_of<Scalar>(ball), 20)}};
        hand.start(ball.centre + 0.031 * out);
        vec3 force(0);
        for (int tick = 0; tick <= 60; ++tick)
            force = hand.move(ball.centre + std::max(0.027, 0.031 - 1e-4 * tick) * out);
        EXPECT_LE(glm::distance(force, 300 * 0.003 * out), 1e-9);
    }
}

TEST(LevelContact, ATipDoesNotFallThroughWhatItCrossesInOneTick) {
    const Block sheet{.half = {0.05, 0.0005, 0.05}};  // a sheet 1 mm thick
    const Thickened thick{field_of<Scalar>(sheet), 0.0002};
    TouchedModes hand{{wall_of(field_of<Scalar>(thick), 20)}};
    hand.start({0, 0.01, 0});
    vec3 force(0);
    // The hand moves at 1 m/s.
    for (int tick = 0; tick <= 12; ++tick) force = hand.move({0, 0.01 - 0.001 * tick, 0});
    EXPECT_LE(glm::distance(force, vec3(0, 300 * (0.002 + 0.0007), 0)), 1e-9);
}

TEST(LevelContact, AFlatFieldBeforeTheSurfaceNeedsNoGradient) {
    // The density is 0 outside and 1 inside, with an edge 1 mm wide.
    const auto step = [](vec3 p) {
        const double t = std::clamp(-p.y / 0.001, 0.0, 1.0);
        return Scalar{t, {0, t > 0 && t < 1 ? -1000 : 0, 0}};
    };
    ModeUse use{find_mode("isosurface"), any_field(field_of<Scalar>(step)), {}};
    use.settings.strength = field::constant(20);
    use.settings.level = 0.5;
    use.settings.reach = 0.0012;
    TouchedModes hand{{use}};
    hand.start({0, 0.01, 0});
    for (int tick = 0; tick <= 40; ++tick) hand.move({0, 0.01 - 0.0003 * tick, 0});
    EXPECT_NEAR(hand.proxy.y, -0.0005, 1e-12);
}

TEST(LevelContact, AGrooveAndACornerHoldTheProxyStill) {
    // The block is hollow: everything outside of it is solid, so three walls meet in its corner.
    const Block inner{.half = vec3(0.02)};
    const auto hollow = [&](vec3 p) {
        const Scalar s = inner(p);
        return Scalar{-s.value, -s.gradient};
    };
    TouchedModes hand{{wall_of(field_of<Scalar>(hollow), 20)}};
    for (const vec3 goal : {vec3(0.023, 0.023, 0.001), vec3(0.022, 0.023, 0.024)}) {
        hand.start(vec3(0));
        vec3 last(0);
        double change = 0;
        for (int tick = 0; tick <= 400; ++tick) {
            const vec3 force = hand.move(std::min(1.0, tick / 200.0) * goal);
            if (tick > 250) change = std::max(change, glm::distance(force, last));
            last = force;
        }
        EXPECT_LE(change, 1e-3);  // largest change of the force (N); the force itself is 1.3 or 1.6 N
        EXPECT_LE(glm::distance(hand.proxy, glm::min(goal, vec3(0.02))), 1e-5);
    }
}

TEST(LevelContact, AHollowHoldsAHandThatSlidesUpToTheStatedForceWithItsFriction) {
    constexpr double radius = 0.03, strength = 1;
    const auto hollow = [](vec3 p) { return Scalar{radius - glm::length(p), -glm::normalize(p)}; };
    for (const vec3 across : {vec3(0, 0, 1), glm::normalize(vec3(1, 1, 1))}) {
        const vec3 first = perpendicular_to(across), second = glm::cross(across, first);
        for (const double mu : {0.0, 0.3}) {
            auto use = wall_of(field_of<Scalar>(hollow), strength);
            use.settings.friction = field::constant(mu);
            TouchedModes hand{{use}};
            hand.start(0.025 * first);
            double largest = 0, least = HUGE_VAL, most = 0;
            int held = 0;
            for (int tick = 0; tick <= 3000; ++tick) {
                // The tip slides at 0.06 m/s.
                const double turn = 0.002 * tick, deep = radius + 0.0000015 * tick;
                const vec3 out = std::cos(turn) * first + std::sin(turn) * second;
                const vec3 force = hand.move((tick == 0 ? 0.028 : deep) * out);
                largest = std::max(largest, glm::length(force));
                const vec3 normal = glm::normalize(hand.proxy);
                const double pressed = -glm::dot(force, normal);
                if (tick < 1500 || pressed < 0.3) continue;
                const double share = glm::length(force + pressed * normal) / pressed;
                least = std::min(least, share);
                most = std::max(most, share);
                ++held;
            }
            EXPECT_LE(largest, std::hypot(1, mu) * strength * 1.001) << "mu " << mu;
            EXPECT_GT(held, 500);
            EXPECT_GE(least, 0.93 * mu);
            EXPECT_LE(most, 1.07 * mu + 0.01);
        }
    }
}

TEST(LevelContact, ASurfaceThatCurvesEverywhereNeverHoldsMoreThanItsStrength) {
    const field::Gyroid gyroid{.period = 0.03};
    Random random{8};
    auto use = wall_of(field_of<Scalar>(gyroid), 1);
    TouchedModes hand{{use}};
    hand.start(vec3(0.0075, 0, 0));
    vec3 at(0.0075, 0, 0), goal = at;
    double largest = 0;
    for (int tick = 0; tick < 20'000; ++tick) {
        if (tick % 400 == 0)
            goal = {random.uniform(-0.04, 0.04), random.uniform(-0.04, 0.04), random.uniform(-0.04, 0.04)};
        const vec3 way = goal - at;
        // The tip moves at 0.1 m/s or less.
        at += std::min(1.0, 1e-4 / std::max(glm::length(way), 1e-9)) * way;
        largest = std::max(largest, glm::length(hand.move(at)));
    }
    EXPECT_GE(largest, 0.9);
    EXPECT_LE(largest, 1.05);
}

TEST(LevelContact, AStrongPushPokesThroughAtTheStatedForce) {
    for (const double strength : {0.5, 1.0, 2.0}) {
        TouchedModes hand{{wall_of(field_of<Scalar>(ground), strength)}};
        hand.start(ground.place + 0.002 * ground.normal);
        double largest = 0, at_end = 0;
        for (int tick = 0; tick <= 2000; ++tick) {
            at_end = glm::length(hand.move(ground.place + (0.002 - 1e-5 * tick) * ground.normal));
            largest = std::max(largest, at_end);
        }
        EXPECT_NEAR(largest, strength, 1e-9);
        EXPECT_LE(at_end, 1e-12) << "inside, the tip is free";
    }
}

TEST(LevelContact, FrictionGrowsWithDepth) {
    auto use = wall_of(field_of<Scalar>(ground), 20);
    use.settings.friction = field::window(0, 0.01, 0, 0.5);
    const vec3 along = perpendicular_to(ground.normal);
    for (const double depth : {0.001, 0.002, 0.004}) {
        TouchedModes hand{{use}};
        hand.start(ground.place + 0.001 * ground.normal);
        for (int tick = 0; tick <= 100; ++tick)
            hand.move(ground.place + std::max(-depth, 0.001 - 1e-4 * tick) * ground.normal);
        vec3 force(0);
        for (int tick = 0; tick < 300; ++tick)
            force = hand.move(ground.place - depth * ground.normal + 1e-4 * tick * along);
        EXPECT_NEAR(glm::dot(force, ground.normal), 300 * depth, 1e-9);
        EXPECT_NEAR(-glm::dot(force, along), depth / 0.01 * 0.5 * 300 * depth, 1e-6);
    }
}

TEST(LevelContact, AMagneticSurfaceHoldsATipThatLeavesUpToItsStrength) {
    auto use = wall_of(field_of<Scalar>(ground), 20);
    use.settings.magnet = 0.4;
    TouchedModes hand{{use}};
    hand.start(ground.place + 0.0001 * ground.normal);
    double largest = 0;
    vec3 force(0);
    for (int tick = 0; tick < 1000; ++tick) {
        force = hand.move(ground.place + 1e-5 * tick * ground.normal);
        largest = std::max(largest, -glm::dot(force, ground.normal));
    }
    EXPECT_NEAR(largest, 0.4, 1e-9);
    EXPECT_LE(glm::length(force), 1e-12) << "beyond its reach it lets go";
}

TEST(LevelContact, AMagneticSurfaceTakesHoldAndLetsGoOverATenthOfAMillimetre) {
    constexpr double step = 1e-6;  // motion of the tip (m per tick)
    // The last magnet (3 N) pulls more strongly than the spring where the magnet's reach ends.
    for (const double magnet : {0.1, 0.4, 3.0}) {
        auto use = wall_of(field_of<Scalar>(ball), 20);
        use.settings.magnet = magnet;
        TouchedModes hand{{use}};
        const vec3 out = glm::normalize(vec3(1, 2, 2)), surface = ball.centre + ball.radius * out;
        const auto place = [&](int tick) { return surface + (0.0025 - std::abs(step * tick)) * out; };
        hand.start(place(-2500));
        vec3 before(0);
        double steepest = 0, largest = 0;
        for (int tick = -2500; tick <= 2600; ++tick) {
            const vec3 force = hand.move(place(tick));
            steepest = std::max(steepest, glm::distance(force, before));
            largest = std::max(largest, -glm::dot(force, out));
            before = force;
        }
        EXPECT_NEAR(largest, std::min(magnet, 300 * use.settings.reach), 0.05 * largest) << magnet;
        EXPECT_LE(steepest, magnet * step / 1e-4 + 300 * 3 * step) << magnet;
    }
}

TEST(LevelContact, AFieldWithoutSurfaceOrNumbersIsFree) {
    const auto nothing = [](vec3) { return Scalar{std::numeric_limits<double>::quiet_NaN(), vec3(1)}; };
    const auto flat = [](vec3) { return Scalar{-1, vec3(0)}; };
    for (const ScalarField f : {field_of<Scalar>(nothing), field_of<Scalar>(flat)}) {
        EXPECT_EQ(find_contact({f, 0, false, 0.001}, vec3(0), {0, 0, 0.01}).count, 0U);
        EXPECT_EQ(find_contact({f, 0, false, 0.001}, vec3(std::nan("")), vec3(0)).count, 0U);
    }
}

}  // namespace
}  // namespace thaum::haptics
