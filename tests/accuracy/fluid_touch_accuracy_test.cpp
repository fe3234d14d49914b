// Tests that a hand and a computed fluid, which push each other as in a match, together conserve momentum.
#include <gtest/gtest.h>

#include "fluid/fields.h"
#include "fluid/fluid.h"
#include "unit/stirring_rig.h"

namespace thaum::haptics {
namespace {

constexpr double brew_density = 8;  // density of the brew (kg/m^3)

/// A periodic box of fluid, 1 m wide, without walls, so that only the hand can absorb momentum.
struct StirredBox {
    fluid::Fluid fluid =
        *fluid::make_fluid({.cells = {16, 16, 16},
                            .h = 1.0 / 16,
                            .edges = {fluid::Edge::periodic, fluid::Edge::periodic, fluid::Edge::periodic},
                            .viscosity = 0.02});
    StirringRig rig{};
    vec3 given{};  ///< impulse given to the fluid (N s)

    StirredBox() {
        auto& fluid = rig.fluid();
        fluid.modes = {1, 1, 1, 0, 0, 0, 0};
        fluid.frame.origin = vec3(0.5);
        fluid.drag = {.viscous = 0.4, .form = 0.15, .stirred_mass = brew_density * 0.01};
        fluid.newer = {};
        add_fluid_step(fluid, flow());
    }

    FlowPatch flow() const {
        const FlowSource source{.velocity = fluid::face_grid(fluid.lattice, fluid.state.velocity),
                                .viscosity = 0.02 * brew_density,
                                .density = brew_density};
        return patch_of(source, to_bowl(rig.model.fluid.frame, rig.tip.position));
    }

    void fluid_step() {
        vec3 impulse{};
        for (std::uint32_t tick = 0; tick < fluid_period; ++tick, ++rig.fluid().step_age) {
            rig.tick();
            impulse -= force_on_ladle(rig.fluid(), rig.state.fluid) * tick_seconds;
        }
        given += impulse;
        push(fluid, {rig.state.fluid.place, 0.2, impulse / brew_density});
        advance(fluid, fluid_period * tick_seconds);
        add_fluid_step(rig.fluid(), flow());
    }

    /// Momentum of the hand in the bowl (kg m/s). Forces of the fluid are scaled by a factor s_f < 1 before
    /// the hand feels them, so to the fluid the hand seems heavier: its mass is divided by s_f.
    vec3 hand_momentum() const {
        const auto& frame = rig.model.fluid.frame;
        return frame.turn * (rig.spec.mass * rig.tip.velocity) / frame.newtons_per_newton;
    }
};

TEST(FluidTouchAccuracy, HandAndFluidTogetherConserveMomentum) {
    StirredBox box;
    box.rig.tip.velocity = {0.02, -0.01, 0.015};
    const vec3 start = box.hand_momentum();
    const double size = glm::length(start);
    for (int step = 0; step < 120; ++step) {
        box.fluid_step();
        const vec3 in_fluid = brew_density * fluid::momentum(box.fluid);
        ASSERT_LE(glm::length(box.given + box.hand_momentum() - start), 1e-6 * size) << step;
        ASSERT_LE(glm::length(in_fluid - box.given), 1e-6 * size) << step;
    }
    EXPECT_LT(glm::length(box.hand_momentum()), 0.7 * size) << "the fluid has a good part of it";
    EXPECT_LE(box.rig.state.energy.most_created, 1e-4);
}

TEST(FluidTouchAccuracy, AReleasedHandIsCarriedByTheFlow) {
    // The hand stirs in circles, is then released, and the flow that it has caused carries it along.
    StirredBox box;
    auto& rig = box.rig;
    rig.servo.limits.cap = 1e-9;  // no force on the hand while the test moves it
    const double radius = 0.2 / 16, turns_per_second = 1.5;
    int tick = 0;
    const auto led = [&](double t) {
        const double angle = 2 * pi * turns_per_second * t;
        return glm::transpose(rig.fluid().frame.turn) * (radius * vec3(std::cos(angle), 0, std::sin(angle)));
    };
    for (int step = 0; step < 120; ++step) {
        vec3 impulse{};
        for (std::uint32_t i = 0; i < fluid_period; ++i, ++tick, ++rig.fluid().step_age) {
            rig.feel_at(led(tick * tick_seconds));
            impulse -= force_on_ladle(rig.fluid(), rig.state.fluid) * tick_seconds;
        }
        push(box.fluid, {rig.state.fluid.place, 0.2, impulse / brew_density});
        advance(box.fluid, fluid_period * tick_seconds);
        rig.tip.position = led(tick * tick_seconds);
        add_fluid_step(rig.fluid(), box.flow());
    }
    const double current = glm::length(fluid::velocity_at(box.fluid, rig.state.fluid.place));
    EXPECT_GT(current, 0.2) << "m/s";
    StirringRig free;
    free.model.fluid = rig.model.fluid;
    free.model.fluid.drag = {.viscous = 4, .form = 4};
    free.tip = resting_at(rig.tip.position);
    for (int i = 0; i < 300; ++i, ++free.fluid().step_age) free.tick();
    const double carried = glm::length(free.tip.velocity) * 16;
    EXPECT_GT(carried, 0.5 * current);
    EXPECT_LT(carried, 1.5 * current);
}

}  // namespace
}  // namespace thaum::haptics
