// tools/bench/fluid_run.h: runs of a fluid that the fluid benchmarks time, and their rows.
#pragma once
#include <algorithm>

#include "core/hash.h"
#include "tests/scenes/fluid_flows.h"
#include "tools/bench/measure.h"

namespace thaum::bench {

/// A fluid whose steps are timed, and the results of its steps.
struct FluidRun {
    fluid::flows::Scheme scheme;
    int n;
    fluid::Fluid fluid;
    std::vector<double> us{};  ///< time of each whole step (us)
    /// Largest divergence after any step, times the cell size and divided by the largest speed.
    double divergence{};
    double steps{}, substeps{};
    fluid::StepReport last{};
};

inline void advance_timed(FluidRun& run, double dt) {
    const double us = us_of([&] { run.last = advance(run.fluid, dt); });
    // Excludes the shorter last step of a second, and fluids that have come to rest.
    if (dt == fluid::flows::step && run.last.cells > 0) run.us.push_back(us);
    run.divergence = std::max(run.divergence, run.last.divergence);
    run.steps += 1;
    run.substeps += run.last.substeps;
}

/// Advances all fluids until `end`, one step each in turn. The first step, which fills caches, is not timed.
inline void run_by_turns(std::vector<FluidRun>& runs, double end) {
    for (const double dt : fluid::flows::steps_until(end)) {
        for (FluidRun& run : runs) advance_timed(run, dt);
    }
    for (FluidRun& run : runs) {
        if (run.us.size() > 1) run.us.erase(run.us.begin());
    }
}

inline std::string solver_name(const fluid::flows::Scheme& scheme) {
    return scheme.solver == fluid::Solver::thaum ? "thaum" : "classic";
}

inline std::uint64_t velocity_hash(const fluid::Fluid& fluid) {
    std::uint64_t result = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        // Ghost samples, which lie outside of the fluid, are left out, because they follow from the other
        // samples.
        fluid::flows::each_component(fluid, axis,
                                     [&](double v, vec3) { result = hash_combine(result, hash_value(v)); });
    }
    return result;
}

/// Makes a row of the report with the values that the rows of all cases have: name, setting, hash and time.
/// The caller adds error, metrics and further settings.
inline Row row_of(const std::string& name, const FluidRun& run) {
    Row row{.area = "fluid",
            .name = name,
            .setting = {{"solver", solver_name(run.scheme)}, {"n", std::int64_t{run.n}}},
            .is_default = run.scheme.solver == fluid::Solver::thaum && run.scheme.order == 4 && run.n == 32,
            .hash = hex(velocity_hash(run.fluid))};
    if (run.scheme.solver == fluid::Solver::thaum)
        row.setting.emplace_back("order", std::int64_t{run.scheme.order});
    if (!run.us.empty()) row.time_us = times(run.us);
    return row;
}

}  // namespace thaum::bench
