// Benchmark of fluid steps whose loops two threads share (core/team.h), beside the same steps on one thread.
// The two take turns, step by step, and must give the same bits. On a machine of one processor, or whose
// processors share their arithmetic units, the second thread gains little.
#include <array>
#include <cmath>

#include "core/jobs.h"
#include "core/team.h"
#include "core/text.h"
#include "core/threads.h"
#include "tools/bench/areas.h"
#include "tools/bench/fluid_run.h"

namespace thaum::bench {
namespace {

namespace flows = fluid::flows;
using fluid::Solver;

/// The same flow computed twice: by two threads together, and by one thread for comparison.
struct SharedFlow {
    const char* row;
    flows::Scheme scheme;
    int n;
    bool stirred;
    Expected<fluid::Fluid> (*make)(const SharedFlow&);
};

Expected<fluid::Fluid> brewed(const SharedFlow& flow) { return flows::brew(flow.n); }
Expected<fluid::Fluid> vortex(const SharedFlow& flow) {
    return flows::start(flows::taylor_green_moving(), flow.scheme, flow.n);
}

constexpr std::array shared_flows{
    SharedFlow{"cauldron_two_threads", {Solver::thaum, 2}, 32, true, brewed},
    SharedFlow{"cauldron_two_threads", {Solver::thaum, 2}, 64, true, brewed},
    SharedFlow{"box_two_threads", {Solver::thaum, 4}, 32, false, vortex},
    SharedFlow{"box_two_threads", {Solver::thaum, 2}, 32, false, vortex},
};

/// Advances a fluid by a step that a thread of `jobs` shares, as in a match.
void advance_shared(FluidRun& run, Jobs& jobs, Team& team, const Jobs::Ticket& help) {
    const double us = us_of([&] {
        team.open();
        jobs.run(help);
        run.last = advance(run.fluid, flows::step, &team);
        team.close();
    });
    help.wait();
    run.us.push_back(us);
    run.divergence = std::max(run.divergence, run.last.divergence);
    run.steps += 1;
    run.substeps += run.last.substeps;
}

void add_shared(const SharedFlow& flow, int steps, Report& report) {
    std::vector<FluidRun> runs;
    for (int i = 0; i < 2; ++i) {
        auto fluid = flow.make(flow);
        if (!fluid) return report.faults.push_back(text("fluid: ", fluid.error().message));
        runs.push_back({.scheme = flow.scheme, .n = flow.n, .fluid = std::move(*fluid)});
    }
    Team team;
    Jobs jobs(1);
    const auto help = Jobs::prepare([&team] { team.help(); });
    FluidRun &one = runs[0], &two = runs[1];
    for (int i = 0; i < steps; ++i) {
        for (FluidRun& run : runs)
            if (flow.stirred) flows::stir(run.fluid, i);
        advance_timed(one, flows::step);
        advance_shared(two, jobs, team, help);
    }
    Row row = row_of(flow.row, two);
    row.is_default = false;
    row.error = ErrorMeasure{"largest_divergence", two.divergence};
    row.metrics = {{"processors", processors()},
                   {"substeps_per_step", two.substeps / two.steps},
                   {"one_thread_us", median(one.us)},
                   {"ratio_to_one_thread", ratio(two.us, one.us)}};
    if (velocity_hash(one.fluid) != velocity_hash(two.fluid))
        report.faults.push_back(text("fluid ", flow.row, ", n = ", flow.n, ": two threads give other bits"));
    report.rows.push_back(std::move(row));
}

}  // namespace

void fluid_team(const Options& options, Report& report) {
    for (const SharedFlow& flow : shared_flows)
        if (!options.quick || flow.n < 64)
            add_shared(flow, options.quick ? 60 : flow.n < 64 ? 600 : 120, report);
}

}  // namespace thaum::bench
