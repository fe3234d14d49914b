// Tests of transferring a flow to another grid: the error has the order of the kernel, and amounts are always
// conserved.
#include <gtest/gtest.h>

#include "fluid/resample.h"
#include "tests/scenes/fluid_flows.h"

namespace thaum::fluid {
namespace {

Settings settings_of(int n, Solver solver, bool bowl) {
    Settings s;
    s.solver = solver;
    s.cells = {n, n, n};
    s.h = 1.0 / n;
    s.substances = {{}, {.weight = 0.2}, {.diffusion = 1e-3}};
    if (bowl) s.solid = flows::solid_beyond_bowl;
    return s;
}

double blob(vec3 place, vec3 middle) {
    const vec3 apart = place - middle;
    return det::exp(-glm::dot(apart, apart) / 0.02);
}

Fluid filled(const Settings& settings) {
    Fluid fluid = *make_fluid(settings);
    const auto flow = flows::taylor_green_box(0);
    set_velocity(fluid, [&](vec3 p) { return flow.velocity(p, 0); });
    // The second substance lies in a corner, which is solid in a bowl.
    set_substance(fluid, 0, [](vec3 p) { return blob(p, {0.4, 0.5, 0.6}); });
    set_substance(fluid, 1, [](vec3 p) { return p.x < 0.15 && p.y < 0.15 && p.z < 0.15 ? 2.0 : 0.0; });
    return fluid;
}

Fluid taken_over(const Fluid& from, const Settings& settings) {
    Fluid to = *make_fluid(settings);
    resample_into(to, from);
    return to;
}

TEST(FluidResample, AmountsAreConservedInAllCases) {
    for (const Solver solver : {Solver::thaum, Solver::classic}) {
        for (const int n : {15, 32}) {
            for (const bool bowl : {false, true}) {
                const Fluid from = filled(settings_of(24, Solver::thaum, false));
                const Fluid to = taken_over(from, settings_of(n, solver, bowl));
                for (std::size_t s = 0; s < 3; ++s)
                    EXPECT_NEAR(amount(to, s), amount(from, s), 1e-6 * amount(from, s)) << n << ' ' << s;
                EXPECT_FALSE(to.state.asleep);
            }
        }
    }
}

TEST(FluidResample, TheFlowIsTheSameToTheThirdOrder) {
    const auto flow = flows::taylor_green_box(0);
    const auto exact = [&](vec3 p) { return flow.velocity(p, 0); };
    std::vector<double> errors;
    for (const int n : {8, 16, 32}) {
        const Fluid to =
            taken_over(filled(settings_of(n, Solver::thaum, false)), settings_of(40, Solver::thaum, false));
        errors.push_back(flows::relative_error(to, exact, exact));
    }
    EXPECT_LT(errors[1], 5e-3);
    EXPECT_GT(errors[0] / errors[1], 6);
    EXPECT_GT(errors[1] / errors[2], 6);
}

TEST(FluidResample, ThereAndBackThroughTheOtherSolver) {
    const Fluid from = filled(settings_of(32, Solver::thaum, false));
    Fluid back = taken_over(taken_over(from, settings_of(32, Solver::classic, false)),
                            settings_of(32, Solver::thaum, false));
    EXPECT_NEAR(energy(back), energy(from), 0.01 * energy(from));
    // The interpolated flow has some divergence, which one step removes without harm.
    const StepReport report = advance(back, flows::step);
    EXPECT_LT(report.divergence, 1e-5);
    EXPECT_NEAR(report.energy, energy(from), 0.01 * energy(from));
}

TEST(FluidResample, TheSameGridIsTheSameFlow) {
    const Settings settings = settings_of(16, Solver::thaum, true);
    Fluid from = filled(settings);
    advance(from, flows::step);
    const Fluid to = taken_over(from, settings);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t i = 0; i < from.state.velocity[axis].size(); ++i)
            ASSERT_NEAR(to.state.velocity[axis][i], from.state.velocity[axis][i], 1e-6);
    }
}

TEST(FluidMixing, IsOneMinusDeviationDividedByMean) {
    for (const bool bowl : {false, true}) {
        Fluid fluid = *make_fluid(settings_of(16, Solver::thaum, bowl));
        EXPECT_EQ(mixing(fluid, 0), 0);  // 0, because there is none of the substance
        set_substance(fluid, 0, [](vec3) { return 0.3; });
        EXPECT_NEAR(mixing(fluid, 0), 1, 1e-6);
        set_substance(fluid, 0, [](vec3 p) { return p.x < 0.5 ? 1.0 : 3.0; });
        EXPECT_NEAR(mixing(fluid, 0), 0.5, 1e-6);
        set_substance(fluid, 0, [](vec3 p) { return p.x < 0.1 && p.z < 0.6 ? 1.0 : 0.0; });
        // Where less than half holds the substance, its standard deviation exceeds its mean; the result is
        // kept at 0
        EXPECT_EQ(mixing(fluid, 0), 0);
    }
}

TEST(FluidMixing, FilledShareTellsHowFarABlobHasSpread) {
    for (const bool bowl : {false, true}) {
        Fluid fluid = *make_fluid(settings_of(16, Solver::thaum, bowl));
        const auto filled = [&](auto&& density) {
            set_substance(fluid, 0, density);
            return filled_share(fluid, fluid.state.substances[0]);
        };
        // 0, because the fluid contains none of the substance.
        EXPECT_EQ(filled_share(fluid, fluid.state.substances[0]), 0);
        EXPECT_NEAR(filled([](vec3) { return 0.3; }), 1, 1e-6);
        EXPECT_NEAR(filled([](vec3 p) { return p.x < 0.5 ? 0.7 : 0.0; }), 0.5, 1e-6);
        const double small = filled([](vec3 p) { return p.x < 0.5 && p.z < 0.5 && p.y < 0.5 ? 4.0 : 0.0; });
        // The substance fills an eighth of the box. Its share of the bowl is a little smaller, because a bowl
        // is narrower below.
        EXPECT_NEAR(small, 0.125, 0.03);
        EXPECT_EQ(mixing(fluid, 0), 0);
        const double even = filled([](vec3 p) { return p.x < 0.5 ? 1.0 : 3.0; });
        const double unmixed = 1 - mixing(fluid, 0);
        EXPECT_NEAR(even, 1 / (1 + unmixed * unmixed), 1e-6);
    }
}

}  // namespace
}  // namespace thaum::fluid
