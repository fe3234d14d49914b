// Energy of heavy and light substances: the flow gains no more energy than pushes and falling release, and
// not much less.
#include <gtest/gtest.h>

#include "core/text.h"
#include "tests/scenes/fluid_substances.h"

namespace thaum::fluid {
namespace {

/// Largest amount by which kinetic plus potential energy may exceed that of the start, as a share of the
/// potential energy that has been released.
constexpr double max_excess = 0.01;

void fall(flows::Weighing weighing, bool in_bowl, double viscosity) {
    SCOPED_TRACE(
        text(name_of(weighing), in_bowl ? " in the bowl" : " in the box", ", viscosity ", viscosity));
    auto fluid = flows::weighing_fluid(weighing, in_bowl, 16, viscosity).value();
    flows::EnergyBalance balance = flows::start_balance(fluid);
    for (int i = 0; i < 250; ++i) {
        enter(fluid, advance(fluid, flows::step), balance);
        ASSERT_LE(balance.excess, max_excess * balance.released) << "step " << i;
    }
    EXPECT_GT(balance.released, 1e-5);
}

TEST(FluidBuoyancy, NoFlowGainsMoreEnergyThanFallingReleases) {
    for (const bool in_bowl : {false, true})
        for (const flows::Weighing weighing : flows::weighings)
            for (const double viscosity : {0.0, 1e-4, 1e-2, 1.0}) fall(weighing, in_bowl, viscosity);
}

TEST(FluidBuoyancy, FallingSubstancesKeepMostOfTheReleasedEnergy) {
    for (const bool in_bowl : {false, true}) {
        auto fluid = flows::weighing_fluid(flows::Weighing::settling, in_bowl, 16, 0).value();
        flows::EnergyBalance balance = flows::start_balance(fluid);
        for (int i = 0; i < 60; ++i) enter(fluid, advance(fluid, flows::step), balance);
        EXPECT_GT(flows::kinetic_energy(fluid), 0.95 * balance.released) << in_bowl;
    }
}

/// The report accounts for all energy. Without forces and viscosity, all missing energy must be reported as
/// removed by rescaling (the solver slows the whole flow if a step has created energy).
TEST(FluidBuoyancy, TheReportAccountsForRemovedEnergy) {
    auto fluid = flows::weighing_fluid(flows::Weighing::sloshing, true, 16, 0).value();
    flows::EnergyBalance balance = flows::start_balance(fluid);
    int told = 0;
    for (int i = 0; i < 250; ++i) {
        const double before = flows::kinetic_energy(fluid) + flows::potential_energy(fluid);
        const StepReport report = advance(fluid, flows::step);
        enter(fluid, report, balance);
        ASSERT_GE(report.rescaled, 0);
        if (report.rescaled == 0) continue;
        ++told;
        const double after = flows::kinetic_energy(fluid) + flows::potential_energy(fluid);
        // When the solver has slowed the flow by rescaling its velocity, the energy equals that of the
        // previous step, up to the rounding of densities.
        EXPECT_NEAR(after, before, 1e-8) << i;
    }
    EXPECT_GT(told, 0);
    // Substances without weight never make the solver rescale the velocity.
    auto box = flows::start(flows::taylor_green_box(0), {Solver::thaum, 4}, 16).value();
    for (int i = 0; i < 20; ++i) EXPECT_EQ(advance(box, flows::step).rescaled, 0);
}

/// A standing wave in a layered box has the frequency N / sqrt(2). N is the buoyancy frequency: N^2 = -g
/// dw/dy with the gravity g, the relative weight w and the height y. In every half period all the wave's
/// energy becomes kinetic again. A former solver, whose buoyancy was of first order in time and whose flow
/// had divergence, amplified the wave 23 times in five periods.
TEST(FluidBuoyancy, AWaveInLayersIsNeitherAmplifiedNorDamped) {
    const double weight = 0.5, height = 0.02;
    Settings settings = flows::settings_of(flows::Flow{}, {Solver::thaum, 4}, 16);
    settings.substances = {Substance{.weight = weight}};
    auto fluid = make_fluid(settings).value();
    set_substance(fluid, 0, [](vec3 place) { return 1 - place.y; });
    const double frequency = std::sqrt(9.81 * weight / 2), speed = height * frequency;
    const flows::Flow vortex = flows::taylor_green_box(0);
    set_velocity(fluid, [&](vec3 place) { return speed * vortex.velocity(place, 0); });
    const double before = flows::kinetic_energy(fluid);
    const int steps = static_cast<int>(std::lround(10 * pi / frequency / flows::step));
    double late = 0, least = before;
    for (int i = 0; i < steps; ++i) {
        advance(fluid, flows::step);
        const double current = flows::kinetic_energy(fluid);
        if (i < steps / 10) least = std::min(least, current);
        if (i > steps * 9 / 10) late = std::max(late, current);
    }
    EXPECT_LT(least, 1e-2 * before);
    EXPECT_NEAR(late / before, 1, 0.08);
}

/// Diffusion raises the heavy substance without taking energy from the flow.
TEST(FluidBuoyancy, DiffusionOfLayersDoesNotBrakeTheFlow) {
    Settings settings = flows::settings_of(flows::Flow{}, {Solver::thaum, 4}, 16);
    settings.edges[0] = Edge::periodic;
    settings.substances = {Substance{.weight = 0.5, .diffusion = 1e-2}};
    auto fluid = make_fluid(settings).value();
    set_substance(fluid, 0, [](vec3 place) { return place.y < 0.5 ? 1 : 0; });
    set_velocity(fluid, [](vec3) { return vec3(0.5, 0, 0); });
    const double kinetic = flows::kinetic_energy(fluid), potential = flows::potential_energy(fluid);
    for (int i = 0; i < 60; ++i) advance(fluid, flows::step);
    EXPECT_GT(flows::potential_energy(fluid) - potential, 0.1 * kinetic);
    EXPECT_NEAR(flows::kinetic_energy(fluid) / kinetic, 1, 1e-4);
}

/// The flow that transports substances is free of divergence whether the solver is of order 2 or 4, so a
/// constant density stays constant.
TEST(FluidBuoyancy, AConstantDensityStaysConstantInAStirredBox) {
    for (const int order : {2, 4}) {
        Settings settings = flows::settings_of(flows::Flow{}, {Solver::thaum, order}, 16);
        settings.substances = {Substance{}};
        auto fluid = make_fluid(settings).value();
        set_substance(fluid, 0, [](vec3) { return 0.7; });
        for (int i = 0; i < 100; ++i) {
            const double turn = 0.1 * i;
            const vec3 way(-det::sin(turn), 0.3, det::cos(turn));
            push(fluid, {{0.5 + 0.25 * det::cos(turn), 0.5, 0.5 + 0.25 * det::sin(turn)}, 0.1, 1e-4 * way});
            advance(fluid, flows::step);
        }
        double worst = 0;
        each_cell(fluid.lattice, [&](int, int, int, std::size_t at) {
            worst = std::max(worst, std::abs(double{fluid.state.substances[0][at]} - 0.7));
        });
        EXPECT_LE(worst, 2e-5) << "order " << order;
    }
}

/// Work of the queued pushes per density, from the velocities before and after the step (m^5/s^2).
double work_of(const std::array<Samples, 3>& push, const std::array<Samples, 3>& before, const Fluid& after) {
    double work = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        each_cell(after.lattice, [&](int, int, int, std::size_t at) {
            work += 0.5 * double{push[axis][at]} *
                    (double{before[axis][at]} + double{after.state.velocity[axis][at]});
        });
    const double h = after.lattice.h;
    return work * h * h * h;
}

TEST(FluidBuoyancy, ALadleInAHeavyBrewGivesNoMoreThanItsWork) {
    for (const bool in_bowl : {false, true}) {
        auto fluid = flows::weighing_fluid(flows::Weighing::sloshing, in_bowl, 16, 0).value();
        for (int i = 0; i < 100; ++i) {
            const double turn = 0.1 * i;
            const vec3 way(-det::sin(turn), 0.3, det::cos(turn));
            push(fluid, {{0.5 + 0.2 * det::cos(turn), 0.3, 0.5 + 0.2 * det::sin(turn)}, 0.1, 1e-4 * way});
            const auto pushed = fluid.state.push, velocity = fluid.state.velocity;
            const double before = flows::kinetic_energy(fluid) + flows::potential_energy(fluid);
            ASSERT_EQ(advance(fluid, flows::step).substeps, 1);
            const double after = flows::kinetic_energy(fluid) + flows::potential_energy(fluid);
            const double work = work_of(pushed, velocity, fluid);
            ASSERT_LE(after - before, work + 1e-3 * std::abs(work) + 1e-8) << in_bowl << " step " << i;
        }
    }
}

}  // namespace
}  // namespace thaum::fluid
