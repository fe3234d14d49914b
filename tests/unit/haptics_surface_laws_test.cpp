// Tests of laws that surfaces must obey at any speed and for any input: energy, symmetry, closed meshes that
// no tip can leave or enter, finite results and equal bits.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "accuracy/primitives_judge.h"
#include "core/hash.h"
#include "unit/allocations.h"
#include "unit/haptics_surface_rig.h"

namespace thaum::haptics::surface_tests {
namespace {

// ---- laws that forces of surfaces obey --------------------------------------------------------------------

/// Work along a closed slow path, by the trapezoid rule (J).
double work_round(Probe& probe, vec3 centre, vec3 u, vec3 v, int ticks) {
    vec3 tip = centre + u;
    vec3 force = probe.at(tip).force;
    double work = 0;
    for (int tick = 1; tick <= ticks; ++tick) {
        const double angle = 2 * pi * tick / ticks;
        const vec3 next = centre + det::cos(angle) * u + det::sin(angle) * v;
        const vec3 there = probe.at(next).force;
        work += glm::dot(0.5 * (force + there), next - tip);
        tip = next;
        force = there;
    }
    return work;
}

TEST(Surface, AClosedPathWithoutFrictionDoesNoWork) {
    const double s = std::sqrt(0.5);
    for (int scene = 0; scene < 3; ++scene) {
        Probe probe;
        if (scene == 0) add(probe.patch, SurfaceKind::plane, {}, {0, 1, 0});
        if (scene == 1) {
            add(probe.patch, SurfaceKind::plane, {}, {s, s, 0});
            add(probe.patch, SurfaceKind::plane, {}, {-0.6, 0.8, 0});
            add(probe.patch, SurfaceKind::plane, {}, {0, 0.6, 0.8});
        }
        if (scene == 2) add(probe.patch, SurfaceKind::sphere, {0, -0.05, 0}, {0.05, 0, 0});
        for (const int ticks : {1000, 4000, 64'000}) {
            probe.state = {};
            probe.at({0.01, 0.02, 0});
            const double work =
                work_round(probe, {0, -0.002, 0}, {0.008, 0.003, 0}, {0, -0.005, 0.007}, ticks);
            // The trapezoid rule is of second order where the force has a kink.
            const double step = 2 * pi * 0.009 / ticks;
            EXPECT_LT(std::abs(work), 0.5 * stiffness * step * step) << scene << " at " << ticks;
        }
    }
}

TEST(Surface, FrictionOnlyTakesEnergy) {
    Probe probe{floor_patch(rough)};
    probe.at({0.01, 0.02, 0});
    double work = work_round(probe, {0, -0.002, 0}, {0.008, 0.003, 0}, {0, -0.005, 0.007}, 2000);
    EXPECT_LT(work, -1e-6);
}

/// If everything is rotated or reflected, so is the result. The order of surfaces in the patch does not
/// matter.
TEST(Surface, TurnedAndMirroredItFeelsTheSame) {
    Random random{5};
    for (int n = 0; n < 100; ++n) {
        const mat3 turn = glm::mat3_cast(rotation(random_unit(random), random.uniform(-3, 3)));
        mat3 mirror(1.0);
        mirror[0][0] = -1;
        const mat3 map = n % 2 == 0 ? turn : turn * mirror;
        Probe one, other;
        add_body(one.patch, rough);
        for (int i = 0; i < 12; ++i) {
            const vec3 a = random_vec(random, 0.02), b = random_vec(random, 0.02),
                       c = random_vec(random, 0.02);
            add(one.patch, SurfaceKind::sheet, a, b, c);
        }
        one.patch.bodies[0].velocity = random_vec(random, 0.05);
        other.patch = one.patch;
        const auto move_other = [&] {
            for (std::uint32_t i = 0; i < one.patch.count; ++i) {
                const Surface& s = one.patch.surfaces[one.patch.count - 1 - i];
                other.patch.surfaces[i] = {s.kind, s.body, s.part, 0, map * s.a, map * s.b, map * s.c};
            }
            other.patch.bodies[0].velocity = map * one.patch.bodies[0].velocity;
            other.patch.bodies[0].position = map * one.patch.bodies[0].position;
        };
        vec3 tip = random_vec(random, 0.02), way = random_vec(random, 0.1);
        for (int tick = 0; tick < 200; ++tick, one.advance()) {
            move_other();
            if (tick % 50 == 0) way = random_vec(random, 0.2);
            tip += dt * way;
            const vec3 here = one.at(tip).force, there = other.at(map * tip).force;
            expect_near(map * here, there, 1e-7 * (1 + glm::length(here)),
                        std::to_string(n) + " " + std::to_string(tick));
        }
    }
}

// ---- what no tip and no input may cause -------------------------------------------------------------------

bool inside(vec3 p, vec3 half) {
    return std::abs(p.x) < half.x && std::abs(p.y) < half.y && std::abs(p.z) < half.z;
}

TEST(Surface, NoSpeedTakesTheProxyThroughAClosedMesh) {
    const vec3 half(0.02, 0.0003, 0.03);
    for (const SurfaceKind kind : {SurfaceKind::triangle, SurfaceKind::sheet, SurfaceKind::box}) {
        for (const double friction : {0.0, 0.5}) {
            Probe probe;
            add_body(probe.patch,
                     {.stiffness = stiffness, .static_friction = friction, .dynamic_friction = friction});
            if (kind == SurfaceKind::box)
                add(probe.patch, kind, {}, half);
            else
                add_box_mesh(probe.patch, half, kind);
            Random random{6};
            probe.at({0, 0.05, 0});
            vec3 tip(0, 0.05, 0);
            for (int n = 0; n < 100'000; ++n) {
                const double size = std::pow(10.0, random.uniform(-6, 1));
                // Every third tip is around the middle of an edge or around a corner, where a gap between
                // triangles would show.
                const vec3 spot = n % 3 == 0 ? half * vec3(1, 1, n % 2 == 0 ? 1 : 0) : vec3(0);
                tip = n % 5 == 0 ? tip + random_vec(random, 1e-3) : spot + random_vec(random, size);
                probe.at(tip);
                ASSERT_FALSE(inside(probe.state.proxy, half)) << n;
            }
        }
    }
}

TEST(Surface, FromTheInsideOfATwoSidedBoxThereIsNoWayOut) {
    const vec3 half(0.02, 0.02, 0.02);
    Probe probe;
    add_box_mesh(probe.patch, half, SurfaceKind::sheet);
    Random random{7};
    probe.at({});
    for (int n = 0; n < 100'000; ++n) {
        const double size = std::pow(10.0, random.uniform(-3, 1));
        const vec3 tip = random_vec(random, size);
        const ContactResult t = probe.at(tip);
        ASSERT_TRUE(inside(probe.state.proxy, half)) << n;
        // The proxy is also at the nearest place, because the box is convex.
        expect_near(t.proxy, glm::clamp(tip, -half, half), 1e-8);
    }
}

TEST(Surface, BeyondThePatchNothingIsGuessed) {
    Probe probe;
    add(probe.patch, SurfaceKind::plane, {}, {0, 1, 0});
    probe.patch.centre = {0, 0.001, 0};
    probe.patch.reach = 0.005;
    probe.at({0, 0.001, 0});
    EXPECT_EQ(probe.at({0.1, 0.001, 0}).force, vec3(0)) << "free";
    EXPECT_EQ(probe.state.limited, 1U);
    expect_near(probe.state.proxy, {0.005, 0.001, 0}, 1e-12);
    probe.patch.centre = probe.state.proxy;
    probe.patch.reach = 0.2;
    probe.at({0.1, 0.001, 0});
    expect_near(probe.state.proxy, {0.1, 0.001, 0}, 1e-12);
    EXPECT_EQ(probe.state.limited, 0U);
}

/// Coordinates from zero to infinity, and NaN.
constexpr std::array<double, 10> hard_values{0,
                                             -0.0,
                                             1e-300,
                                             1e300,
                                             -1e300,
                                             std::numeric_limits<double>::infinity(),
                                             1e-12,
                                             1e-8,
                                             -std::numeric_limits<double>::infinity(),
                                             std::numeric_limits<double>::quiet_NaN()};

double value_or_hard_one(Random& random) {
    return random.below(4) == 0 ? hard_values[random.below(hard_values.size())] : random.uniform(-0.02, 0.02);
}

vec3 place_or_hard_one(Random& random) {
    return {value_or_hard_one(random), value_or_hard_one(random), value_or_hard_one(random)};
}

Surface hostile_surface(Random& random) {
    return {.kind = static_cast<SurfaceKind>(random.below(8)),
            .body = static_cast<std::uint32_t>(random.below(10)),
            .part = static_cast<std::uint32_t>(random.below(4)),
            .a = place_or_hard_one(random),
            .b = place_or_hard_one(random),
            .c = place_or_hard_one(random)};
}

SurfaceBody hostile_body(Random& random) {
    const auto value = [&random] { return value_or_hard_one(random); };
    const auto place = [&random] { return place_or_hard_one(random); };
    SurfaceBody body;
    body.position = place();
    body.orientation = {value(), value(), value(), value()};
    body.velocity = place();
    body.spin = place();
    body.material = {value(), value(), value(), value()};
    body.material.texture = {
        static_cast<TextureKind>(random.below(5)), value(), value(), place(), {place(), place()}};
    body.key = static_cast<std::uint32_t>(random.below(3));
    return body;
}

/// A patch whose counts, kinds and numbers may all be invalid.
SurfacePatch hostile_surfaces(Random& random) {
    SurfacePatch patch;
    patch.count = static_cast<std::uint32_t>(random.below(40));
    patch.body_count = static_cast<std::uint32_t>(random.below(10));
    for (Surface& s : patch.surfaces) s = hostile_surface(random);
    for (SurfaceBody& body : patch.bodies) body = hostile_body(random);
    patch.centre = place_or_hard_one(random);
    if (random.below(2) == 0) patch.reach = value_or_hard_one(random);
    return patch;
}

TEST(Surface, HostileInputNeverLeavesANumberThatIsNone) {
    Random random{8};
    for (int n = 0; n < 20'000; ++n) {
        Probe probe{hostile_surfaces(random)};
        for (int tick = 0; tick < 5; ++tick) {
            const vec3 tip = place_or_hard_one(random);
            const ContactResult t = probe.at(tip, place_or_hard_one(random));
            ASSERT_TRUE(is_finite(t.force)) << n;
            ASSERT_TRUE(probe.state.begun == 0 || is_finite(probe.state.proxy)) << n;
            ASSERT_LE(t.contacts, 3U);
        }
    }
}

TEST(Surface, APositionThatIsNoNumberIsForgotten) {
    Probe probe{floor_patch()};
    probe.at({0, 0.01, 0});
    EXPECT_EQ(probe.at({std::numeric_limits<double>::quiet_NaN(), 0, 0}).force, vec3(0));
    probe.at({0, 0.01, 0});
    expect_near(probe.at({0, -0.002, 0}).force, {0, stiffness * 0.002, 0}, gap_force + rounding,
                "it goes on");
}

TEST(Surface, ATickAllocatesNothingAndRepeatsToTheBit) {
    const auto run = [] {
        Probe probe;
        add_body(probe.patch, rough);
        add_box_mesh(probe.patch, {0.02, 0.01, 0.03}, SurfaceKind::triangle);
        Random random{9};
        std::uint64_t hash = 0;
        for (int n = 0; n < 1000; ++n) {
            const vec3 force = probe.at(random_vec(random, 0.04)).force;
            hash = hash_bytes(std::as_bytes(std::span(&force, 1)), hash);
            hash = hash_bytes(std::as_bytes(std::span(&probe.state, 1)), hash);
        }
        return hash;
    };
    const auto first = run();
    const auto before = test::allocations();
    EXPECT_EQ(run(), first);
    EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace thaum::haptics::surface_tests
