// Benchmark of the fluid: run time against error of the solvers `thaum` and `classic` in flows with known
// solutions (fluid_flows.h), and stability under hostile input.
//
// Times are for one step of 16 ms with all its sub-steps, on one thread. Compared solvers are run
// alternately, step by step, so that other load on the machine affects all of them.
#include <array>
#include <cmath>
#include <utility>

#include "core/text.h"
#include "tests/scenes/fluid_attack.h"
#include "tests/scenes/fluid_substances.h"
#include "tools/bench/areas.h"
#include "tools/bench/fluid_run.h"

namespace thaum::bench {
namespace {

namespace flows = fluid::flows;
using flows::Flow;
using flows::Scheme;
using fluid::Fluid;
using fluid::Solver;
using fluid::StepReport;

constexpr std::array solvers{Scheme{Solver::thaum, 4}, Scheme{Solver::thaum, 2}, Scheme{Solver::classic}};

std::vector<FluidRun> runs_of(const std::function<Expected<Fluid>(const Scheme&, int n)>& make, int n,
                              Report& report) {
    std::vector<FluidRun> result;
    for (const Scheme& scheme : solvers) {
        auto fluid = make(scheme, n);
        if (fluid)
            result.push_back({.scheme = scheme, .n = n, .fluid = std::move(*fluid)});
        else
            report.faults.push_back(text("fluid: ", fluid.error().message));
    }
    return result;
}

std::vector<FluidRun> runs_of(const Flow& flow, int n, Report& report) {
    return runs_of([&](const Scheme& scheme, int cells) { return flows::start(flow, scheme, cells); }, n,
                   report);
}

/// Adds to the row: for the solver `classic` the time of each Gauss-Seidel sweep, and for `thaum` its time
/// relative to that of `classic`.
void add_time_metrics(const FluidRun& run, const std::vector<FluidRun>& all, Row& row) {
    row.metrics.emplace_back("substeps_per_step", run.substeps / run.steps);
    if (run.us.empty()) return;
    if (run.scheme.solver == Solver::classic) {
        // Diffusion sweeps three velocity components, and the pressure is solved twice.
        const double sweeps = 5.0 * run.fluid.settings.sweeps;
        const auto [nx, ny, nz] = run.fluid.lattice.cells;
        row.metrics.emplace_back("ns_per_cell_and_sweep",
                                 median(run.us) * 1e3 / (sweeps * double(nx) * double(ny) * double(nz)));
        return;
    }
    for (const FluidRun& other : all) {
        if (other.scheme.solver == Solver::classic && other.us.size() == run.us.size())
            row.metrics.emplace_back("ratio_to_classic", ratio(run.us, other.us));
    }
}

void add_flow(const Flow& flow, int n, const std::vector<std::pair<std::string, Value>>& setting,
              Report& report) {
    auto runs = runs_of(flow, n, report);
    run_by_turns(runs, flow.end);
    for (const FluidRun& run : runs) {
        Row row = row_of(flow.name, run);
        row.setting.insert(row.setting.end(), setting.begin(), setting.end());
        row.error = ErrorMeasure{flow.fades ? "velocity_l2_of_start" : "relative_l2_velocity",
                                 flows::error_at(flow, run.fluid, flow.end)};
        row.metrics.emplace_back("divergence", run.divergence);
        add_time_metrics(run, runs, row);
        report.rows.push_back(std::move(row));
    }
}

// ---- flows with known solutions --------------------------------------------------------------------------

void vortices(const Options& options, Report& report) {
    const std::vector<int> sizes = options.quick ? std::vector{16, 32} : std::vector{15, 16, 24, 32, 48, 64};
    for (const int n : sizes) add_flow(flows::taylor_green_moving(), n, {}, report);
    for (const int n : sizes) {
        if (!options.quick || n == 16) add_flow(flows::taylor_green_oblique(), n, {}, report);
    }
    constexpr std::array orientations{"xy", "yz", "zx"};
    for (const int n : sizes) {
        for (int first = 0; first < 3 && (!options.quick || n == 16); ++first)
            add_flow(flows::taylor_green_box(first), n,
                     {{"plane", std::string(orientations[static_cast<std::size_t>(first)])}}, report);
    }
}

void shear_layers(Report& report) {
    constexpr int n = 64;
    const Flow flow = flows::double_shear();
    const auto finer = flows::finer_double_shear(n);
    if (!finer) return report.faults.push_back(text("fluid: ", finer.error().message));
    auto runs = runs_of(flow, n, report);
    // The error is measured on the faces of the cells. One solver, `classic`, has no velocities there and is
    // left out.
    std::erase_if(runs, [](const FluidRun& run) { return run.scheme.solver == Solver::classic; });
    run_by_turns(runs, flow.end);
    for (const FluidRun& run : runs) {
        Row row = row_of(flow.name, run);
        row.error = ErrorMeasure{"relative_l2_velocity", flows::shear_error(run.fluid, *finer)};
        row.metrics.emplace_back("divergence", run.divergence);
        report.rows.push_back(std::move(row));
    }
}

void viscous(const Options& options, Report& report) {
    const std::vector<int> sizes = options.quick ? std::vector{16} : std::vector{16, 32, 64};
    for (const int n : sizes) add_flow(flows::couette_start(), n, {}, report);
    const int n = options.quick ? 16 : 32;
    for (const double ratio : {1e-3, 1e-2, 1e-1, 1.0, 1e1, 1e2, 1e3, 1e4})
        add_flow(flows::high_viscosity(ratio, n), n, {{"nu_dt_per_h2", ratio}}, report);
}

// ---- lid-driven cavity -----------------------------------------------------------------------------------

double change_since(const Fluid& fluid, fluid::Samples& before) {
    double most = 0;
    const auto& u = fluid.state.velocity[0];
    if (before.size() == u.size()) {
        for (std::size_t i = 0; i < u.size(); ++i)
            most = std::max(most, std::abs(double{u[i]} - double{before[i]}));
    } else {
        most = 1;
    }
    before = u;
    return most;
}

/// Runs until no velocity changes by more than `still` (m/s) in a second, or `max_s` (s) have passed.
/// Returns the time (s).
double run_until_steady(FluidRun& run, double still, double max_s) {
    fluid::Samples before;
    double time = 0;
    while (time < max_s && change_since(run.fluid, before) > still) {
        for (const double dt : flows::steps_until(1)) advance_timed(run, dt);
        time += 1;
    }
    return time;
}

void cavities(const Options& options, Report& report) {
    const std::vector<int> sizes = options.quick ? std::vector{16} : std::vector{16, 32, 64};
    for (const int n : sizes) {
        for (std::size_t which = 0; which < flows::cavity_reynolds.size(); ++which) {
            for (FluidRun& run : runs_of(flows::cavity_2d(which), n, report)) {
                const double took_s = run_until_steady(run, 1e-5, options.quick ? 20 : 150);
                Row row = row_of("cavity_2d", run);
                row.setting.emplace_back("reynolds", flows::cavity_reynolds[which]);
                row.error = ErrorMeasure{"rms_velocity_m_s", flows::cavity_error(run.fluid, which)};
                row.metrics = {{"divergence", run.divergence}, {"steady_after_s", took_s}};
                report.rows.push_back(std::move(row));
            }
        }
    }
}

// ---- substances ------------------------------------------------------------------------------------------

struct TurnedShape {
    const char* name;
    double (*density)(vec3 place);
};

/// One revolution of a shape by transport alone. The number of steps follows from the Courant number `cfl`;
/// they are not steps of 16 ms.
void add_turn(const TurnedShape& shape, int n, double cfl, Report& report) {
    auto runs = runs_of(
        [](const Scheme& scheme, int cells) { return make_fluid(flows::turning_settings(scheme, cells)); }, n,
        report);
    for (FluidRun& run : runs) {
        // Only one order of the flow's solver is run, because these rows measure transport.
        if (run.scheme.solver == Solver::thaum && run.scheme.order != 4) continue;
        set_velocity(run.fluid, flows::turning);
        set_substance(run.fluid, 0, shape.density);
        const double before = amount(run.fluid, 0);
        const int steps = flows::steps_of_turn(n, cfl);
        for (int i = 0; i < steps; ++i)
            run.us.push_back(us_of([&] { carry_substances(run.fluid, 1.0 / steps); }));
        const auto found = flows::densities_of(run.fluid, 0, shape.density, flows::inner_radius);
        const auto edge = flows::densities_of(run.fluid, 0, shape.density);
        Row row = row_of(shape.name, run);
        row.setting.emplace_back("cfl", cfl);
        row.error = ErrorMeasure{"relative_l2_density", found.error};
        row.metrics = {{"steps", steps},
                       {"error_to_edge", edge.error},
                       {"amount_change", amount(run.fluid, 0) / before - 1},
                       {"least_density", found.least},
                       {"most_density", found.most}};
        row.hash = hex(hash_bytes(std::as_bytes(std::span(run.fluid.state.substances[0]))));
        report.rows.push_back(std::move(row));
    }
}

void turns(const Options& options, Report& report) {
    const std::vector<int> sizes = options.quick ? std::vector{16, 32} : std::vector{16, 32, 64};
    for (const TurnedShape& shape : {TurnedShape{"gaussian_turn", flows::gaussian},
                                     TurnedShape{"slotted_sphere_turn", flows::slotted_sphere}}) {
        for (const int n : sizes) {
            for (const double cfl : {1.0, 4.0}) add_turn(shape, n, cfl, report);
        }
    }
}

/// LeVeque's flow, which deforms a shape and then returns all of it to its start. A relative error of 2 means
/// that none of the substance is where it should be.
void add_deformation(const TurnedShape& shape, int n, Report& report) {
    constexpr double cfl = 1;
    auto runs = runs_of([](const Scheme& scheme,
                           int cells) { return make_fluid(flows::deformation_settings(scheme, cells)); },
                        n, report);
    for (FluidRun& run : runs) {
        if (run.scheme.solver == Solver::thaum && run.scheme.order != 2) continue;
        set_substance(run.fluid, 0, shape.density);
        const double before = amount(run.fluid, 0);
        const int steps = flows::steps_of_deformation(n, cfl);
        double least = 0, most = 0;
        for (int i = 0; i < steps; ++i) {
            flows::set_deformation(run.fluid, i, steps);
            run.us.push_back(us_of([&] { carry_substances(run.fluid, flows::deformation_end / steps); }));
            const auto [low, high] = flows::range_of(run.fluid);
            least = std::min(least, low);
            most = std::max(most, high);
        }
        Row row = row_of("leveque", run);
        row.setting.emplace_back("shape", std::string(shape.name));
        row.error = ErrorMeasure{"relative_l1_density", flows::absolute_error(run.fluid, shape.density)};
        row.metrics = {{"steps", steps},
                       {"amount_change", amount(run.fluid, 0) / before - 1},
                       {"least_density", least},
                       {"most_density", most}};
        row.hash = hex(hash_bytes(std::as_bytes(std::span(run.fluid.state.substances[0]))));
        // The highest density of both shapes is 1, and transport must not exceed it.
        if (run.scheme.solver == Solver::thaum && !(least >= 0 && most <= 1 + 1e-5))
            report.faults.push_back(text("fluid leveque: ", shape.name, ", n = ", n, ": densities from ",
                                         least, " to ", most, ", not within 0 and 1"));
        report.rows.push_back(std::move(row));
    }
}

void deformations(const Options& options, Report& report) {
    const std::vector<int> sizes = options.quick ? std::vector{16} : std::vector{32, 64};
    for (const TurnedShape& shape :
         {TurnedShape{"gaussian", flows::deformed_gaussian}, TurnedShape{"sphere", flows::deformed_sphere}})
        for (const int n : sizes) add_deformation(shape, n, report);
}

// ---- heavy and light substances --------------------------------------------------------------------------

/// Largest allowed excess of kinetic plus potential energy over that at the start, as a share of the released
/// energy.
constexpr double max_excess = 0.01;

void add_weighing(flows::Weighing weighing, bool in_bowl, int n, double viscosity, Report& report) {
    auto fluid = flows::weighing_fluid(weighing, in_bowl, n, viscosity);
    if (!fluid) return report.faults.push_back(text("fluid: ", fluid.error().message));
    FluidRun run{.scheme = {Solver::thaum, in_bowl ? 2 : 4}, .n = n, .fluid = std::move(*fluid)};
    flows::EnergyBalance balance = flows::start_balance(run.fluid);
    for (const double dt : flows::steps_until(4)) {
        advance_timed(run, dt);
        enter(run.fluid, run.last, balance);
    }
    Row row = row_of("plume_energy", run);
    row.setting.emplace_back("flow", std::string(name_of(weighing)));
    row.setting.emplace_back("in", std::string(in_bowl ? "bowl" : "box"));
    row.setting.emplace_back("viscosity", viscosity);
    row.error = ErrorMeasure{"excess_energy_per_released", balance.excess / balance.released};
    row.metrics = {{"released_m5_s2", balance.released},
                   {"kinetic_per_released", flows::kinetic_energy(run.fluid) / balance.released},
                   {"rescaled_per_released", balance.rescaled / balance.released}};
    if (!(balance.excess <= max_excess * balance.released))
        report.faults.push_back(text("fluid plume_energy: ", name_of(weighing), in_bowl ? " in the bowl" : "",
                                     ", n = ", n, ", viscosity ", viscosity, ": energy above the start by ",
                                     balance.excess / balance.released, " of what was released"));
    report.rows.push_back(std::move(row));
}

void weighings(const Options& options, Report& report) {
    const std::vector<int> sizes = options.quick ? std::vector{16} : std::vector{16, 32};
    for (const int n : sizes)
        for (const flows::Weighing weighing : flows::weighings)
            for (const bool in_bowl : {false, true})
                for (const double viscosity : {0.0, 1e-3})
                    add_weighing(weighing, in_bowl, n, viscosity, report);
}

// ---- the cauldron ----------------------------------------------------------------------------------------

/// The load of a match: two ladles that stir and three substances in a bowl, one of them viscous. The time is
/// compared with that of an empty box with the same number of cells.
void cauldron(const Options& options, Report& report) {
    const int n = 32, steps = options.quick ? 60 : 600;
    std::vector<FluidRun> runs;
    for (const bool in_cauldron : {true, false}) {
        auto fluid = flows::brew(n, in_cauldron);
        if (!fluid) return report.faults.push_back(text("fluid: ", fluid.error().message));
        runs.push_back({.scheme = {Solver::thaum, in_cauldron ? 2 : 4}, .n = n, .fluid = std::move(*fluid)});
    }
    double iterations = 0;
    for (int i = 0; i < steps; ++i) {
        for (FluidRun& run : runs) {
            flows::stir(run.fluid, i);
            advance_timed(run, flows::step);
        }
        iterations += runs[0].last.pressure_iterations;
    }
    for (const FluidRun& run : runs) {
        const bool in_cauldron = &run == runs.data();
        Row row = row_of(in_cauldron ? "cauldron" : "cauldron_as_a_box", run);
        row.error = ErrorMeasure{"largest_divergence", run.divergence};
        row.metrics = {{"steps", steps}, {"substeps_per_step", run.substeps / run.steps}};
        if (in_cauldron) {
            row.metrics.emplace_back("pressure_iterations_per_step", iterations / steps);
            row.metrics.emplace_back("ratio_to_box", median(run.us) / median(runs[1].us));
        }
        report.rows.push_back(std::move(row));
    }
}

// ---- coming to rest, and attacks -------------------------------------------------------------------------

void rest(const Options& options, Report& report) {
    const int steps = options.quick ? 100 : 10'000;
    auto runs = runs_of(flows::resting, 16, report);
    run_by_turns(runs, steps * flows::step);
    for (const FluidRun& run : runs) {
        Row row = row_of("rest", run);
        const double pull = glm::length(run.fluid.settings.gravity) * flows::step;
        row.error = ErrorMeasure{"largest_velocity_per_g_dt", run.last.speed / pull};
        row.metrics.emplace_back("steps", steps);
        add_time_metrics(run, runs, row);
        report.rows.push_back(std::move(row));
    }
}

Expected<Fluid> attacked(const Scheme& scheme, int n) {
    Flow flow = flows::taylor_green_box(0);
    flow.settings.viscosity = 1e-3;
    return flows::start(flow, scheme, n);
}

/// Fluids that get one random push of up to 100 m/s in every step (hostile input).
void hostile_of(int n, const Options& options, Report& report) {
    const int steps = options.quick ? 50 : 2000;
    auto runs = runs_of(attacked, n, report);
    run_by_turns(runs, 20 * flows::step);
    for (FluidRun& run : runs) {
        const double calm = median(run.us);
        run.us.clear();
        run.divergence = run.steps = run.substeps = 0;
        Random random = random_stream(1, 0);
        double fallen_back = 0, grown = 0;
        for (int i = 0; i < steps; ++i) {
            push(run.fluid, flows::random_push(run.fluid.settings, 100, random));
            const double given = flows::energy_given(run.fluid);
            advance_timed(run, flows::step);
            fallen_back += run.last.fell_back ? 1 : 0;
            grown = std::max(grown, run.last.energy / given - 1);
        }
        Row row = row_of("hostile", run);
        row.error = ErrorMeasure{"largest_divergence", run.divergence};
        row.metrics = {{"steps", steps},
                       {"worst_step_us", percentile(run.us, 1)},
                       {"worst_step_per_calm", percentile(run.us, 1) / calm},
                       {"largest_energy_growth", grown},
                       {"fallen_back_share", fallen_back / steps},
                       {"substeps_per_step", run.substeps / run.steps}};
        report.rows.push_back(std::move(row));
    }
}

void hostile(const Options& options, Report& report) {
    for (const int n : {24, 32}) hostile_of(n, options, report);
}

// ---- stress test -----------------------------------------------------------------------------------------

constexpr std::uint64_t usual_strikes = 100'000;

struct StressCase {
    Scheme scheme;
    int n;
    bool bowl{};
};
constexpr std::array stress_cases{
    StressCase{{Solver::thaum, 4}, 24}, StressCase{{Solver::thaum, 2}, 24},
    StressCase{{Solver::classic}, 24},  StressCase{{Solver::thaum, 4}, 32},
    StressCase{{Solver::thaum, 2}, 32}, StressCase{{Solver::thaum, 2}, 32, true}};

/// Bounds for the fluid under hostile input, such as violent pushes. The method of the paper on which the
/// fluid is based (`classic`) guarantees neither zero divergence nor conserved energy and amounts, so it must
/// only stay finite.
fluid::AttackBounds bounds_of(const StressCase& stress_case) {
    if (stress_case.bowl) return {.divergence = fluid::bowl_divergence};
    if (stress_case.scheme.solver == Solver::thaum) return {};
    constexpr double any = std::numeric_limits<double>::infinity();
    return {.divergence = any, .energy_growth = any, .amount_drift = any};
}

/// Time of a step whose first run took `first` (us): the minimum over a few repetitions. In a long stress
/// test other programs interrupt some steps, but repeating a step always does the same work.
double minimum_us(fluid::Fluid& fluid, const fluid::State& before, double first) {
    constexpr int runs = 5;
    const fluid::State after = fluid.state;
    for (int i = 1; i < runs; ++i) {
        fluid.state = before;
        first = std::min(first, us_of([&] { advance(fluid, flows::step); }));
    }
    fluid.state = after;
    return first;
}

/// Minimum time of a few steps before the hostile input begins (us). All terms are active, but nothing moves
/// fast.
double calm_step_us(fluid::Fluid calm) {
    for (std::size_t s = 0; s < calm.settings.substances.size(); ++s)
        pour(calm, s, vec3(0.5, 0.5, 0.5), 0.3, 1e-3);
    std::vector<double> us;
    for (int i = 0; i < 21; ++i) {
        push(calm, {.place = vec3(0.5, 0.5, 0.5), .radius = 0.2, .impulse = vec3(1e-3, 0, 0)});
        us.push_back(us_of([&] { advance(calm, flows::step); }));
    }
    return median(us);
}

void stress_one(const StressCase& stress_case, std::uint64_t steps, Report& report) {
    const auto& [scheme, n, bowl] = stress_case;
    auto made = fluid::make_attack(scheme, n, 1, {.bowl = bowl});
    auto calm_one = fluid::make_attack(scheme, n, 1, {.bowl = bowl});
    if (!made || !calm_one)
        return report.faults.push_back(text("fluid: ", (made ? calm_one : made).error().message));
    fluid::Attack& attack = *made;
    FluidRun run{.scheme = scheme, .n = n, .fluid = {}};
    const double calm = calm_step_us(std::move(calm_one->fluid));
    double worst = 0;
    for (std::uint64_t i = 0; i < steps && attack.fault.empty(); ++i) {
        strike(attack);
        const fluid::State before = attack.fluid.state;
        run.us.push_back(us_of([&] { run.last = advance(attack.fluid, flows::step); }));
        if (run.us.back() > worst) worst = std::max(worst, minimum_us(attack.fluid, before, run.us.back()));
        judge(attack, run.last, bounds_of(stress_case));
        if (!attack.fault.empty())
            report.faults.push_back(text("fluid: ", solver_name(scheme), " order ", scheme.order,
                                         bowl ? " in a bowl" : "", ", n = ", n, ", step ", i, ": ",
                                         attack.fault));
    }
    run.fluid = std::move(attack.fluid);
    Row row = row_of("stress", run);
    row.setting.emplace_back("in", std::string(bowl ? "bowl" : "box"));
    row.metrics = {{"steps", static_cast<double>(run.us.size())},
                   {"worst_step_us", worst},
                   {"worst_step_per_calm", worst / calm},
                   {"largest_divergence", attack.worst_divergence},
                   {"largest_energy_growth", attack.worst_growth},
                   {"largest_amount_change", attack.worst_drift},
                   {"refused_pushes", attack.refused}};
    report.rows.push_back(std::move(row));
}

}  // namespace

void fluid_stress(const Options& options, Report& report) {
    for (const StressCase& stress_case : stress_cases)
        stress_one(stress_case, options.ticks.value_or(usual_strikes), report);
}

void fluid(const Options& options, Report& report) {
    vortices(options, report);
    shear_layers(report);
    viscous(options, report);
    cavities(options, report);
    turns(options, report);
    deformations(options, report);
    weighings(options, report);
    fluid_walls(options, report);
    cauldron(options, report);
    fluid_team(options, report);
    rest(options, report);
    hostile(options, report);
    fluid_hand(options, report);
}

}  // namespace thaum::bench
