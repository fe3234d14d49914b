// Tests of textures on surfaces against closed forms: paper 004's sinusoidal grating, which pushes along the
// normal of the wall or of the texture, and the bump map.
#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "core/units.h"
#include "haptics/surface/surface.h"

namespace thaum::haptics {
namespace {

// Stiffness of the wall (N/m), amplitude and period of its texture (m).
constexpr double wall_stiffness = 500, crest = 2e-4, period = 0.004;
// Tolerance (N), of which the gap between proxy and surface causes 1e-7 N.
constexpr double force_rounding = 1e-6;

SurfacePatch textured(TextureKind kind, double friction = 0) {
    SurfacePatch patch;
    patch.surfaces[0] = {.kind = SurfaceKind::plane, .b = {0, 1, 0}};
    patch.count = 1;
    patch.body_count = 1;
    patch.bodies[0].material = {.stiffness = wall_stiffness,
                                .static_friction = friction,
                                .dynamic_friction = friction,
                                .texture = {.kind = kind, .amplitude = crest, .wavelength = period}};
    Random random{3};
    for (float& node : patch.bumps) node = static_cast<float>(random.uniform());
    return patch;
}

double grating(double x) { return crest * (std::sin(2 * pi * x / period) + 1); }
double grating_slope(double x) { return crest * 2 * pi / period * std::cos(2 * pi * x / period); }

/// Force on a tip that came from straight above, so that the proxy is above the tip (N).
vec3 feel(const SurfacePatch& patch, vec3 tip) {
    SurfaceState state{.proxy = {tip.x, 0.01, tip.z}, .begun = 1};
    return touch(patch, state, {tip, {}}, tick_seconds).force;
}

TEST(Texture, AnImpactGratingPushesAlongTheWallByThePapersDepth) {
    const auto patch = textured(TextureKind::impact);
    for (int i = 0; i < 200; ++i) {
        const double x = 1e-4 * i - 0.01, z = 2e-3 * std::sin(i);  // z is the height above the wall
        const vec3 force = feel(patch, {x, z, 0.3});
        const double depth = z > 0 ? 0 : grating(x) - z;  // depth below the texture: p_1(t) of paper 004
        EXPECT_NEAR(force.y, wall_stiffness * depth, force_rounding) << i;
        EXPECT_EQ(force.x, 0);
        EXPECT_EQ(force.z, 0);
    }
}

TEST(Texture, AVibrationGratingPushesAlongTheTexturesNormal) {
    const auto patch = textured(TextureKind::vibration);
    int between = 0;
    for (int i = 0; i < 400; ++i) {
        const double x = 1e-4 * i - 0.02, z = 6e-4 * std::sin(i);
        const vec3 force = feel(patch, {x, z, 0.3});
        const double depth = z > grating(x) ? 0 : grating(x) - z;
        const vec3 normal = glm::normalize(vec3(-grating_slope(x), 1, 0));
        EXPECT_LE(glm::length(force - wall_stiffness * depth * normal), force_rounding) << i;
        if (z > 0 && depth > 0) ++between;
    }
    EXPECT_GT(between, 30) << "above the wall and in the texture";
}

TEST(Texture, AHeightMapRepeatsAndIsSmoothAndKeepsItsRange) {
    auto patch = textured(TextureKind::bumps);
    const Texture& texture = patch.bodies[0].material.texture;
    Random random{4};
    for (int i = 0; i < 2000; ++i) {
        const vec3 place(random.uniform(-0.02, 0.02), 0, random.uniform(-0.02, 0.02));
        const Relief here = relief_at(texture, patch.bumps, place);
        EXPECT_GE(here.height, 0);
        EXPECT_LE(here.height, 2 * crest);
        const Relief next = relief_at(texture, patch.bumps, place + vec3(period, 5, -2 * period));
        EXPECT_NEAR(here.height, next.height, 1e-14);
        const double step = 1e-8;
        const double dx = relief_at(texture, patch.bumps, place + vec3(step, 0, 0)).height -
                          relief_at(texture, patch.bumps, place - vec3(step, 0, 0)).height;
        const double dz = relief_at(texture, patch.bumps, place + vec3(0, 0, step)).height -
                          relief_at(texture, patch.bumps, place - vec3(0, 0, step)).height;
        EXPECT_LE(glm::length(here.slope - vec3(dx, 0, dz) / (2 * step)), 2e-5);
    }
    patch.bumps.fill(0.25F);
    const Relief flat = relief_at(texture, patch.bumps, {0.0123, 0, 0.4});
    EXPECT_NEAR(flat.height, 0.5 * crest, 1e-17);
    EXPECT_LE(glm::length(flat.slope), 1e-12);
}

TEST(Texture, BumpsPushByTheSlopeOfTheSpringsEnergy) {
    const auto patch = textured(TextureKind::bumps);
    const Texture& texture = patch.bodies[0].material.texture;
    const auto energy = [&](vec3 tip) {
        const double depth = std::max(0.0, relief_at(texture, patch.bumps, {tip.x, 0, tip.z}).height - tip.y);
        return 0.5 * wall_stiffness * depth * depth;
    };
    Random random{5};
    for (int i = 0; i < 500; ++i) {
        const vec3 tip(random.uniform(-0.01, 0.01), random.uniform(-1e-3, 2e-4), random.uniform(-0.01, 0.01));
        vec3 slope(0);
        for (int axis = 0; axis < 3; ++axis) {
            vec3 step(0);
            step[axis] = 1e-8;
            slope[axis] = (energy(tip + step) - energy(tip - step)) / 2e-8;
        }
        EXPECT_LE(glm::length(feel(patch, tip) + slope), 2e-5) << i;
    }
}

/// Work of a slow round trip (J): the tip presses in at one place and comes out at another.
double work_of_round(const SurfacePatch& patch) {
    SurfaceState state;
    touch(patch, state, {{0, 0.005, 0}, {}}, tick_seconds);
    vec3 tip(0), force(0);
    double work = 0;
    constexpr int ticks = 40'000;
    for (int tick = 0; tick <= ticks; ++tick) {
        const double angle = 2 * pi * tick / ticks;
        const vec3 next(3.3e-3 * std::cos(angle), -5e-4 + 1e-3 * std::sin(angle), 1e-3 * std::sin(2 * angle));
        const vec3 there = touch(patch, state, {next, {}}, tick_seconds).force;
        if (tick > 0) work += glm::dot(0.5 * (force + there), next - tip);
        tip = next;
        force = there;
    }
    return work;
}

TEST(Texture, BumpsCreateNoEnergyAndTheActiveGratingDoes) {
    EXPECT_LT(std::abs(work_of_round(textured(TextureKind::bumps))), 1e-10);
    EXPECT_LT(work_of_round(textured(TextureKind::bumps, 0.5)), -1e-7) << "friction takes some";
    EXPECT_GT(std::abs(work_of_round(textured(TextureKind::impact))), 1e-7) << "as documented";
}

TEST(Texture, ItIsFixedToItsBody) {
    for (const auto kind : {TextureKind::impact, TextureKind::vibration, TextureKind::bumps}) {
        const SurfacePatch here = textured(kind);
        SurfacePatch there = here;
        const quat turn = rotation({0.6, 0, 0.8}, 0.7);
        const vec3 move(0.03, -0.02, 0.05);
        there.surfaces[0].a = move;
        there.surfaces[0].b = turn * vec3(0, 1, 0);
        there.bodies[0].position = move;
        there.bodies[0].orientation = turn;
        for (int i = 0; i < 50; ++i) {
            const vec3 tip(1.7e-4 * i, -3e-4, 1.1e-4 * i);
            SurfaceState state{.proxy = move + turn * vec3(tip.x, 0.01, tip.z), .begun = 1};
            const vec3 force = touch(there, state, {move + turn * tip, {}}, tick_seconds).force;
            EXPECT_LE(glm::length(force - turn * feel(here, tip)), 1e-9);
        }
    }
}

TEST(Texture, OnABallItIsCutFromABlock) {
    SurfacePatch patch = textured(TextureKind::vibration);
    const double radius = 0.05;
    patch.surfaces[0] = {.kind = SurfaceKind::sphere, .b = {radius, 0, 0}};
    for (int i = -20; i <= 20; ++i) {
        const double angle = 0.03 * i;
        const vec3 out(std::sin(angle), std::cos(angle), 0);
        SurfaceState state{.proxy = 0.06 * out, .begun = 1};
        const ContactResult felt = touch(patch, state, {(radius - 0.001) * out, {}}, tick_seconds);
        const double x = (radius + 2 * crest) * out.x;  // x of the proxy, on the texture's top (m)
        const vec3 along(grating_slope(x), 0, 0);
        const vec3 normal = glm::normalize(out - (along - glm::dot(along, out) * out));
        EXPECT_LE(glm::length(felt.force - wall_stiffness * (0.001 + grating(x)) * normal), force_rounding);
    }
}

}  // namespace
}  // namespace thaum::haptics
