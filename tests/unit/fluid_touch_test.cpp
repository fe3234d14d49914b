// Tests of the forces on a hand that stirs, compared with closed forms, and of the force that the fluid
// receives.
#include "haptics/fluid_touch.h"

#include <gtest/gtest.h>

#include "core/hash.h"
#include "core/random.h"
#include "fluid/spring_surface.h"
#include "unit/stirring_rig.h"

namespace thaum::haptics {
namespace {

/// Damping that the hand feels (N s/m) if the bowl has 1 N s/m. Between hand and bowl, forces are scaled by
/// s_f and lengths by s_x, so damping is scaled by their product.
constexpr double felt_share = 16.0 / 256;

vec3 in_device(const FluidTouch& fluid, vec3 bowl) { return glm::transpose(fluid.frame.turn) * bowl; }
vec3 any_vector(Random& random, double size) {
    return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

// ---- drag on a stirring hand ------------------------------------------------------------------------------

TEST(FluidTouch, EachModeFollowsItsEquation) {
    Random random{3};
    for (int run = 0; run < 100; ++run) {
        StirringRig rig;
        const double viscosity = random.uniform(0, 5), density = random.uniform(0, 9);
        const vec3 u = any_vector(random, 2), v = any_vector(random, 0.3), at = any_vector(random, 0.02);
        const FluidModes modes{.viscosity = random.uniform(0, 1),
                               .flow = random.uniform(0, 1),
                               .resistance = random.uniform(0, 1),
                               .surface = 0,
                               .wall = 0,
                               .inertia = 0};
        rig.fluid().modes = modes;
        add_fluid_step(rig.fluid(), uniform_flow(u, viscosity, density));
        add_fluid_step(rig.fluid(), uniform_flow(u, viscosity, density));
        const vec3 force = rig.feel_moving(at, v);
        const vec3 bowl_velocity = rig.fluid().frame.turn * (16.0 * v);
        const double mu = static_cast<float>(viscosity), rho = static_cast<float>(density);
        const vec3 seen = vec3(fvec3(u));
        const vec3 expected = -modes.viscosity * 2 * mu * bowl_velocity + modes.flow * 2 * mu * seen -
                              modes.resistance * 0.5 * rho * (bowl_velocity - seen);
        EXPECT_LE(glm::length(force - in_device(rig.fluid(), expected) / 256.0), 1e-10);
        EXPECT_LE(glm::length(rig.state.fluid.force - force), 1e-15);
        EXPECT_LE(glm::length(force_on_ladle(rig.fluid(), rig.state.fluid) - expected), 1e-8);
    }
}

TEST(FluidTouch, AMixtureIsFeltAsTheWeightedSumOfItsSubstances) {
    // Two substances, each in a grid of its own: their forces are added in proportion to their amounts
    // (section 4.1 of paper 000).
    std::array<float, 8> one{}, other{}, still{};
    one.fill(0.25F);
    other.fill(0.5F);
    const auto grid = [](const std::array<float, 8>& samples) {
        return field::Grid{
            .first = samples.data(), .count = {2, 2, 2}, .stride = {1, 2, 4}, .spacing = vec3(1)};
    };
    const auto force_of = [&](double first, double second) {
        StirringRig rig;
        rig.fluid().modes.viscosity = rig.fluid().modes.resistance = 1;
        FlowSource source{.velocity = {{grid(still), grid(still), grid(still)}}};
        source.substances[0] = {grid(one), 2 * first, 4 * first};
        source.substances[1] = {grid(other), 3 * second, 1 * second};
        add_fluid_step(rig.fluid(), patch_of(source, {}));
        add_fluid_step(rig.fluid(), patch_of(source, {}));
        return rig.feel_moving({}, {0.1, 0, 0});
    };
    const vec3 sum = force_of(1, 0) + force_of(0, 1);
    EXPECT_LE(glm::length(force_of(1, 1) - sum), 1e-12);
    // With the amounts 1/4 and 1/2, the viscosity is 1/4 * 2 + 1/2 * 3 and the density 1/4 * 4 + 1/2 * 1. The
    // expected damping is 2 times the viscosity plus 1/2 times the density.
    EXPECT_NEAR(force_of(1, 1).x, -0.1 * felt_share * (2 * 2.0 + 0.5 * 1.5), 1e-12);
}

TEST(FluidTouch, AFreeHandReachesTheVelocityOfTheFlow) {
    for (const bool by_resistance : {true, false}) {
        StirringRig rig;
        auto& modes = rig.fluid().modes;
        if (by_resistance)
            modes.resistance = 1;
        else
            modes.viscosity = modes.flow = 1;
        const vec3 u{1, 0.25, -0.5};
        rig.fluid().step_age = 100;
        add_fluid_step(rig.fluid(), uniform_flow(u, 4, 8));
        for (int tick = 0; tick < 8000; ++tick, ++rig.fluid().step_age) rig.tick();
        EXPECT_LE(glm::length(rig.tip.velocity - in_device(rig.fluid(), u) / 16.0), 1e-6) << by_resistance;
        EXPECT_LE(rig.state.energy.most_created, 1e-3);
    }
}

/// Share z of its velocity that a mass keeps in a tick. The mass is braked in proportion to its mean velocity
/// over the last 8 ticks, with a force that is constant within each tick. `gain` is the share that a steady
/// velocity would lose in a tick. So z solves 1 - z = gain * (1 + z) / 2 * (sum of z^-j over j = 1 to 8) / 8.
double decay_per_tick(double gain) {
    double low = 0.9, high = 1;
    for (int i = 0; i < 200; ++i) {
        const double z = (low + high) / 2;
        double sum = 0, power = 1;
        for (int j = 0; j < 8; ++j) sum += power /= z;
        (1 - z > gain * (1 + z) / 2 * sum / 8 ? low : high) = z;
    }
    return (low + high) / 2;
}

TEST(FluidTouch, ViscosityBrakesAFreeHandAtItsRate) {
    StirringRig rig;
    rig.fluid().modes.viscosity = 1;  // 0.5 N s/m at the hand on a mass of 0.1 kg give a rate of 5 per second
    const double gain = felt_share * 2 * 4 / 0.1 * tick_seconds;
    rig.tip.velocity = {0.2, -0.1, 0.05};
    for (int tick = 0; tick < 100; ++tick) rig.tick();
    const vec3 before = rig.tip.velocity;
    for (int tick = 0; tick < 200; ++tick) rig.tick();
    const double z = decay_per_tick(gain);
    EXPECT_LE(glm::length(rig.tip.velocity - before * std::pow(z, 200)), 1e-9 * glm::length(before));
    EXPECT_NEAR(-std::log(z) / tick_seconds, 5, 0.15) << "the lag of the window adds only 2 %";
}

TEST(FluidTouch, NoBrewIsTooThickForTheDevice) {
    for (const double viscosity : {10.0, 1e3, 1e30}) {
        StirringRig across, along;
        const vec3 u = in_device(across.fluid(), vec3(2, 0, 0) / 16.0), v{0, 0.2, 0};
        for (StirringRig* rig : {&across, &along}) {
            rig->fluid().modes.viscosity = rig->fluid().modes.flow = 1;
            add_fluid_step(rig->fluid(), uniform_flow({2, 0, 0}, viscosity, 0));
            add_fluid_step(rig->fluid(), uniform_flow({2, 0, 0}, viscosity, 0));
        }
        const double slope = std::min(felt_share * 2 * viscosity, 30.0);
        EXPECT_LE(glm::length(across.feel_moving({}, v) + slope * (v - u)), 1e-9) << viscosity;
        EXPECT_LE(glm::length(along.feel_moving({}, u)), 1e-9)
            << "a hand that moves with the flow feels no force";
    }
}

TEST(FluidTouch, TheFluidLosesTheMomentumThatTheHandGains) {
    // All kinds of drag act at once, in a growing flow and a brew that changes from step to step. The
    // device's momentum, known from its motion alone, must equal the sum of what the fluid receives.
    StirringRig rig;
    rig.fluid().modes = {1, 1, 1, 0, 0, 0, 0};
    Random random{5};
    rig.tip.velocity = {0.01, 0.02, 0};
    const vec3 start = rig.tip.velocity;
    vec3 fluid_got{}, size{};
    for (int tick = 0; tick < 3000; ++tick, ++rig.fluid().step_age) {
        const double much = (tick - tick % 16) / 3200.0;
        if (tick % 16 == 0)
            add_fluid_step(rig.fluid(),
                           uniform_flow(much * vec3(1, -0.5, 2), random.uniform(0, 5), random.uniform(0, 5)));
        rig.tick();
        const vec3 on_fluid = -force_on_ladle(rig.fluid(), rig.state.fluid) * tick_seconds;
        fluid_got += on_fluid;
        size += glm::abs(on_fluid);
    }
    ASSERT_LT(rig.state.energy.active_work, active_budget) << "the budget withheld nothing";
    ASSERT_EQ(rig.state.energy.most_created, 0) << "the passivity controller did not act";
    const vec3 hand_got = rig.fluid().frame.turn * (0.1 * (rig.tip.velocity - start)) * 256.0;
    EXPECT_LE(glm::length(fluid_got + hand_got), 1e-6 * glm::length(size));
    EXPECT_GT(glm::length(size), 1);
}

TEST(FluidTouch, TheFluidGetsTheWholeForceWhenTheHandsForceIsCapped) {
    StirringRig rig;
    rig.fluid().modes.viscosity = 1;
    const vec3 all = rig.feel_moving({}, {0.3, 0, 0});
    const vec3 world = force_on_ladle(rig.fluid(), rig.state.fluid);
    for (const bool on : {true, false}) {
        StirringRig gentle;
        gentle.fluid().modes.viscosity = 1;
        gentle.servo.limits.cap = glm::length(all) / 3;
        gentle.model.on = on;
        const vec3 less = gentle.feel_moving({}, {0.3, 0, 0});
        EXPECT_NEAR(glm::length(less), on ? glm::length(all) / 3 : 0, 1e-12);
        EXPECT_EQ(force_on_ladle(gentle.fluid(), gentle.state.fluid), world);
    }
}

// ---- change of the force over time ------------------------------------------------------------------------

TEST(FluidTouch, AFluidStepMakesNoJump) {
    StirringRig rig;
    rig.fluid().modes = {1, 1, 1, 0, 0, 0, 0};
    Random random{8};
    const auto step = [&] {
        return uniform_flow(any_vector(random, 2), random.uniform(0, 4), random.uniform(0, 4));
    };
    add_fluid_step(rig.fluid(), step());
    rig.fluid().step_age = 16;
    vec3 before = rig.feel_moving({}, {}), at_step = before;
    for (int fluid_step = 0; fluid_step < 200; ++fluid_step) {
        add_fluid_step(rig.fluid(), step());
        double largest = 0;
        for (int tick = 0; tick < 16; ++tick, ++rig.fluid().step_age) {
            const vec3 force = rig.feel_at({});
            largest = std::max(largest, glm::length(force - before));
            before = force;
        }
        EXPECT_GT(largest, 0);
        EXPECT_LE(largest, 0.0625 * (1 + 1e-9) * glm::length(before - at_step));
        at_step = before;
    }
}

TEST(FluidTouch, AnOldModelContinuesLikeANewOne) {
    StirringRig fresh, old;
    for (StirringRig* rig : {&fresh, &old}) {
        rig->fluid().modes = {1, 1, 1, 1, 0, 0, 0};
        rig->fluid().surface = {
            .height = 0.3, .velocity = 0.2, .stiffness = 4000, .pop_through = 300, .present = 1};
        add_fluid_step(rig->fluid(), uniform_flow({2, 1, 0}, 1, 3));
    }
    for (int tick = 0; tick < 40; ++tick) {
        old.model_age = static_cast<std::uint32_t>(std::min(tick, 19));
        if (tick > 19) {
            ++old.fluid().step_age;
            old.fluid().surface.height += 0.2 * tick_seconds;
        }
        const vec3 at{1e-4 * tick, 0, 0};
        EXPECT_LE(glm::length(fresh.feel_at(at) - old.feel_at(at)), 1e-9) << tick;
        ++fresh.fluid().step_age;
        fresh.fluid().surface.height += 0.2 * tick_seconds;
    }
    EXPECT_GT(glm::length(fresh.state.fluid.force) + std::abs(fresh.state.fluid.surface_force), 0.1);
}

// ---- the wall of the bowl ---------------------------------------------------------------------------------

/// Distance of a place from the inside of the bowl, the largest over the straight pieces of the bowl's
/// outline (m); negative inside.
double outside_by(const BowlWall& wall, vec3 place) {
    const vec3 off = place - wall.centre;
    const vec2 at{std::sqrt(off.x * off.x + off.z * off.z), off.y};
    double most = -HUGE_VAL;
    for (std::size_t i = 0; i + 1 < wall.points; ++i) {
        const vec2 way = glm::normalize(wall.profile[i + 1] - wall.profile[i]);
        most = std::max(most, glm::dot(vec2(-way.y, way.x), at - wall.profile[i]));
    }
    return most;
}

TEST(FluidTouch, TheWallHoldsAtTheNearestPlaceInTheBowl) {
    Random random{4};
    // The bowl of the arena, which is widest below its rim, and a bowl shaped as half an ellipsoid.
    BowlWall court{.points = 5};
    court.profile = {vec2{1.265, 0}, {1.35, -0.31}, {1.2, -0.56}, {0.75, -0.73}, {0, -0.76}};
    for (int run = 0; run < 3000; ++run) {
        BowlWall wall = run % 2 == 0 ? court : bench::round_bowl(1.2, 0.7);
        wall.centre = any_vector(random, 1);
        const vec3 place = wall.centre + any_vector(random, run % 3 == 0 ? 30 : 1.5);
        const vec3 held = nearest_in_bowl(wall, place);
        if (outside_by(wall, place) <= 0) {
            EXPECT_EQ(held, place);
            continue;
        }
        EXPECT_LE(std::abs(outside_by(wall, held)), 1e-12);
        // In a convex set, `held` is the place nearest to `place` if (place - held) . (within - held) <= 0
        // for every place `within` the set.
        for (int other = 0; other < 30; ++other) {
            const vec3 within = wall.centre + any_vector(random, 1.4);
            if (outside_by(wall, within) > 0) continue;
            EXPECT_LE(glm::dot(place - held, within - held), 1e-9);
        }
    }
    for (const vec3 place : {vec3(0, -50, 0), vec3(50, 0, 0), vec3(0, -1e9, 0)})
        EXPECT_LE(std::abs(outside_by(court, nearest_in_bowl(court, place))), 1e-6);
    court.points = 1;
    EXPECT_EQ(nearest_in_bowl(court, {9, 9, 9}), vec3(9, 9, 9));
}

TEST(FluidTouch, AHandThatPressesOnTheBowlEntersByForceOverStiffness) {
    StirringRig rig;
    rig.spec.damping = 2;
    rig.device = simulated_device(rig.spec, no_hand);
    rig.fluid().modes.wall = 1;
    rig.fluid().frame.origin = {};
    rig.fluid().wall = bench::round_bowl(1.5, 1);
    rig.fluid().wall.stiffness = 5000;  // stiffness 312.5 N/m and damping 2.5 N s/m at the hand
    rig.fluid().wall.damping = 40;
    const vec3 out = in_device(rig.fluid(), glm::normalize(vec3(0.3, -1, 0.2)));
    rig.model.steady_force = {2.0 * out, 1};
    for (int tick = 0; tick < 6000; ++tick) rig.tick();
    const auto& state = rig.state.fluid;
    const vec3 place = to_bowl(rig.fluid().frame, rig.tip.position);
    EXPECT_NEAR(glm::length(place - state.place) / 16, 2.0 / 312.5, 2e-6);
    EXPECT_NEAR(glm::length(state.wall), 2, 1e-3);
    EXPECT_LE(glm::length(state.wall + rig.model.steady_force.force), 1e-2);
    // The wall pulls the tip back from any depth, whatever path it came by.
    const vec3 far = rig.feel_at(out * 3.0);
    EXPECT_LT(glm::dot(far, out), 0);
}

TEST(FluidTouch, TheWallNeverPulls) {
    StirringRig rig;
    rig.fluid().modes.wall = 1;
    rig.fluid().frame = {.metres_per_metre = 1, .newtons_per_newton = 1};
    rig.fluid().wall = {
        .profile = {vec2{1, 0}, {1, -1}, {0, -1}}, .points = 3, .stiffness = 100, .damping = 20};
    EXPECT_EQ(rig.feel_moving({0, -0.9, 0}, {0, -0.5, 0}), vec3(0));
    EXPECT_NEAR(rig.feel_moving({0, -1.1, 0}, {0, -0.5, 0}).y, 10 + 10, 1e-9);
    EXPECT_NEAR(rig.feel_moving({0, -1.1, 0}, {0, 0.25, 0}).y, 10 - 5, 1e-9);
    EXPECT_EQ(rig.feel_moving({0, -1.1, 0}, {0, 0.75, 0}).y, 0);
    EXPECT_NEAR(rig.feel_moving({2, 0.5, 0}, {}).x, -100, 1e-9) << "above the rim the wall is vertical";
}

// ---- the surface of the liquid ----------------------------------------------------------------------------

BrewSurface surface_of(const fluid::SpringSurfaceSettings& s, const fluid::ProbeReaction& r) {
    return {.height = r.height,
            .stiffness = s.contact,
            .pop_through = s.pop_through,
            .cling = s.cling,
            .inside = r.inside ? 1U : 0U,
            .present = 1};
}

TEST(FluidTouch, TheSurfaceForceIsThatOfTheSpringSurface) {
    fluid::SpringSurfaceSettings settings;
    settings.damping = 4;
    fluid::SpringSurface surface = make_spring_surface(settings);
    fluid::SpringSurfaceScratch scratch;
    StirringRig rig;
    rig.fluid().modes.surface = 1;
    const auto press = [&](double height, int calls) {
        fluid::ProbeReaction last;
        for (int i = 0; i < calls; ++i) {
            const std::array probe{fluid::SurfaceProbe{.height = height, .radius = 0.1}};
            last = advance(surface, scratch, probe, 0.004).probes[0];
        }
        return last;
    };
    bool popped = false;
    int pushed = 0, pulled = 0;
    for (double height = 0.05, way = -0.01; height < 0.1; height += way) {
        const auto reaction = press(height, 500);
        popped |= reaction.inside;
        if (height < -0.4) way = 0.003;
        rig.fluid().surface = surface_of(settings, reaction);
        const vec3 at = in_device(rig.fluid(), vec3(0, height, 0) - rig.fluid().frame.origin) / 16.0;
        const vec3 force = rig.feel_moving(at, {});
        const vec3 up = in_device(rig.fluid(), {0, 1, 0});
        EXPECT_LE(glm::length(256.0 * force - reaction.force * up), 1e-3) << height;
        EXPECT_EQ(rig.state.fluid.inside, reaction.inside ? 1U : 0U);
        (reaction.force > 1 ? pushed : pulled) += std::abs(reaction.force) > 1 ? 1 : 0;
        if (way > 0 && !reaction.inside) break;
    }
    EXPECT_TRUE(popped);
    EXPECT_GT(pushed, 3);
    EXPECT_GT(pulled, 0);
}

TEST(FluidTouch, ASurfaceThatLiftsAHandLosesTheEnergy) {
    // A hand lifted with the surface gets the energy that the surface loses. Held against a sinking surface,
    // the hand gives energy.
    StirringRig rig;
    rig.fluid().modes.surface = 1;
    rig.fluid().frame = {.metres_per_metre = 20, .newtons_per_newton = 0.005};
    rig.fluid().surface = {.stiffness = 4000, .pop_through = 300, .present = 1};
    rig.feel_at({});
    for (int tick = 0; tick < 1000; ++tick) {
        const double y = 0.02 * std::sin(2 * pi * tick / 1000);
        rig.fluid().surface.height = 20 * y + 0.05;
        EXPECT_NEAR(rig.feel_at({0, y, 0}).y, 0.005 * 4000 * 0.05, 1e-12);
        EXPECT_LE(rig.state.energy.created, 1e-12) << tick;
    }
}

TEST(FluidTouch, ACurrentIsHeldToItsBudget) {
    StirringRig rig;
    rig.fluid().modes.flow = 1;
    for (int step = 0; step < 2; ++step) add_fluid_step(rig.fluid(), uniform_flow({160, 0, 0}, 4, 0));
    double work = 0;
    for (int tick = 0; tick < 1000; ++tick) {
        const vec3 from = rig.tip.position;
        rig.tick();
        work += glm::dot(rig.tip.force, rig.tip.position - from);
    }
    EXPECT_GT(work, 0.9 * active_budget);
    EXPECT_LT(work, 2.5 * active_budget);
}

TEST(FluidTouch, TheLadleIsFeltAsItDipsIn) {
    StirringRig rig;
    rig.fluid().modes.viscosity = 1;
    rig.fluid().frame = {.metres_per_metre = 1, .newtons_per_newton = 1};
    rig.fluid().drag = {.viscous = 1, .height = 0.2};
    rig.fluid().surface = {.height = 0, .inside = 1, .present = 1};
    const auto drag_at = [&rig](double y) { return -rig.feel_moving({0, y, 0}, {0.1, 0, 0}).x / 0.1; };
    EXPECT_EQ(drag_at(0.05), 0);
    EXPECT_NEAR(drag_at(-0.05), 1, 1e-9);
    EXPECT_NEAR(drag_at(-0.1), 2, 1e-9);
    EXPECT_NEAR(drag_at(-0.5), 4, 1e-9);
    rig.fluid().surface.inside = 0;  // the probe has not broken through the surface yet
    EXPECT_EQ(drag_at(-0.1), 0);
    EXPECT_EQ(rig.state.fluid.immersed, 0);
}

// ---- inertia of the ladle, and recoil ---------------------------------------------------------------------

TEST(FluidTouch, TheLadleHasItsMass) {
    for (const double strength : {1.0, 0.5}) {
        StirringRig rig;
        rig.fluid().modes.inertia = strength;
        // The ladle as felt at the hand: 0.2 kg, 300 N/m and 3.75 N s/m.
        rig.fluid().ladle = {.mass = 3.2, .stiffness = 4800, .damping = 60};
        const double mass = strength * 0.2;
        for (int tick = 0; tick < 10; ++tick) rig.tick();
        // A force so small that it stays within the energy that forces may give to a hand.
        rig.model.steady_force = {{0.2, 0, 0.25}, 1};
        vec3 halfway{};
        for (int tick = 0; tick < 1000; ++tick) {
            rig.tick();
            if (tick == 499) halfway = rig.tip.velocity;
            // In each tick, the momentum of hand and ladle equals the impulse applied so far.
            const vec3 momentum = 0.1 * rig.tip.velocity + mass * rig.state.fluid.mass_velocity;
            ASSERT_LE(glm::length(momentum - rig.model.steady_force.force * ((tick + 1) * tick_seconds)),
                      1e-9)
                << tick;
        }
        const vec3 acceleration = (rig.tip.velocity - halfway) / 0.5;
        EXPECT_LE(glm::length(acceleration - rig.model.steady_force.force / (0.1 + mass)), 1e-3) << strength;
        EXPECT_LE(rig.state.energy.most_created, 1e-4);
    }
}

TEST(FluidTouch, ALadleOfAnyMassIsStable) {
    for (const double mass : {1e-6, 1e-3, 0.1, 10.0, 1e4}) {
        StirringRig rig;
        rig.fluid().modes.inertia = 1;
        rig.fluid().ladle = {
            .mass = mass / felt_share, .stiffness = 300 / felt_share, .damping = 3 / felt_share};
        rig.tip.velocity = {0.3, 0, 0};
        const double energy = 0.1 * 0.3 * 0.3 / 2;
        for (int tick = 0; tick < 5000; ++tick) {
            rig.tick();
            ASSERT_LE(0.05 * glm::dot(rig.tip.velocity, rig.tip.velocity), energy * 1.02) << mass;
        }
    }
}

TEST(FluidTouch, AThrownSubstanceRecoilsByItsImpulse) {
    StirringRig rig;
    rig.fluid().modes.recoil = 0.5;
    rig.fluid().modes.wall = 1;
    const vec3 impulse{1, 2, -0.5};
    rig.model.pulse = {recoil_peak(rig.fluid(), impulse, 30), 30, 1};
    for (int tick = 0; tick < 40; ++tick) rig.tick();
    EXPECT_LE(glm::length(0.1 * rig.tip.velocity - in_device(rig.fluid(), impulse) * (0.5 / 256)), 1e-12);
    EXPECT_EQ(recoil_peak(rig.fluid(), impulse, 0), vec3(0));
    rig.fluid().modes.recoil = 0;
    EXPECT_EQ(recoil_peak(rig.fluid(), impulse, 30), vec3(0));
}

// ---- forces switched off, and switches between them -------------------------------------------------------

TEST(FluidTouch, AtZeroStrengthThereIsNoForce) {
    StirringRig none, off;
    none.model.fluid = {};
    off.fluid().modes = no_modes();
    off.fluid().wall = bench::round_bowl(0.01, 0.01);
    off.fluid().wall.stiffness = 1e4;
    off.fluid().ladle = {1, 300, 3};
    off.fluid().surface = {.height = 1, .stiffness = 1e4, .pop_through = 1e4, .present = 1};
    Random random{6};
    for (int tick = 0; tick < 500; ++tick) {
        const vec3 at = any_vector(random, 0.001);
        for (StirringRig* rig : {&none, &off}) {
            rig->model.tether = {.stiffness = 100, .damping = 1};
            rig->model.pulse = {{1, 0, 0}, 10, static_cast<std::uint32_t>(1 + tick / 50)};
            rig->model.steady_force.number =
                // A new number of the steady force says that the force has jumped, which counts as a switch,
                // too
                1 + static_cast<std::uint64_t>(tick) / 7;
        }
        off.fluid().number = none.model.steady_force.number;
        ASSERT_EQ(none.feel_at(at), off.feel_at(at));
        // The position of the ladle is computed even though the forces are off.
        const vec3 place = nearest_in_bowl(off.fluid().wall, to_bowl(off.fluid().frame, at));
        ASSERT_EQ(off.state.fluid.place, place);
        ASSERT_EQ(off.state.fluid.immersed, 0) << "above the surface";
        ServoState but_for_it = off.state;
        but_for_it.fluid = {};
        ASSERT_EQ(hash_value(none.state), hash_value(but_for_it)) << tick;
    }
    EXPECT_NE(off.state.fluid.place, to_bowl(off.fluid().frame, vec3(0))) << "the bowl is in the way";
}

TEST(FluidTouch, AppearingVanishingAndJumpingAreSwitches) {
    StirringRig rig;
    rig.fluid().modes = {1, 1, 1, 0, 0, 0, 0};
    rig.servo.limits.slew = 40;
    const vec3 u{6, 0, 0};
    add_fluid_step(rig.fluid(), uniform_flow(u, 4, 8));
    add_fluid_step(rig.fluid(), uniform_flow(u, 4, 8));
    vec3 before = rig.feel_at({});
    const auto numbers = {1U, 2U, 0U, 5U};
    double largest = 0;
    for (const auto number : numbers) {
        rig.fluid().number = number;
        if (number == 2) rig.fluid().frame.newtons_per_newton /= 3;
        for (int tick = 0; tick < 40; ++tick) {
            const vec3 force = rig.feel_at({});
            EXPECT_LE(glm::length(force - before), 0.04 + 1e-12) << number << " " << tick;
            largest = std::max(largest, glm::length(force));
            before = force;
        }
        EXPECT_EQ(rig.state.fluid.number, number);
        if (number == 0) {
            EXPECT_EQ(before, vec3(0));
            EXPECT_EQ(hash_value(rig.state.fluid), hash_value(FluidTouchState{}));
        }
    }
    EXPECT_GT(largest, 0.2);
}

}  // namespace
}  // namespace thaum::haptics
