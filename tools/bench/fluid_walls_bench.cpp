// Benchmark of the fluid between curved walls and in layers: error against known solutions, and time of a
// step. Only the solver `thaum` supports walls inside the box.
#include <utility>

#include "core/text.h"
#include "tests/scenes/fluid_bowls.h"
#include "tests/scenes/fluid_substances.h"
#include "tools/bench/areas.h"
#include "tools/bench/fluid_run.h"

namespace thaum::bench {
namespace {

namespace flows = fluid::flows;
using flows::Scheme;
using fluid::Fluid;
using fluid::Solver;

/// Row for the solver `thaum` alone, because `classic` has no walls inside the box. With such walls, `thaum`
/// has only second order of accuracy.
Row row_between_walls(const std::string& name, const FluidRun& run, double error, Report& report) {
    Row row = row_of(name, run);
    row.error = ErrorMeasure{"relative_l2_velocity", error};
    row.metrics = {{"divergence", run.divergence}, {"substeps_per_step", run.substeps / run.steps}};
    if (!(run.divergence <= 1e-6))
        report.faults.push_back(text("fluid / ", name, ": divergence ", run.divergence));
    return row;
}

using ErrorAtEnd = std::function<double(const Fluid&)>;

/// Advances a fluid between walls until `end` (s), at second order of accuracy. Adds its row to the report
/// and returns the row; null if there is no fluid.
Row* unforced_flow(const std::string& name, Expected<Fluid> fluid, int n, double end, const ErrorAtEnd& error,
                   Report& report) {
    if (!fluid) {
        report.faults.push_back(text("fluid: ", fluid.error().message));
        return nullptr;
    }
    std::vector<FluidRun> runs;
    runs.push_back({.scheme = {Solver::thaum, 2}, .n = n, .fluid = std::move(*fluid)});
    run_by_turns(runs, end);
    report.rows.push_back(row_between_walls(name, runs[0], error(runs[0].fluid), report));
    return &report.rows.back();
}

void spin_down(int n, const Scheme& scheme, Report& report) {
    double between = 0;
    const auto error = [&](const Fluid& fluid) {
        between = flows::bowl_error_between(fluid, flows::bowl_end);
        return flows::bowl_error(fluid, flows::bowl_end);
    };
    if (Row* row = unforced_flow("bowl_spin_down", flows::turning_bowl(scheme, n), n, flows::bowl_end, error,
                                 report))
        row->metrics.emplace_back("error_linear_between_faces", between);
}

void walled_flow(const flows::WalledFlow& flow, int n, const Scheme& scheme, Report& report) {
    auto fluid = flows::start(flow, scheme, n);
    if (!fluid) return report.faults.push_back(text("fluid: ", fluid.error().message));
    FluidRun run{.scheme = scheme, .n = n, .fluid = std::move(*fluid)};
    const auto force = flows::forces_of(flow, run.fluid);
    for (const double dt : flows::steps_until(flow.end)) {
        flows::drive(run.fluid, force, dt);
        advance_timed(run, dt);
    }
    const double error = flows::faces_error(run.fluid, flow.inside, flow.velocity);
    report.rows.push_back(row_between_walls(flow.name, run, error, report));
}

void slipping_bowls(const Options& options, Report& report) {
    for (const int n : options.quick ? std::vector{16, 32} : std::vector{16, 32, 48, 64})
        for (const double end : options.quick ? std::vector{1.0} : std::vector{1.0, 20.0})
            if (Row* row = unforced_flow("slipping_bowl_turn", flows::slipping_bowl(n), n, end,
                                         flows::turn_error, report))
                row->setting.emplace_back("after_s", end);
}

void layers(const Options& options, Report& report) {
    const int n = options.quick ? 16 : 32;
    for (const double ratio : {11.0, 100.0, 1e4, 1e6}) {
        const flows::ThickLayer layer{.ratio = ratio, .viscosity = 0.1};
        double crept = 0;
        const auto error = [&](const Fluid& fluid) {
            crept = flows::crept_out(fluid);
            return flows::layers_error(fluid, layer);
        };
        Row* row = unforced_flow("layers_of_viscosity", flows::layered_couette(layer, n), n,
                                 flows::thick_layer_end, error, report);
        if (row == nullptr) continue;
        row->setting.emplace_back("ratio", ratio);
        row->metrics.emplace_back("crept_out_share", crept);
    }
}

}  // namespace

void fluid_walls(const Options& options, Report& report) {
    const std::vector<int> sizes = options.quick ? std::vector{16, 32} : std::vector{16, 32, 64};
    constexpr Scheme scheme{Solver::thaum, 2};
    for (const int n : sizes) spin_down(n, scheme, report);
    for (const int n : sizes) walled_flow(flows::taylor_couette(), n, scheme, report);
    for (const int n : sizes) walled_flow(flows::bowl_vortex(), n, scheme, report);
    for (const int n : sizes)
        unforced_flow("ball_swirl", flows::swirling_ball(n), n, flows::swirl_end, flows::swirl_error, report);
    slipping_bowls(options, report);
    layers(options, report);
}

}  // namespace thaum::bench
