// Unit tests of surfaces against closed forms: springs to planes, creases and corners, Coulomb's law and
// moving bodies.
#include "haptics/surface/surface.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "unit/haptics_surface_rig.h"

namespace thaum::haptics::surface_tests {
namespace {

// ---- position of the proxy on surfaces --------------------------------------------------------------------

TEST(Surface, APlaneIsASpringAlongItsNormal) {
    Random random{1};
    for (int n = 0; n < 1000; ++n) {
        const vec3 normal = random_unit(random), point = random_vec(random, 0.2);
        Probe probe;
        add(probe.patch, SurfaceKind::plane, point, normal);
        const double depth = random.uniform(0, 0.02);
        const vec3 along = random_vec(random, 0.1);
        const vec3 over = point + along - normal * glm::dot(normal, along);
        EXPECT_EQ(probe.at(over + 0.01 * normal).force, vec3(0));
        const ContactResult in = probe.at(over - depth * normal);
        expect_near(in.force, stiffness * depth * normal, gap_force + rounding);
        expect_near(in.proxy, over, 2 * surface_gap);
        EXPECT_EQ(in.contacts, 1U);
        const ContactResult out = probe.at(over + 0.001 * normal);
        EXPECT_EQ(out.force, vec3(0));
        EXPECT_EQ(out.proxy, over + 0.001 * normal);
    }
}

/// The expected proxy is the foot of the perpendicular from the tip to the intersection line of two planes
/// through the origin.
TEST(Surface, InACreaseAndACornerItIsAsNearAsBothAllow) {
    Random random{2};
    int creases = 0, corners = 0;
    for (int n = 0; n < 2000; ++n) {
        Probe probe;
        std::array<vec3, 3> normals{};
        for (vec3& normal : normals) {
            normal = random_unit(random);
            add(probe.patch, SurfaceKind::plane, {}, normal);
        }
        if (std::abs(glm::dot(normals[0], glm::cross(normals[1], normals[2]))) < 0.05) continue;
        // The corner is the nearest place if the tip is in the cone that the negative normals span; likewise
        // for each crease.
        const vec3 depths(random.uniform(0, 0.01), random.uniform(0, 0.01), random.uniform(0, 0.01));
        const bool corner = n % 2 == 0;
        const vec3 tip =
            -depths.x * normals[0] - depths.y * normals[1] - (corner ? depths.z : 0) * normals[2];
        vec3 nearest(0);
        if (!corner) {
            // The direction along the crease that leads to the free side of the third plane.
            vec3 crease = glm::normalize(glm::cross(normals[0], normals[1]));
            if (glm::dot(crease, normals[2]) < 0) crease = -crease;
            nearest = 0.1 * crease;
        }
        probe.at(nearest + 0.01 * (normals[0] + normals[1] + normals[2]));
        vec3 start(0);
        for (const vec3& normal : normals) start += normal;
        bool free = true;
        for (const vec3& normal : normals) free = free && glm::dot(start, normal) > 0.1;
        if (!free) continue;
        (corner ? corners : creases)++;
        probe.state = {.proxy = nearest + 0.02 * start, .begun = 1};
        const ContactResult in = probe.at(nearest + tip);
        expect_near(in.proxy, nearest, 40 * surface_gap, std::to_string(n));
        expect_near(in.force, -stiffness * tip, 40 * gap_force);
        EXPECT_EQ(in.contacts, corner ? 3U : 2U);
    }
    EXPECT_GT(creases, 200);
    EXPECT_GT(corners, 200);
}

TEST(Surface, RoundOnesPushFromTheirCore) {
    Random random{3};
    for (int n = 0; n < 500; ++n) {
        const quat turn = rotation(random_unit(random), random.uniform(-3, 3));
        const vec3 centre = random_vec(random, 0.1);
        const double radius = 0.03, half = 0.04, depth = random.uniform(0.0005, 0.015);
        const double up = random.uniform(-0.95 * half, 0.95 * half), round = random.uniform(-3, 3);
        const vec3 out(det::cos(round), 0, det::sin(round));
        struct Case {
            SurfaceKind kind;
            vec3 size, core, normal;
        };
        for (const Case& c : {Case{SurfaceKind::sphere, {radius, 0, 0}, {}, random_unit(random)},
                              Case{SurfaceKind::capsule, {radius, half, 0}, {0, up, 0}, out},
                              Case{SurfaceKind::cylinder, {radius, half, 0}, {0, up, 0}, out},
                              Case{SurfaceKind::box, {radius, half, 0.05}, {0, up, 0.01}, {-1, 0, 0}},
                              Case{SurfaceKind::cylinder, {2, radius, 0}, {0.01, 0, 0.02}, {0, 1, 0}}}) {
            Probe probe;
            add(probe.patch, c.kind, centre, c.size);
            probe.patch.bodies[0].orientation = turn;
            const auto at = [&](double height) {
                return centre + turn * (c.core + (radius + height) * c.normal);
            };
            EXPECT_EQ(probe.at(at(0.01)).force, vec3(0));
            const ContactResult in = probe.at(at(-depth));
            expect_near(in.force, stiffness * depth * (turn * c.normal), gap_force + rounding);
            EXPECT_EQ(in.contacts, 1U);
        }
    }
}

TEST(Surface, RoundASphereItKeepsUpWithTheTip) {
    Probe probe;
    add(probe.patch, SurfaceKind::sphere, {}, {0.05, 0, 0});
    probe.at({0, 0.06, 0});
    for (int tick = 0; tick < 2000; ++tick) {
        const double angle = 0.002 * tick;  // the tip moves at 0.1 m/s on the surface
        const vec3 out(det::sin(angle), det::cos(angle), 0);
        expect_near(probe.at(0.045 * out).force, stiffness * 0.005 * out, 1e-6);
    }
}

/// A convex body has no crease: beyond the middle of an edge, the nearest place is on the other face.
TEST(Surface, ItSlidesRoundAConvexEdge) {
    for (const bool mesh : {false, true}) {
        Probe probe;
        const vec3 half(0.05, 0.02, 0.05);
        if (mesh)
            add_box_mesh(probe.patch, half, SurfaceKind::triangle);
        else
            add(probe.patch, SurfaceKind::box, {}, half);
        probe.at({0.03, 0.03, 0.001});
        for (int step = 0; step <= 40; ++step) {
            const double x = 0.03 + 0.0005 * step;  // the tip moves, at 5 mm below the top, towards the side
            const vec3 force = probe.at({x, 0.015, 0.001}).force;
            // The proxy stays on the top face until the tip is nearer to the side face.
            if (step < 40)
                expect_near(force, {0, stiffness * 0.005, 0}, gap_force + rounding, std::to_string(step));
        }
        EXPECT_EQ(probe.at({0.051, 0.015, 0.001}).force, vec3(0)) << "off the edge";
        const vec3 side = probe.at({0.049, 0.015, 0.001}).force;
        expect_near(side, {stiffness * 0.001, 0, 0}, gap_force + rounding, "in from the side");
    }
}

TEST(Surface, AFlatMeshFeelsLikeAPlane) {
    Probe plane, mesh;
    add(plane.patch, SurfaceKind::plane, {}, {0, 1, 0});
    for (int i = 0; i < 4; ++i) {
        for (int k = 0; k < 4; ++k) {
            const vec3 corner(0.01 * i, 0, 0.01 * k), x(0.01, 0, 0), z(0, 0, 0.01);
            add(mesh.patch, SurfaceKind::triangle, corner, corner + z, corner + x);
            add(mesh.patch, SurfaceKind::sheet, corner + x, corner + z, corner + x + z);
        }
    }
    ASSERT_EQ(mesh.patch.count, surface_capacity);
    plane.at({0.001, 0.001, 0.001});
    mesh.at({0.001, 0.001, 0.001});
    vec3 before = plane.at({0.001, -0.005, 0.001}).force;
    for (int tick = 0; tick < 1000; ++tick) {
        // the tip moves at 0.1 m/s back and forth over the edges, along them and through the corners
        const double t = std::abs(2.0 * tick / 1000 - 1);
        const vec3 tip(0.038 * t + 0.001, -0.005, tick % 2 == 0 ? 0.038 * t * t + 0.001 : 0.01);
        const vec3 here = mesh.at(tip).force;
        expect_near(here, plane.at(tip).force, rounding);
        EXPECT_LE(glm::length(here - before), 1e-9) << "chatter";
        before = here;
    }
}

// ---- friction of surfaces ---------------------------------------------------------------------------------

TEST(Surface, ItSticksUpToTheStaticConeAndSlidesAtTheDynamicOne) {
    for (const double depth : {0.0005, 0.005}) {
        Probe probe{floor_patch(rough)};
        probe.at({0, 0.001, 0});
        probe.at({0, -depth, 0});
        const double normal_force = stiffness * depth;
        for (int i = 0; i < 60; ++i) {  // the pull tilts up to the friction's angle (tangent 0.6)
            const double x = depth * 0.01 * i;
            expect_near(probe.at({x, -depth, 0}).force, {-stiffness * x, normal_force, 0},
                        gap_force + rounding);
            EXPECT_EQ(probe.state.sliding, 0U);
        }
        for (int i = 61; i < 200; ++i) {
            const vec3 force = probe.at({depth * 0.01 * i, -depth, 0}).force;
            expect_near(force, {-0.4 * normal_force, normal_force, 0}, gap_force + rounding, "slides");
            EXPECT_EQ(probe.state.sliding, 1U);
        }
        // The proxy stops and sticks there, and static friction applies again.
        probe.at({depth * 1.99, -depth, 0});
        EXPECT_EQ(probe.state.sliding, 0U);
        const vec3 more = probe.at({depth * (1.99 + 0.19), -depth, 0}).force;
        expect_near(more, {-0.59 * normal_force, normal_force, 0}, gap_force + rounding, "sticks again");
        const vec3 off = probe.at({depth * (1.99 + 0.21), -depth, 0}).force;
        expect_near(off, {-0.4 * normal_force, normal_force, 0}, gap_force + rounding, "slides again");
    }
}

TEST(Surface, SlidingFrictionIsAgainstTheMotionWhateverItsDirection) {
    Random random{4};
    for (int n = 0; n < 200; ++n) {
        Probe probe{floor_patch(rough)};
        const double angle = random.uniform(-3, 3), depth = random.uniform(0.0005, 0.01);
        const vec3 way(det::cos(angle), 0, det::sin(angle));
        probe.at({0, 0.001, 0});
        probe.at({0, -depth, 0});
        ContactResult last;
        for (int i = 1; i <= 100; ++i) last = probe.at(0.0005 * i * way - vec3(0, depth, 0));
        expect_near(last.force, stiffness * depth * (vec3(0, 1, 0) - 0.4 * way), gap_force + rounding);
    }
}

TEST(Surface, ACreaseRubsOnBothSides) {
    SurfacePatch patch;
    add_body(patch, rough);
    const double s = std::sqrt(0.5);
    add(patch, SurfaceKind::plane, {}, {s, s, 0});
    add(patch, SurfaceKind::plane, {}, {-s, s, 0});
    Probe probe{patch};
    probe.at({0, 0.01, 0});
    const double depth = 0.005;
    ContactResult last;
    for (int i = 0; i <= 100; ++i) last = probe.at({0, -depth, 0.0005 * i});
    // The tip is s * depth deep in each of the two walls. Both exert friction with the coefficient 0.4, which
    // is 2 * 0.4 * s * depth * stiffness in total.
    expect_near(last.force, stiffness * depth * vec3(0, 1, -2 * s * 0.4), 4 * gap_force + rounding);
    EXPECT_EQ(last.contacts, 2U);
}

TEST(Surface, WhatIsTouchedHasItsShareOfTheForce) {
    SurfacePatch patch;
    add_body(patch, rough);
    add(patch, SurfaceKind::plane, {}, {0, 1, 0});
    add_body(patch);
    add(patch, SurfaceKind::plane, {}, {-1, 0, 0});
    Probe probe{patch};
    probe.at({-0.01, 0.01, 0});
    ContactResult last;
    for (int i = 0; i <= 100; ++i) last = probe.at({0.004, -0.007, 0.0005 * i});
    ASSERT_EQ(probe.state.contacts, 2U);
    const auto& floor = probe.state.touched[0];
    const auto& wall = probe.state.touched[1];
    EXPECT_EQ(floor.key, 100U);
    EXPECT_EQ(wall.key, 101U);
    expect_near(floor.force + wall.force, last.force, rounding, "nothing is lost");
    EXPECT_NEAR(floor.force.y, stiffness * 0.007, gap_force + rounding);
    EXPECT_NEAR(wall.force.x, -stiffness * 0.004, gap_force + rounding);
    EXPECT_EQ(floor.force.x, 0);
    EXPECT_EQ(wall.force.y, 0);
}

// ---- surfaces of moving bodies ----------------------------------------------------------------------------

TEST(Surface, AWallThatMovesIsFeltInEveryTickItOverlaps) {
    for (const bool mesh : {false, true}) {
        Probe probe;
        const vec3 half(0.02, 0.01, 0.02);
        if (mesh)
            add_box_mesh(probe.patch, half, SurfaceKind::triangle);
        else
            add(probe.patch, SurfaceKind::box, {}, half);
        for (std::uint32_t i = 0; i < probe.patch.count; ++i) {
            Surface& s = probe.patch.surfaces[i];
            s.a.y -= 0.0195;
            if (mesh) s.b.y -= 0.0195, s.c.y -= 0.0195;
        }
        probe.patch.bodies[0].velocity = {0, 0.1, 0};
        const vec3 still(0.003, 0, -0.002);
        int overlapping = 0;
        for (int tick = 0; tick < 286; ++tick, probe.advance()) {
            const double top = -0.0095 + 1e-4 * tick;
            const vec3 force = probe.at(still).force;
            if (top <= 1e-9) {
                EXPECT_LE(glm::length(force), gap_force) << tick;
                continue;
            }
            ++overlapping;
            expect_near(force, {0, stiffness * top, 0}, gap_force + rounding, std::to_string(tick));
        }
        EXPECT_EQ(overlapping, 190);
    }
}

/// A box that moves and turns, with points fixed to it.
TEST(Surface, APatchThatGoesOnIsWhereItsBodiesAre) {
    Random random{5};
    for (int n = 0; n < 100; ++n) {
        SurfacePatch patch;
        const vec3 half(0.02, 0.01, 0.03);
        add_box_mesh(patch, half, SurfaceKind::triangle);
        add(patch, SurfaceKind::plane, random_vec(random, 0.1), random_unit(random));
        add(patch, SurfaceKind::sphere, random_vec(random, 0.1), {0.01, 0, 0});
        SurfaceBody& body = patch.bodies[0];
        body.position = random_vec(random, 0.1);
        body.velocity = random_vec(random, 2);
        if (n % 4 != 0) body.spin = random_vec(random, 20);
        const double seconds = random.uniform(0, 0.02);
        const double speed = glm::length(body.spin);
        const quat turn = speed > 0 ? rotation(body.spin / speed, speed * seconds) : quat(1, 0, 0, 0);
        const auto goes_to = [&](vec3 place) {
            return body.position + seconds * body.velocity + turn * (place - body.position);
        };
        const SurfacePatch later = moved_on(patch, seconds);
        EXPECT_EQ(later.bodies[0].velocity, body.velocity);
        EXPECT_LE(glm::length(later.bodies[0].orientation - turn), 1e-14);
        for (std::uint32_t i = 0; i < patch.count; ++i) {
            const Surface &was = patch.surfaces[i], &is = later.surfaces[i];
            expect_near(is.a, goes_to(was.a), 1e-15);
            if (was.kind == SurfaceKind::triangle) expect_near(is.b, goes_to(was.b), 1e-15);
            if (was.kind == SurfaceKind::triangle) expect_near(is.c, goes_to(was.c), 1e-15);
            if (was.kind == SurfaceKind::plane) expect_near(is.b, turn * was.b, 1e-15);
            if (was.kind == SurfaceKind::sphere) expect_near(is.b, was.b, 0);
        }
    }
}

TEST(Surface, AFastPlateDoesNotPassThroughAStillProbe) {
    for (const SurfaceKind kind :
         {SurfaceKind::box, SurfaceKind::cylinder, SurfaceKind::sheet, SurfaceKind::triangle}) {
        for (const double speed : {0.5, 5.0, 50.0}) {
            Probe probe;
            const bool flat = kind == SurfaceKind::sheet || kind == SurfaceKind::triangle;
            const vec3 start(0, -0.0503, 0);
            if (flat)
                add(probe.patch, kind, start + vec3(-9, 0, -9), start + vec3(0, 0, 9),
                    start + vec3(9, 0, -9));
            else
                add(probe.patch, kind, start, {5, 1e-4, 5});
            probe.patch.bodies[0].velocity = {0, speed, 0};
            for (int tick = 0; tick < 300; ++tick, probe.advance()) {
                const ContactResult t = probe.at({0, 0, 0});
                const double top = probe.patch.surfaces[0].a.y + (flat ? 0 : 1e-4);
                if (top <= 0) continue;
                expect_near(t.force, {0, stiffness * top, 0}, gap_force + rounding * top * 1e3,
                            std::to_string(static_cast<int>(kind)));
            }
        }
    }
}

TEST(Surface, ARoughWallTakesTheProxyAlong) {
    Probe probe{floor_patch(rough)};
    probe.patch.bodies[0].velocity = {0.05, 0, 0.02};
    probe.at({0, 0.001, 0});
    const vec3 tip(0, -0.005, 0);
    probe.at(tip);
    const vec3 way = probe.patch.bodies[0].velocity;
    for (int tick = 1; tick < 500; ++tick) {
        probe.advance();
        const vec3 force = probe.at(tip).force;
        const vec3 pull = stiffness * dt * tick * way;
        const double held = 0.6 * stiffness * 0.005;
        if (glm::length(pull) < held - 1e-6) {
            expect_near(force, pull + vec3(0, stiffness * 0.005, 0), gap_force + rounding);
        } else {
            EXPECT_LE(glm::length(vec3(force.x, 0, force.z)), held + rounding);
        }
    }
}

/// A proxy that sticks to a turning disc moves round with it.
TEST(Surface, ASpinningBodyTurnsTheProxyAboutItsAxis) {
    SurfacePatch patch;
    add_body(patch, {.stiffness = stiffness, .static_friction = 10, .dynamic_friction = 10});
    add(patch, SurfaceKind::cylinder, {0, -0.01, 0}, {0.1, 0.01, 0});
    patch.bodies[0].spin = {0, 5, 0};
    Probe probe{patch};
    const vec3 tip(0.03, -0.01, 0);
    probe.at({0.03, 0.001, 0});
    probe.at(tip);
    for (int tick = 1; tick < 300; ++tick) {
        const double angle = 5 * dt * tick;
        const vec3 proxy(0.03 * det::cos(angle), 0, -0.03 * det::sin(angle));
        expect_near(probe.at(tip).proxy, proxy, 1e-9, std::to_string(tick));
    }
}

TEST(Surface, DampingActsOnTheWayInAlone) {
    Probe probe{floor_patch({.stiffness = stiffness, .damping = 2})};
    probe.at({0, 0.001, 0});
    const double spring = stiffness * 0.001;
    expect_near(probe.at({0, -0.001, 0}, {0.3, -0.1, 0}).force, {0, spring + 0.2, 0}, gap_force + rounding);
    expect_near(probe.at({0, -0.001, 0}, {0.3, 0.1, 0}).force, {0, spring, 0}, gap_force + rounding);
    probe.patch.bodies[0].velocity = {0, 0.1, 0};
    probe.advance();
    expect_near(probe.at({0, -0.001, 0}).force, {0, spring + stiffness * 1e-4 + 0.2, 0},
                gap_force + rounding);
}

}  // namespace
}  // namespace thaum::haptics::surface_tests
