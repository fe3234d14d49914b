#include "fluid/detail/staggered.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fluid/detail/buoyancy.h"
#include "fluid/detail/part_of_row.h"
#include "fluid/detail/pressure.h"
#include "fluid/detail/sums.h"
#include "fluid/floats8.h"
#include "fluid/ghosts.h"
#include "fluid/sample.h"

namespace thaum::fluid {
namespace {

// Runge-Kutta of third order in which each stage uses only the previous one. With stages at 0.4, 1/2 and 1
// this scheme is unique. The classic scheme of fourth order has its first stage at 1/2. The value 0.4 is
// chosen to keep the phase of an advected wave: for a wave whose phase advances by t (rad) in a step, the
// classic scheme lags by t^5 / 120, this one by two thirds of that. It is stable up to t = 2.79.
constexpr double place_1 = 0.4;
constexpr double weight_3 = place_1 / 6 / (1.5 * place_1 - place_1 * place_1 - 0.25);
constexpr double weight_4 = 1.0 / 3 - weight_3 * place_1;
constexpr double weight_2 = (1.0 / 6 - weight_3 * (0.5 - place_1)) / place_1;
constexpr double weight_1 = 1 - weight_2 - weight_3 - weight_4;

/// Largest distance that the flow may move in a sub-step, summed over the axes (cells). At order 4 the phase
/// of the fastest wave, which is 3.5 cells long, then advances by 1.37 times this number (rad).
constexpr double max_carried = 2.0;
/// Largest nu dt / h^2 for which the Runge-Kutta stages include viscosity; larger values are solved
/// implicitly. At this limit the shortest wave decays at a rate of 16 * 0.15 = 2.4 per step, which is still
/// stable.
constexpr double max_explicit = 0.15;
/// Largest nu dt / h^2 of the base fluid for which implicit viscosity treats a step in one pass over the
/// axes, instead of two passes of half the length. At 0.66 one pass doubles the error beside a curved wall.
constexpr double max_one_pass = 0.25;
/// Limit of nu dt / h^2 where viscosity varies or there are solids. At this value the fluid already moves as
/// a rigid body within a step. With a larger one, float could no longer represent its coupling to the fluid
/// around it. At 9e6 a thick lump beside thin fluid in a bowl gained energy without end.
constexpr double rigid = 1e5;
/// Largest accepted divergence with solids, times h and divided by the largest velocity component.
constexpr double max_divergence_with_solids = 9.5e-7;
constexpr int max_iterations = 40;
/// Largest accepted divergence without solids, times h and divided by the largest velocity component. A
/// larger one is rounding error. It comes from a velocity that viscosity almost removed, or from the corners
/// where a moving wall meets one at rest. The pressure is then solved again, `solves_more` times at most.
constexpr double max_divergence_without_solids = 1e-6;
constexpr int solves_more = 2;
/// Largest number of sub-steps by which substances are transported after a semi-Lagrangian step. It is lower
/// than usual to limit the processor time. In most such steps the flow is so fast that no affordable number
/// would be enough.
constexpr int transports_of_fall_back = 7;
/// Flow slower than this comes to rest unless a force accelerates it (m/s).
constexpr double rest_speed = 1e-6;

/// Whether a sample of a row is not 0. Samples are tested in groups of eight, the last of which may extend
/// beyond the end of the row.
bool any_in(const Row& row, const float* samples) {
    auto any = load(samples + row.at) != zero8;
    for (std::ptrdiff_t i = 8; i < row.count; i += 8) any |= load(samples + row.at + i) != zero8;
    int lanes = 0;
    for (std::ptrdiff_t lane = 0; lane < 8; ++lane) lanes |= any[lane];
    return lanes != 0;
}

double sum_of_largest(const Rows& rows, const std::array<Samples, 3>& velocity) {
    double sum = 0;
    for (const Samples& component : velocity) sum += largest(rows, component);
    return sum;
}

}  // namespace

StaggeredSolver::StaggeredSolver(const Settings& settings, const Lattice& lattice)
    : lattice_(lattice),
      order_(settings.solid ? 2 : settings.order),
      solids_(settings.solid ? std::make_unique<Solids>(
                                   lattice, settings.solid,
                                   settings.no_slip_at_solids ? min_open : open_least_where_slipping)
                             : nullptr),
      rows_(solids_ ? solids_->rows() : whole_rows(lattice)),
      pressure_(lattice, order_),
      momentum_(lattice, order_, solids_.get()),
      viscosity_(lattice, solids_.get(), settings.solid),
      diffusion_(lattice, order_),
      face_flow_(make_face_flow(lattice)),
      transport_(make_transport_scratch(lattice)),
      potential_(make_samples(lattice)),
      mixed_property_(make_samples(lattice)) {
    if (solids_ && !settings.no_slip_at_solids) continuation_.emplace(lattice, *solids_);
    if (solids_) face_apertures_ = make_face_apertures(lattice, solids_->open());
    pushed_rows_.fill(rows_);
    for (auto* velocity : {&force_, &stage_, &second_stage_, &sum_}) velocity->fill(make_samples(lattice));
    packed_.resize(static_cast<std::size_t>(lattice.cells[0]) * static_cast<std::size_t>(lattice.cells[1]) *
                   static_cast<std::size_t>(lattice.cells[2]));
}

void StaggeredSolver::fill(const Settings& settings, Velocity& velocity) const {
    if (solids_) solids_->clear_closed_faces(velocity);
    fill_sides(settings, velocity);
}

void StaggeredSolver::fill_sides_of(Layers layers, Velocity& velocity, int depth) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
        fill_ghosts(rows_, layers, ghost_rules_of_velocity(lattice_, axis), velocity[axis], depth);
}

void StaggeredSolver::fill_sides(const Settings& settings, Velocity& velocity, int depth) const {
    each_slice(*team_, layers(), [&](Layers slice, unsigned) { fill_sides_of(slice, velocity, depth); });
    fill_lid(settings, velocity);
}

/// Adds the speed of the lid, a moving wall, to the ghost cells beyond it.
void StaggeredSolver::fill_lid(const Settings& settings, Velocity& velocity) const {
    if (settings.lid == 0 || lattice_.edges[1] != Edge::no_slip) return;
    // Beyond the lid (the moving wall) the velocity is odd relative to the lid's, so twice the lid's speed is
    // added in the ghost cells.
    const auto twice = static_cast<float>(2 * settings.lid);
    for (int k = -ghosts; k < lattice_.cells[2] + ghosts; ++k) {
        for (int j = lattice_.cells[1]; j < lattice_.cells[1] + ghosts; ++j) {
            float* row = velocity[0].data() + lattice_.at(-ghosts, j, k);
            for (std::ptrdiff_t i = 0; i < lattice_.cells[0] + 2 * ghosts; ++i) row[i] += twice;
        }
    }
}

bool StaggeredSolver::viscosity_varies(const Settings& settings) const {
    return std::any_of(settings.substances.begin(), settings.substances.end(),
                       [](const Substance& s) { return s.viscosity > 0; });
}

bool StaggeredSolver::has_weight(const Settings& settings) {
    return settings.gravity != vec3(0) && std::any_of(settings.substances.begin(), settings.substances.end(),
                                                      [](const Substance& s) { return s.weight != 0; });
}

/// Number of sub-steps of equal length with which the flow moves at most max_carried cells in each.
///
/// Where the fluid slips along solids, advection on faces that a solid covers in part reads velocities that
/// continue the flow around, not the faces' own. So the velocity of such a face is weighted here by the share
/// that no solid covers. In a small opening the velocity, or the force, may be much larger than around it,
/// and without the weight it would require sub-steps that the flow does not need.
double StaggeredSolver::substeps_wanted(const Settings& settings, const Velocity& velocity, double dt) const {
    const auto wanted = [&](double flow, double push) {
        const double carried = flow + std::abs(settings.lid) + dt * push;
        return std::ceil(carried * dt / (lattice_.h * max_carried));
    };
    const double most = wanted(start_norms_.sum_of_largest, has_force_ ? sum_of_largest(rows_, force_) : 0);
    if (most <= 1 || !continuation_) return most;
    double flow = 0, push = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Samples& open = solids_->open()[axis];
        flow += max_product(rows_, open, velocity[axis]);
        if (has_force_) push += max_product(rows_, open, force_[axis]);
    }
    return wanted(flow, push);
}

/// Sums all forces in force_. `share` (1/s) times a queued change of velocity (push) is an acceleration.
void StaggeredSolver::gather_forces(const Settings& settings, const State& state, double share) {
    has_force_ = state.pushed || solids_ != nullptr;
    const auto factor = static_cast<float>(share);
    each_slice(*team_, layers(), [&](Layers slice, unsigned) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            clear(rows_, slice, force_[axis]);
            if (!state.pushed) continue;
            const float* push = state.push[axis].data();
            each_row(pushed_rows_[axis], slice, [&](Row row) {
                for (std::ptrdiff_t i = 0; i < row.count; i += 8)
                    store_within_row(force_[axis].data() + row.at + i, factor * load(push + row.at + i),
                                     row.count - i);
            });
        }
    });
    add_buoyancy(settings, state);
    if (!solids_) return;
    each_slice(*team_, layers(),
               [&](Layers slice, unsigned) { subtract_gradient(rows_, slice, 2, state.pressure, force_); });
}

/// Sets mixed_property_ to a property of the mixture, such as its viscosity: `base` plus, for each substance,
/// density times the member `part` of Substance. Fills the rows with fluid and their ghosts.
void StaggeredSolver::mix_property(const Settings& settings, const State& state, double base,
                                   double Substance::*part) {
    each_slice(*team_, layers(), [&](Layers slice, unsigned) {
        each_row(rows_, slice, [&](Row row) {
            for (std::ptrdiff_t i = row.at; i < row.at + row.count; i += 8) {
                Floats8 sum = zero8 + static_cast<float>(base);
                for (std::size_t s = 0; s < state.substances.size(); ++s)
                    sum += static_cast<float>(settings.substances[s].*part) *
                           load(state.substances[s].data() + i);
                store(mixed_property_.data() + i, sum);
            }
        });
        fill_ghosts(rows_, slice, all_even, mixed_property_);
    });
}

/// Adds the weight of the substances to the forces. The mean of every level (cells at one height) is left
/// out, because pressure balances it. Layered fluid therefore stays at rest exactly.
void StaggeredSolver::add_buoyancy(const Settings& settings, const State& state) {
    if (!has_weight(settings)) return;
    mix_property(settings, state, 0, &Substance::weight);
    has_force_ = true;
    add_gravity(settings);
}

/// Replaces the buoyancy at the start of a sub-step by the buoyancy half a sub-step later. gather_forces has
/// left the weight at the start in mixed_property_.
void StaggeredSolver::predict_buoyancy(const Settings& settings, const State& state, double dt) {
    if (!has_weight(settings)) return;
    each_slice(*team_, layers(), [&](Layers slice, unsigned) {
        predict_weight(rows_, slice, state.velocity, solids_ ? &solids_->open() : nullptr, 0.5 * dt,
                       mixed_property_, potential_);
    });
    each_slice(*team_, layers(), [&](Layers slice, unsigned) {
        each_row(rows_, slice, [&](Row row) {
            for (std::ptrdiff_t i = row.at; i < row.at + row.count; i += 8)
                store(mixed_property_.data() + i,
                      load(potential_.data() + i) - load(mixed_property_.data() + i));
        });
        fill_ghosts(rows_, slice, all_even, mixed_property_);
    });
    add_gravity(settings);
}

/// Adds the force of gravity on the weight of the substances, which mixed_property_ holds, to the forces.
void StaggeredSolver::add_gravity(const Settings& settings) {
    add_weight(rows_, order_, solids_ ? &solids_->open() : nullptr, settings.gravity, mixed_property_, force_,
               *team_);
}

/// Ends a Runge-Kutta stage: removes the velocity's divergence if there are no solids, and fills the ghost
/// cells.
void StaggeredSolver::end_stage(const Settings& settings, Velocity& velocity) {
    if (!solids_) {
        project(velocity);
        fill_lid(settings, velocity);
        return;
    }
    if (continuation_) continuation_->apply(velocity);
    // With solids the order is 2, and a stage reads only one layer of ghosts.
    fill_sides(settings, velocity, 1);
}

/// Velocity at the start of a step as advection reads it. Where the fluid slips along solids, this is a copy
/// in second_stage_ that continues the flow into them; the second stage overwrites it.
const StaggeredSolver::Velocity& StaggeredSolver::carrying_velocity(const Settings& settings,
                                                                    const Velocity& velocity) {
    if (!continuation_) return velocity;
    for (std::size_t axis = 0; axis < 3; ++axis)
        std::ranges::copy(velocity[axis], second_stage_[axis].begin());
    continuation_->apply(second_stage_);
    fill_sides(settings, second_stage_, 1);
    return second_stage_;
}

/// Removes the divergence from sum_, the sum of the Runge-Kutta stages, and makes it the new velocity.
void StaggeredSolver::end_step(const Settings& settings, State& state, double dt, StepReport& report) {
    if (solids_) {
        const auto found =
            solids_->project(sum_, state.projected, max_divergence_with_solids, max_iterations, *team_);
        report.pressure_iterations += found.iterations;
        report.divergence = found.divergence;
        const auto per_dt = static_cast<float>(1 / dt);
        const int stride = static_cast<int>(lattice_.stride[2]);
        each_slice(*team_, Split(*team_, lattice_.cells[2] + 2 * ghosts), [&](Layers slice, unsigned) {
            // Ghost cells included, which every layer of the array has.
            for (int i = slice.first * stride; i < slice.end * stride; ++i)
                state.pressure[static_cast<std::size_t>(i)] +=
                    per_dt * state.projected[static_cast<std::size_t>(i)];
        });
        fill_sides(settings, sum_);
    } else {
        end_stage(settings, sum_);
        ++report.pressure_iterations;
    }
    std::swap(state.velocity, sum_);
}

/// Finds the rows of fluid in which a push (velocity that is to be added) is not 0.
void StaggeredSolver::find_pushed_rows(const State& state) {
    each_slice(*team_, Split(*team_, static_cast<int>(rows_.rows.size())), [&](Layers slice, unsigned) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const float* push = state.push[axis].data();
            for (auto r = static_cast<std::size_t>(slice.first); r < static_cast<std::size_t>(slice.end);
                 ++r) {
                const Row row = rows_.rows[r];
                const bool pushed = state.pushed && row.count > 0 && any_in(row, push);
                pushed_rows_[axis].rows[r] = {row.at, pushed ? row.count : 0};
            }
        }
    });
}

/// Sets the pushes (velocities to be added) to 0 after a step. They lie only in the rows found by
/// find_pushed_rows, because none is ever added in a solid.
void StaggeredSolver::clear_pushes(State& state) const {
    if (!state.pushed) return;
    for (std::size_t axis = 0; axis < 3; ++axis) clear(pushed_rows_[axis], state.push[axis]);
    state.pushed = false;
}

/// Work that the pushes (velocities added by the caller) do over a whole step if the fluid has this velocity
/// (m^2/s^2, summed over cells).
double StaggeredSolver::work_of_pushes(const State& state, const Velocity& velocity) const {
    if (!state.pushed) return 0;
    double work = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        work += continuation_
                    ? dot(pushed_rows_[axis], state.push[axis], velocity[axis], solids_->open()[axis])
                    : dot(pushed_rows_[axis], state.push[axis], velocity[axis]);
    return work;
}

/// Slows the flow if the sub-step gave it more kinetic energy than was available. Available are the energy
/// before the sub-step, whose velocity is in sum_, the energy that substances released by sinking, and the
/// work of the pushes at the mean of old and new velocity. Excess energy has two sources. With solids, the
/// stages use the pressure of the previous sub-step, whose force may do work. And the work of buoyancy is not
/// exactly the potential energy that the transport of the substances releases.
///
/// `share` is this sub-step's share of the pushes. `sunk` is the released potential energy (m^2/s^2,
/// summed over cells).
void StaggeredSolver::limit_energy(const Settings& settings, State& state, double share, double sunk,
                                   StepReport& report) {
    current_norms_.reset();
    if (settings.lid != 0 || (!solids_ && !has_weight(settings))) return;
    const VelocityNorms found = velocity_norms(rows_, state.velocity, energy_shares(), *team_);
    const double is = found.half_square;
    const double most =
        std::max(0.0, start_norms_.half_square + sunk + 0.5 * share * work_of_pushes(state, sum_));
    const double by_pushes = 0.5 * share * work_of_pushes(state, state.velocity);
    if (is <= most + by_pushes) {
        current_norms_ = found;
        return;
    }
    // If the flow is slowed by a factor f, its energy `is` becomes f^2 times as large. The available energy
    // has a part that does not depend on the new velocity, `most`, and a part that becomes f times as large,
    // `by_pushes`. The flow shall have just the available energy: f^2 * is == most + f * by_pushes.
    const double root = std::sqrt(std::max(0.0, by_pushes * by_pushes + 4 * is * most));
    const double factor = std::clamp((by_pushes + root) / (2 * is), 0.0, 1.0);
    for (Samples& u : state.velocity)
        for (float& value : u) value *= static_cast<float>(factor);
    report.divergence *= factor;
    report.rescaled += (1 - factor * factor) * is * lattice_.h * lattice_.h * lattice_.h;
}

void StaggeredSolver::run_stage(const RungeKuttaStage& stage, double viscosity) {
    // At order 4 a slice begins with three layers of interpolation that the slice before it needs, too.
    const Split split(*team_, lattice_.cells[2], order_ == 4 ? 4 : 12);
    each_slice(*team_, split,
               [&](Layers slice, unsigned seat) { momentum_.run_stage(stage, viscosity, slice, seat); });
    if (continuation_) continuation_->correct(stage);
}

void StaggeredSolver::substep(const Settings& settings, State& state, double dt, double whole,
                              StepReport& report) {
    predict_buoyancy(settings, state, dt);
    const double nu = viscosity_in_stages_ ? settings.viscosity : 0;
    const auto* force = has_force_ ? &force_ : nullptr;
    const auto& start = state.velocity;
    const auto part = [dt](double share) { return static_cast<float>(share * dt); };
    run_stage({carrying_velocity(settings, start), start, force, &stage_, sum_, part(place_1), part(weight_1),
               true},
              nu);
    end_stage(settings, stage_);
    run_stage({stage_, start, force, &second_stage_, sum_, part(0.5), part(weight_2), false}, nu);
    end_stage(settings, second_stage_);
    run_stage({second_stage_, start, force, &stage_, sum_, part(1), part(weight_3), false}, nu);
    end_stage(settings, stage_);
    run_stage({stage_, start, force, nullptr, sum_, 0, part(weight_4), false}, nu);
    if (!viscosity_in_stages_) diffuse_velocity(settings, state, dt);
    end_step(settings, state, dt, report);
    const double sunk = transport_after_substep(settings, state, dt);
    limit_energy(settings, state, dt / whole, sunk, report);
    ++report.substeps;
}

/// Applies implicit viscosity, for one sub-step, to the velocity in sum_.
void StaggeredSolver::diffuse_velocity(const Settings& settings, const State& state, double dt) {
    if (settings.viscosity <= 0 && !viscosity_varies(settings)) return;
    const bool lid_alone = lattice_.edges[0] != Edge::no_slip && lattice_.edges[2] != Edge::no_slip;
    if (!solids_ && !viscosity_varies(settings) && (settings.lid == 0 || lid_alone)) {
        diffusion_.diffuse(settings.viscosity * dt / (lattice_.h * lattice_.h), settings.lid, sum_);
        return;
    }
    mix_property(settings, state, settings.viscosity, &Substance::viscosity);
    const double thickest = rigid * lattice_.h * lattice_.h / dt;
    const bool varies = viscosity_varies(settings);
    if (!varies)
        for (float& viscosity : mixed_property_)
            viscosity = std::min(viscosity, static_cast<float>(thickest));
    const double ratio = settings.viscosity * dt / (lattice_.h * lattice_.h);
    viscosity_.diffuse({.viscosity = &mixed_property_,
                        .thickest = varies ? thickest : std::numeric_limits<double>::infinity(),
                        .varies = varies,
                        .force = has_force_ ? &force_ : nullptr,
                        .no_slip_at_solids = settings.no_slip_at_solids,
                        .lid = settings.lid,
                        .dt = dt,
                        .passes = ratio > max_one_pass ? 2 : 1},
                       sum_, *team_);
}

/// Transports the substances. Returns the potential energy that they released by sinking, without the
/// energy that diffusion added (m^2/s^2, summed over cells).
double StaggeredSolver::transport_substances(const Velocity& before, const Velocity& after,
                                             const Settings& settings, State& state, double dt,
                                             int max_substeps) {
    if (state.substances.empty()) return 0;
    const auto* open = solids_ ? &solids_->open() : nullptr;
    set_face_flow(lattice_, before, after, solids_ ? &face_apertures_ : nullptr, dt, face_flow_, *team_,
                  order_);
    double sunk = 0;
    for (std::size_t s = 0; s < state.substances.size(); ++s) {
        const Substance& substance = settings.substances[s];
        Samples& density = state.substances[s];
        const vec3 pull = substance.weight * settings.gravity;
        const double lifted = substance.diffusion > 0 ? lifted_by_diffusion(rows_, open, pull, density) : 0;
        const TransportReport did =
            transport(lattice_, face_flow_,
                      {.diffusion = substance.diffusion, .max_substeps = max_substeps, .moved_along = pull},
                      density, transport_, *team_);
        sunk += lattice_.h * glm::dot(pull, did.moved) + dt * did.spread * substance.diffusion * lifted;
    }
    return sunk;
}

void StaggeredSolver::carry_substances(const Settings& settings, State& state, double dt) {
    transport_substances(state.velocity, state.velocity, settings, state, dt);
}

/// Transports the substances by the velocities before a sub-step (in sum_) and after it. Returns the
/// potential energy that they released by sinking, as transport_substances does.
double StaggeredSolver::transport_after_substep(const Settings& settings, State& state, double dt,
                                                int max_substeps) {
    return transport_substances(sum_, state.velocity, settings, state, dt, max_substeps);
}

/// A semi-Lagrangian step of any length: each sample takes the value from the place where its fluid was
/// before. Energy that the interpolation adds is removed.
void StaggeredSolver::semi_lagrangian(const Settings& settings, State& state, double dt, double whole,
                                      StepReport& report) {
    const double before = start_norms_.half_square;
    for (std::size_t axis = 0; axis < 3; ++axis) carry_back(lattice_, state.velocity, axis, dt, sum_[axis]);
    if (solids_) solids_->clear_closed_faces(sum_);
    const double after = velocity_norms(rows_, sum_, energy_shares(), *team_).half_square;
    const auto factor = static_cast<float>(after > before ? std::sqrt(before / after) : 1);
    const auto step = static_cast<float>(dt);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        float* u = sum_[axis].data();
        const float* f = force_[axis].data();
        each_row(lattice_, [&](std::ptrdiff_t at) {
            for (std::ptrdiff_t i = at; i < at + lattice_.cells[0]; ++i)
                u[i] = factor * u[i] + (has_force_ ? step * f[i] : 0);
        });
    }
    if (solids_) solids_->clear_closed_faces(sum_);
    diffuse_velocity(settings, state, dt);
    end_step(settings, state, dt, report);
    const double sunk = transport_after_substep(settings, state, dt, transports_of_fall_back);
    limit_energy(settings, state, dt / whole, sunk, report);
    report.fell_back = true;
}

/// Stops a flow slower than rest_speed if no force drives it. The fluid falls asleep unless a substance still
/// diffuses.
void StaggeredSolver::come_to_rest(const Settings& settings, State& state, double dt, double speed) const {
    if (settings.lid != 0) return;
    bool spreads = false;
    for (std::size_t s = 0; s < state.substances.size(); ++s)
        spreads =
            spreads || (settings.substances[s].diffusion > 0 && largest(rows_, state.substances[s]) > 0);
    if (has_force_ && dt * sum_of_largest(rows_, force_) >= rest_speed) {
        // A force keeps the fluid awake only if it makes the flow faster; strong viscosity may cancel its
        // effect. sum_ holds the velocity before the last sub-step.
        const double before = largest(rows_, sum_);
        if (spreads || before >= rest_speed || speed > before) return;
    }
    for (Samples& u : state.velocity) std::fill(u.begin(), u.end(), 0.0F);
    if (spreads) return;
    for (Samples* pressure : {&state.pressure, &state.projected})
        std::fill(pressure->begin(), pressure->end(), 0.0F);
    state.asleep = true;
}

/// Reduces the divergence that rounding has left in a box without solids, by solving the pressure again if it
/// is too large. The report gets the largest remaining divergence (1/s).
void StaggeredSolver::clear_divergence(const Settings& settings, State& state, StepReport& report) {
    const double most = max_divergence_without_solids * report.speed / lattice_.h;
    for (int more = 0;; ++more) {
        report.divergence = largest_divergence(state.velocity);
        if (report.divergence <= most || more == solves_more) return;
        end_stage(settings, state.velocity);
        ++report.pressure_iterations;
    }
}

/// Gathers the forces and returns how many sub-steps the remaining time `left` needs, at least 1.
double StaggeredSolver::plan_substeps(const Settings& settings, State& state, double left, double whole,
                                      int allowed) {
    start_norms_ =
        current_norms_ ? *current_norms_ : velocity_norms(rows_, state.velocity, energy_shares(), *team_);
    gather_forces(settings, state, 1 / whole);
    const double wanted = std::max(1.0, substeps_wanted(settings, state.velocity, left));
    if (!solids_ || wanted <= allowed) return wanted;
    // If the flow hit a wall in a shorter step, the pressure is very high. Over this longer step it would
    // push much too hard, so it is set to 0. The step is then of first order only, but stable.
    std::fill(state.pressure.begin(), state.pressure.end(), 0.0F);
    gather_forces(settings, state, 1 / whole);
    return std::max(1.0, substeps_wanted(settings, state.velocity, left));
}

StepReport StaggeredSolver::step(const Settings& settings, State& state, double dt, Team* team) {
    StepReport report;
    team_ = team != nullptr ? team : &alone_;
    double left = dt;
    current_norms_.reset();
    find_pushed_rows(state);
    while (left > 0) {
        const int allowed = max_substeps - report.substeps;
        const double wanted = plan_substeps(settings, state, left, dt, allowed);
        if (wanted > allowed) {
            // The semi-Lagrangian step covers all remaining time at once, because doing some sub-steps first
            // gains little. Relative error after twenty steps that follow a push, compared with fine steps:
            // where four sub-steps would be needed, 0.021 (0.015 with those four); where five would be
            // needed, 0.053 (0.059 with four sub-steps first); where ten would be needed, no difference.
            viscosity_in_stages_ = false;
            semi_lagrangian(settings, state, left, dt, report);
            break;
        }
        const double sub = left / wanted;
        viscosity_in_stages_ = !solids_ && !viscosity_varies(settings) &&
                               settings.viscosity * sub <= max_explicit * lattice_.h * lattice_.h;
        substep(settings, state, sub, dt, report);
        left = wanted > 1 ? left - sub : 0;
    }
    clear_pushes(state);
    report.cells = static_cast<std::int64_t>(packed_.size()) * (report.substeps + (report.fell_back ? 1 : 0));
    const VelocityNorms is =
        current_norms_ ? *current_norms_ : velocity_norms(rows_, state.velocity, energy_shares(), *team_);
    report.energy = is.half_square * lattice_.h * lattice_.h * lattice_.h;
    report.speed = is.largest;
    if (!solids_) clear_divergence(settings, state, report);
    if (report.speed > 0) report.divergence *= lattice_.h / report.speed;
    if (report.speed < rest_speed) come_to_rest(settings, state, dt, report.speed);
    team_ = &alone_;
    return report;
}

}  // namespace thaum::fluid
