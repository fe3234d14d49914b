// Stability of the fluid forces: they create no energy at a stirring hand and stay finite, for any hand,
// fluid and delay.
#include <gtest/gtest.h>

#include "core/file.h"
#include "core/random.h"
#include "unit/stirring_rig.h"

namespace thaum::haptics {
namespace {

DeviceSpec spec_in_file(const char* name) {
    const auto file = std::string(name) + ".toml";
    const auto toml = read_text_file(THAUM_SOURCE_DIR "/assets/devices/" + file, 1U << 16U);
    return *read_device(*Config::parse(*toml, file, 1));
}

vec3 vector_within(Random& random, double size) {
    return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

// ---- the feedback loop of hand and fluid ------------------------------------------------------------------

/// A fluid reduced to one mass, as a model of its delay: the hand's push acts one step after the motion, and
/// the velocity is read at the end of that step.
struct DelayedFluid {
    double mass{};  ///< mass of the fluid (kg)
    vec3 velocity{}, pushed{}, coming{};

    void step(FluidTouch& fluid) {
        velocity += coming / mass;
        coming = pushed;
        pushed = {};
        add_fluid_step(fluid, uniform_flow(velocity, 4, 8));
    }
};

/// Speed of the flow relative to the hand after some steps (m/s); 1 at the start. `told` is the mass of the
/// fluid that the hand's model states (kg), `mass` the true one. If hand_mass is 0, the hand is held fixed.
double flow_after(int steps, double told, double mass, double hand_mass) {
    StirringRig rig;
    rig.servo.max_damping = hand_mass > 0 ? 4 : 1e9;
    if (hand_mass > 0) {
        rig.spec.mass = hand_mass;
        rig.device = simulated_device(rig.spec, no_hand);
    }
    rig.fluid().modes.resistance = 1;
    rig.fluid().drag = {.form = 1e9, .stirred_mass = told};
    DelayedFluid fluid{.mass = mass, .velocity = {1, 0, 0}};
    for (int step = 0; step < steps; ++step) {
        fluid.step(rig.fluid());
        for (std::uint32_t tick = 0; tick < fluid_period; ++tick, ++rig.fluid().step_age) {
            if (hand_mass > 0)
                rig.tick();
            else
                rig.feel_at({});
            fluid.pushed -= force_on_ladle(rig.fluid(), rig.state.fluid) * tick_seconds;
        }
    }
    return glm::length(fluid.velocity - rig.fluid().frame.turn * rig.tip.velocity * 16.0);
}

TEST(FluidTouchHostile, TheLoopThroughTheFluidDoesNotRing) {
    for (const double mass : {0.1, 3.0, 200.0}) {
        EXPECT_LE(flow_after(60, mass, mass, 0), 1e-4) << mass;
        for (const double hand : {0.02, 0.1, 1.0}) EXPECT_LE(flow_after(300, mass, mass, hand), 1e-3);
        // Reason for the limit on the gain of the loop (how strongly a change of the flow brakes the flow
        // itself one step later): the oscillation decays up to a gain of 0.83 and grows beyond.
        EXPECT_LE(flow_after(400, mass * 0.80 / loop_gain, mass, 0), 0.2);
        EXPECT_GE(flow_after(400, mass * 0.86 / loop_gain, mass, 0), 5);
    }
}

// ---- energy at a stirring hand ----------------------------------------------------------------------------

/// A device with limits so high that the hand always gets all energy that the fluid gives. Otherwise the
/// balance of energy would be wrong.
DeviceSpec without_limits(DeviceSpec spec) {
    spec.peak_force = spec.continuous_force = 1000;
    return spec;
}

TEST(FluidTouchHostile, PassiveModesCreateNoEnergy) {
    for (const char* device : {"touch", "falcon", "omega3"}) {
        for (const std::uint32_t delay : {0U, 5U}) {
            for (auto [name, world] : bench::stirred_cases()) {
                world.delay = delay;
                const auto energy =
                    bench::StirringAttack(world, without_limits(spec_in_file(device))).run(6'000);
                EXPECT_LE(energy.most_created, 0.02) << device << " " << delay << " " << name;
                EXPECT_GT(energy.moved, 0.05) << device << " " << delay << " " << name;
            }
        }
    }
}

// ---- input that is not finite -----------------------------------------------------------------------------

double nasty_number(Random& random) {
    switch (random.below(9)) {
        case 0: return std::numeric_limits<double>::quiet_NaN();
        case 1: return random.below(2) == 0 ? HUGE_VAL : -HUGE_VAL;
        case 2: return random.uniform(-1, 1) * 1e300;
        case 3: return random.uniform(-1, 1) * 1e-300;
        case 4: return 0;
        default: return random.uniform(-3, 3);
    }
}
vec3 nasty_vector(Random& random) {
    return {nasty_number(random), nasty_number(random), nasty_number(random)};
}

FlowPatch nasty_patch(Random& random) {
    FlowPatch patch = uniform_flow({1, 0, 0}, 2, 3);
    for (FlowNode& node : patch.nodes) {
        if (random.below(4) != 0) continue;
        node = {fvec3(nasty_vector(random)), static_cast<float>(nasty_number(random)),
                static_cast<float>(nasty_number(random))};
    }
    if (random.below(4) == 0) patch.origin = nasty_vector(random);
    if (random.below(8) == 0) patch.spacing = nasty_number(random);
    return patch;
}

/// A fluid in which all forces, a surface and a wall act on the hand. Its counts may be out of range.
FluidTouch fluid_with_everything(Random& random) {
    FluidTouch fluid = some_fluid();
    fluid.number = random.below(3);
    fluid.modes = {1, 1, 1, 1, 1, 1, 1};
    fluid.ladle = {2, 4000, 40};
    fluid.wall = bench::round_bowl(1.5, 1);
    fluid.wall.stiffness = 5000;
    fluid.wall.damping = 10;
    fluid.surface = {.stiffness = 5000, .pop_through = 200, .cling = 40, .present = 1};
    fluid.wall.points = random.below(12);
    fluid.surface.inside = static_cast<std::uint32_t>(random.below(2));
    return fluid;
}

void spoil_fluid(FluidTouch& fluid, Random& random) {
    const auto sometimes = [&random](double& value) {
        if (random.below(6) == 0) value = nasty_number(random);
    };
    fluid = fluid_with_everything(random);
    for (const FluidMode& mode : fluid_modes) sometimes(fluid.modes.*mode.strength);
    for (double* value : {&fluid.frame.origin.y,
                          &fluid.frame.turn[0][1],
                          &fluid.frame.metres_per_metre,
                          &fluid.frame.newtons_per_newton,
                          &fluid.drag.viscous,
                          &fluid.drag.form,
                          &fluid.drag.stirred_mass,
                          &fluid.drag.height,
                          &fluid.surface.height,
                          &fluid.surface.velocity,
                          &fluid.surface.stiffness,
                          &fluid.surface.pop_through,
                          &fluid.surface.cling,
                          &fluid.wall.centre.x,
                          &fluid.wall.profile[2].x,
                          &fluid.wall.profile[5].y,
                          &fluid.wall.stiffness,
                          &fluid.wall.damping,
                          &fluid.ladle.mass,
                          &fluid.ladle.stiffness,
                          &fluid.ladle.damping})
        sometimes(*value);
    fluid.older = nasty_patch(random);
    fluid.newer = nasty_patch(random);
    fluid.step_age = random.below(2) == 0 ? random.below(40) : ~std::uint64_t{0} - random.below(3);
}

TEST(FluidTouchHostile, InvalidInputIsBlockedAndValidInputIsFeltAgain) {
    const auto spec = spec_in_file("touch");
    Servo servo = servo_of(spec, 1);
    Random random{33};
    for (int run = 0; run < 300; ++run) {
        ServoState state;
        HapticModel model;
        vec3 tip{};
        for (int tick = 0; tick < 100; ++tick) {
            if (random.below(3) == 0) spoil_fluid(model.fluid, random);
            tip += vector_within(random, random.below(30) == 0 ? 10 : 1e-3);
            const vec3 at = random.below(60) == 0 ? nasty_vector(random) : tip;
            const auto age = static_cast<std::uint32_t>(random.below(4) == 0 ? random.below(60) : 0);
            const vec3 force = servo_step(servo, state, model, {at, age});
            ASSERT_TRUE(is_finite(force));
            ASSERT_LE(glm::length(force), servo.limits.cap * (1 + 1e-12));
            ASSERT_TRUE(is_finite(state.fluid.force) && std::isfinite(state.fluid.surface_force));
            ASSERT_TRUE(is_finite(state.fluid.place) && is_finite(state.fluid.wall) &&
                        std::isfinite(state.fluid.flow_work));
            ASSERT_TRUE(std::isfinite(state.energy.created));
        }
        // Valid input again. Repeated excess may have switched the safety stage off, so it is switched on
        // again.
        model = {};
        model.fluid = some_fluid();
        model.fluid.number = 77;
        model.fluid.modes = {1, 0, 1, 0, 0, 1, 0};
        model.fluid.ladle = {2, 4000, 40};
        for (int tick = 0; tick < 1500; ++tick) {
            model.rearm = tick == 1000;
            servo_step(servo, state, model, {vec3(1e-5 * tick, 0, 0), 0});
        }
        // Drag at 0.01 m/s, with the coefficient (viscous 2 * 4 + form 1/2 * 8) / 16 = 0.75 N s/m. The
        // ladle's mass has followed the hand by now.
        EXPECT_NEAR(state.fluid.force.x, -0.01 * 0.75, 1e-6);
        EXPECT_NEAR(state.safety.output.x, -0.01 * 0.75, 1e-4) << run << " " << state.safety.cause;
    }
}

}  // namespace
}  // namespace thaum::haptics
