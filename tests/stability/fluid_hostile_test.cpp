// The fluid with hostile input (tests/scenes/fluid_attack.h) in a short run; `thaum bench fluid --stress` is
// the long one.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/scenes/fluid_attack.h"

namespace thaum::fluid {
namespace {

using flows::Scheme;

Attack attacked(const Scheme& scheme, std::uint64_t seed, int steps, const AttackPlan& plan,
                const AttackBounds& bounds) {
    auto attack = make_attack(scheme, 12, seed, plan).value();
    for (int i = 0; i < steps && attack.fault.empty(); ++i) {
        strike(attack);
        judge(attack, advance(attack.fluid, flows::step), bounds);
    }
    return attack;
}

TEST(FluidHostile, ThaumWithstandsPushesJumpsAndInvalidNumbers) {
    for (const int order : {2, 4}) {
        for (const std::uint64_t seed : {1U, 2U, 3U}) {
            const Attack attack = attacked({Solver::thaum, order}, seed, 150, {}, {});
            EXPECT_EQ(attack.fault, "") << "order " << order << " seed " << seed;
            EXPECT_GT(attack.refused, 0);
        }
    }
}

TEST(FluidHostile, ThaumWithstandsThemInABowl) {
    for (const bool slips : {false, true}) {
        for (const std::uint64_t seed : {1U, 2U, 3U}) {
            const Attack attack = attacked({Solver::thaum, 2}, seed, 300, {.bowl = true, .slips = slips},
                                           {.divergence = bowl_divergence});
            EXPECT_EQ(attack.fault, "") << seed << (slips ? " slips" : "");
            EXPECT_GT(attack.refused, 0);
        }
    }
}

TEST(FluidHostile, TheBaselineWithstandsThemToo) {
    // The baseline solver (Stam's stable fluids) guarantees neither zero divergence nor conserved amounts.
    const AttackBounds loose{.divergence = 10, .energy_growth = 10, .amount_drift = 1e9};
    for (const std::uint64_t seed : {1U, 2U, 3U})
        EXPECT_EQ(attacked({Solver::classic}, seed, 150, {}, loose).fault, "");
}

/// Relative difference of the velocities of two fluids.
double difference(const Fluid& one, const Fluid& other) {
    double square = 0, apart = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto &a = one.state.velocity[axis], &b = other.state.velocity[axis];
        for (std::size_t i = 0; i < a.size(); ++i) {
            apart += double{a[i] - b[i]} * double{a[i] - b[i]};
            square += double{b[i]} * double{b[i]};
        }
    }
    return std::sqrt(apart / square);
}

/// After a push for which a step would need more sub-steps than allowed, the solver falls back to a
/// semi-Lagrangian step. Twenty steps later the flow must be close to that with fine steps.
TEST(FluidHostile, ASemiLagrangianStepIsCloseToFineSteps) {
    constexpr int fine = 16, steps = 20;
    flows::Flow flow = flows::taylor_green_box(0);
    flow.settings.viscosity = 1e-3;
    Random random = random_stream(3, 0);
    double sum = 0;
    int pushes = 0;
    for (int i = 0; i < 4; ++i) {
        auto coarse = flows::start(flow, {Solver::thaum, 4}, 24);
        auto exact = flows::start(flow, {Solver::thaum, 4}, 24);
        ASSERT_TRUE(coarse.has_value() && exact.has_value());
        const Push strong = flows::random_push(coarse->settings, 50, random);
        ASSERT_TRUE(push(*coarse, strong) && push(*exact, strong));
        if (!advance(*coarse, flows::step).fell_back) continue;
        for (int k = 1; k < steps; ++k) advance(*coarse, flows::step);
        for (int k = 0; k < steps * fine; ++k) advance(*exact, flows::step / fine);
        EXPECT_NEAR(energy(*coarse), energy(*exact), 0.02 * energy(*exact));
        sum += difference(*coarse, *exact);
        ++pushes;
    }
    ASSERT_GE(pushes, 2);
    EXPECT_LE(sum / pushes, 0.04);
}

/// Viscosity stops the flow. The velocity must then be exactly zero, and not fade into subnormal numbers,
/// which are slow. Diffusion of the substance continues.
TEST(FluidHostile, StoppedFlowIsExactlyZeroWhileASubstanceDiffuses) {
    Settings settings = flows::settings_of(flows::Flow{}, {Solver::thaum, 4}, 12);
    settings.substances = {Substance{.diffusion = 1e-4}};
    auto fluid = make_fluid(settings).value();
    ASSERT_TRUE(pour(fluid, 0, vec3(0.5), 0.2, 1e-3));
    ASSERT_TRUE(push(fluid, {.place = vec3(0.5), .radius = 0.2, .impulse = vec3(1e-3, 0, 0)}));
    EXPECT_GT(advance(fluid, flows::step).speed, 0);
    fluid.settings.viscosity = 1;
    StepReport report;
    for (int i = 0; i < 30; ++i) report = advance(fluid, flows::step);
    EXPECT_EQ(report.speed, 0);
    EXPECT_GT(report.cells, 0);
    const auto densest = [&] { return *std::ranges::max_element(fluid.state.substances[0]); };
    const float before = densest();
    for (int i = 0; i < 30; ++i) advance(fluid, flows::step);
    EXPECT_LT(densest(), before);
}

TEST(FluidHostile, AnyStepUpToASecond) {
    for (const Solver solver : {Solver::thaum, Solver::classic}) {
        auto attack = make_attack({solver, 4}, 12, 5).value();
        for (const double dt : {1e-9, 1e-4, 0.016, 0.3, 1.0}) {
            push(attack.fluid, flows::random_push(attack.fluid.settings, 1e4, attack.random));
            const StepReport report = advance(attack.fluid, dt);
            EXPECT_TRUE(all_finite(attack.fluid)) << dt;
            EXPECT_LE(report.substeps + (report.fell_back ? 1 : 0), max_substeps);
        }
    }
}

Settings bowl_of(const Substance& substance, int n) {
    Settings settings;
    settings.cells = {n, n, n};
    settings.h = 1.0 / n;
    settings.substances = {substance};
    settings.solid = flows::solid_beyond_bowl;
    return settings;
}

/// A lump falls so fast in a bowl that each step needs many transport sub-steps. The fluid must come to rest
/// without gaining energy.
TEST(FluidHostile, AHeavyThickLumpComesToRest) {
    for (const double viscosity : {1.0, max_viscosity}) {
        Settings settings = bowl_of({.viscosity = viscosity, .weight = 10}, 16);
        settings.gravity = {0, -100, 0};
        auto fluid = make_fluid(settings).value();
        ASSERT_TRUE(pour(fluid, 0, vec3(0.5, 0.8, 0.5), 0.1, 10));
        StepReport report;
        for (int i = 0; i < 25; ++i) report = advance(fluid, flows::step);
        EXPECT_TRUE(all_finite(fluid)) << viscosity;
        // Bound: the energy that the lump can release by falling.
        EXPECT_LT(report.energy, 10 * 10 * 100 * 2 * flows::bowl_radius) << viscosity;
    }
}

/// The pressure of a violent step must never accelerate the flow, even without viscosity or when the flow is
/// almost at rest.
TEST(FluidHostile, ABowlLeftAloneGainsNoEnergy) {
    for (const double viscosity : {0.0, 1e-6, 1e-3, 0.1, 10.0}) {
        auto fluid = make_fluid(bowl_of({}, 16)).value();
        Random random = random_stream(3, 0);
        fluid.settings.viscosity = 1e-3;
        for (int i = 0; i < 10; ++i) {
            push(fluid, flows::random_push(fluid.settings, 300, random));
            advance(fluid, flows::step);
        }
        fluid.settings.viscosity = viscosity;
        double before = energy(fluid);
        ASSERT_GT(before, 0);
        for (int i = 0; i < 300; ++i) {
            advance(fluid, flows::step);
            const double current = energy(fluid);
            ASSERT_LE(current, before * (1 + 1e-6)) << viscosity << " step " << i;
            before = current;
        }
    }
}

/// A lump with the largest viscosity, many times denser than intended, stirred by a ladle.
TEST(FluidHostile, ABrewThickerThanAnythingStaysFinite) {
    auto fluid = make_fluid(bowl_of({.viscosity = max_viscosity}, 20)).value();
    ASSERT_TRUE(pour(fluid, 0, vec3(0.6, 0.5, 0.5), 0.1, 10));
    double fastest = 0;
    for (int i = 0; i < 80; ++i) {
        const double turn = 0.1 * i;
        const vec3 way(-det::sin(turn), 0, det::cos(turn));
        push(fluid, {vec3(0.5 + 0.25 * det::cos(turn), 0.5, 0.5 + 0.25 * det::sin(turn)), 0.1, 1e-3 * way});
        fastest = std::max(fastest, advance(fluid, flows::step).speed);
    }
    EXPECT_TRUE(all_finite(fluid));
    EXPECT_LT(fastest, 20);
}

TEST(FluidHostile, ImpossibleSettingsAreRefused) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const auto refused = [](auto change) {
        Settings settings;
        settings.cells = {8, 8, 8};
        change(settings);
        return !make_fluid(settings).has_value();
    };
    EXPECT_FALSE(refused([](Settings&) {}));
    EXPECT_TRUE(refused([](Settings& s) { s.cells[1] = 0; }));
    EXPECT_TRUE(refused([](Settings& s) { s.cells[2] = 1 << 20; }));
    EXPECT_TRUE(refused([](Settings& s) { s.order = 3; }));
    EXPECT_TRUE(refused([](Settings& s) { s.sweeps = 0; }));
    EXPECT_TRUE(refused([](Settings& s) { s.viscosity = -1; }));
    EXPECT_TRUE(refused([](Settings& s) { s.viscosity = 1e7; }));
    EXPECT_TRUE(refused([](Settings& s) { s.viscosity = nan; }));
    EXPECT_TRUE(refused([](Settings& s) { s.h = 0; }));
    EXPECT_TRUE(refused([](Settings& s) { s.h = nan; }));
    EXPECT_TRUE(refused([](Settings& s) { s.gravity.y = nan; }));
    EXPECT_TRUE(refused([](Settings& s) { s.lid = nan; }));
    EXPECT_TRUE(refused([](Settings& s) { s.substances.resize(4); }));
}

}  // namespace
}  // namespace thaum::fluid
