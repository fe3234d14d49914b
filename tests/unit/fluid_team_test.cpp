// Tests that a step of the fluid gives the same bits with any number of threads that share its loops.
#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "core/team.h"
#include "tests/scenes/fluid_flows.h"

namespace thaum::fluid {
namespace {

/// Everything that a step may have changed.
std::vector<Samples> samples_of(const State& state) {
    std::vector<Samples> all = state.substances;
    all.insert(all.end(), state.velocity.begin(), state.velocity.end());
    all.insert(all.end(), {state.pressure, state.projected});
    return all;
}

/// Stirs and takes `steps` steps, each shared by `helpers` threads. The threads may come after the first
/// loops of a step, or leave and come back: that must not change the result either.
std::vector<Samples> after_steps(Fluid fluid, int steps, int helpers) {
    Team team;
    std::vector<Samples> result;
    for (int i = 0; i < steps; ++i) {
        flows::stir(fluid, i);
        team.open();
        std::vector<std::jthread> threads;
        for (int h = 0; h < helpers; ++h) threads.emplace_back([&] { team.help(); });
        while (helpers > 0 && !team.has_helpers()) std::this_thread::yield();
        advance(fluid, flows::step, &team);
        team.close();
    }
    return samples_of(fluid.state);
}

void expect_same_bits(const char* what, int steps, const std::function<Expected<Fluid>()>& make) {
    std::vector<Samples> alone;
    for (const int helpers : {0, 1, 2}) {
        auto fluid = make();
        ASSERT_TRUE(fluid) << what;
        const auto found = after_steps(std::move(*fluid), steps, helpers);
        if (helpers == 0)
            alone = found;
        else
            EXPECT_TRUE(found == alone) << what << " with " << helpers << " helpers";
    }
}

/// A fluid with a substance that spreads, and gravity that is not along an axis. If gravity has a component
/// along x, threads do not share the transport of substances that have weight.
Expected<Fluid> tilted(Settings settings, vec3 gravity) {
    settings.gravity = gravity;
    settings.substances = {Substance{.viscosity = 0.01, .weight = 0.1, .diffusion = 1e-4},
                           Substance{.weight = -0.1}};
    auto fluid = make_fluid(settings);
    if (!fluid) return fluid;
    pour(*fluid, 0, {0.4, 0.4, 0.5}, 0.2, 0.01);
    pour(*fluid, 1, {0.6, 0.5, 0.5}, 0.2, 0.01);
    return fluid;
}

// This test fails if a slice of a loop reads what another slice writes, or if a sum depends on the order in
// which threads finish. It takes 0.3 s.
TEST(FluidTeam, AnyNumberOfThreadsGivesTheSameBits) {
    const Cells cells{13, 11, 17};
    expect_same_bits("cauldron", 4, [] { return flows::brew(16); });
    for (const int order : {2, 4})
        expect_same_bits("box", 3, [&] {
            return tilted({.cells = cells, .h = 1.0 / 17, .order = order, .viscosity = 1e-3},
                          {order == 2 ? 2 : 0, -9, 3});
        });
    expect_same_bits("periodic", 3, [&] {
        return tilted({.cells = cells,
                       .h = 1.0 / 17,
                       .edges = {Edge::periodic, Edge::no_slip, Edge::periodic},
                       .order = 4,
                       .viscosity = 0.1,
                       .lid = 1},
                      {0, -9, 3});
    });
    expect_same_bits("slipping bowl", 3, [&] {
        return tilted({.cells = cells, .h = 1.0 / 17, .solid = flows::cauldron, .no_slip_at_solids = false},
                      {2, -9, 3});
    });
}

}  // namespace
}  // namespace thaum::fluid
