#include "fluid/fluid.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/text.h"
#include "fluid/detail/solver_apart.h"
#include "fluid/detail/staggered.h"
#include "fluid/detail/sums.h"
#include "fluid/fields.h"
#include "fluid/ghosts.h"
#include "fluid/sample.h"

namespace thaum::fluid {

struct Workspace {
    std::unique_ptr<StaggeredSolver> staggered;  ///< solver `thaum`; null for `classic`
    std::unique_ptr<SolverApart> apart;          ///< solver `classic`; null for `thaum`
};

void DeleteWorkspace::operator()(Workspace* workspace) const { delete workspace; }

namespace {

/// Makes the solver of `classic`; null if the program does not link it.
constinit MakeSolver make_classic = nullptr;

constexpr double min_h = 1e-6;  // smallest edge length of a cell (m)
constexpr double max_h = 1e3;
constexpr double max_lid = 1e3;      // largest speed of the lid, the moving wall (m/s)
constexpr double max_gravity = 1e3;  // largest magnitude of gravity (m/s^2)
constexpr double max_weight = 1e3;
constexpr double max_diffusion = 1e3;  // largest diffusion coefficient (m^2/s)
// One call of pour() may add at most the amount that one cell would hold at this density.
constexpr double max_density = 1e6;
constexpr int max_sweeps = 1000;

bool within(double value, double low, double high) { return value >= low && value <= high; }

std::optional<std::string> fault_of(const Substance& substance) {
    if (!within(substance.viscosity, 0, max_viscosity))
        return text("viscosity must be 0 to ", max_viscosity, " m^2/s");
    if (!within(substance.weight, -max_weight, max_weight))
        return text("weight must be from -", max_weight, " to ", max_weight);
    if (!within(substance.diffusion, 0, max_diffusion))
        return text("diffusion must be 0 to ", max_diffusion, " m^2/s");
    return {};
}

std::optional<std::string> fault_of(const Settings& settings) {
    if (settings.solver == Solver::classic && make_classic == nullptr)
        return text("this program has no solver `classic`; link it to thaum_classic");
    for (const int cells : settings.cells)
        if (cells < 1 || cells > max_cells) return text("cells must be 1 to ", max_cells, " along each axis");
    if (!within(settings.h, min_h, max_h)) return text("h must be ", min_h, " to ", max_h, " m");
    if (settings.order != 2 && settings.order != 4) return text("order must be 2 or 4");
    if (settings.sweeps < 1 || settings.sweeps > max_sweeps) return text("sweeps must be 1 to ", max_sweeps);
    if (!within(settings.viscosity, 0, max_viscosity))
        return text("viscosity must be 0 to ", max_viscosity, " m^2/s");
    if (!within(settings.lid, -max_lid, max_lid))
        return text("lid must be from -", max_lid, " to ", max_lid, " m/s");
    if (!(glm::length(settings.gravity) <= max_gravity))
        return text("gravity must be at most ", max_gravity, " m/s^2");
    if (settings.substances.size() > max_substances)
        return text("there can be at most ", max_substances, " substances");
    for (std::size_t i = 0; i < settings.substances.size(); ++i)
        if (const auto fault = fault_of(settings.substances[i]))
            return text("substance ", i + 1, ": ", *fault);
    return {};
}

/// Whether a velocity sample can differ from 0. On a wall, or on a face that a solid covers, it is always 0.
bool is_free(const Fluid& fluid, std::size_t axis, vec3 cell, std::size_t at) {
    if (fluid.settings.solver != Solver::thaum) return true;
    if (fluid.lattice.edges[axis] != Edge::periodic && cell[static_cast<int>(axis)] <= 0) return false;
    const Solids* solids = fluid.work->staggered->solids();
    return solids == nullptr || solids->open()[axis][at] > 0;
}

bool holds_fluid(const Fluid& fluid, std::size_t at) {
    const Solids* solids = fluid.work->staggered ? fluid.work->staggered->solids() : nullptr;
    return solids == nullptr || solids->holds_fluid(at);
}

/// Weight of a cell when something is spread round a place: a smooth function of the distance up to `radius`,
/// 0 beyond.
double kernel(const Fluid& fluid, vec3 place, vec3 at, double radius) {
    vec3 apart = at - place;
    for (int axis = 0; axis < 3; ++axis) {
        if (fluid.lattice.edges[static_cast<std::size_t>(axis)] != Edge::periodic) continue;
        const double length = fluid.lattice.h * fluid.lattice.cells[static_cast<std::size_t>(axis)];
        apart[axis] -= length * std::round(apart[axis] / length);
    }
    const double part = 1 - glm::dot(apart, apart) / (radius * radius);
    return part > 0 ? part * part : 0;
}

/// Range of cells along one axis that may lie within `radius` of a place: [low, high). Indices wrap where the
/// edge is periodic.
std::array<int, 2> kernel_range(const Fluid& fluid, std::size_t axis, vec3 place, double radius) {
    const int n = fluid.lattice.cells[axis];
    const double wide = radius / fluid.lattice.h + 1;
    if (fluid.lattice.edges[axis] == Edge::periodic) {
        const double at = into_box(fluid.lattice, place / fluid.lattice.h)[static_cast<int>(axis)];
        // The range has all cells if the place is too large to be wrapped, or the kernel is as wide as the
        // box.
        if (!(at >= 0 && at < n) || 2 * wide + 2 >= n) return {0, n};
        return {static_cast<int>(n + at - wide), static_cast<int>(n + at + wide + 1)};
    }
    const double at = place[static_cast<int>(axis)] / fluid.lattice.h;
    const auto inside = [n](double cell) {
        return static_cast<int>(std::clamp(cell, 0.0, static_cast<double>(n)));
    };
    return {inside(at - wide), inside(at + wide + 1)};
}

/// Distributes `total` by a smooth kernel over those samples within `radius` of a place for which `counts`
/// returns true. `first` is the position of the sample of cell (0, 0, 0) (cells). Returns false if there is
/// no such sample.
template <class Counts>
bool distribute(const Fluid& fluid, vec3 place, double radius, double total, vec3 first, Samples& samples,
                Counts&& counts) {
    const auto [x0, x1] = kernel_range(fluid, 0, place, radius);
    const auto [y0, y1] = kernel_range(fluid, 1, place, radius);
    const auto [z0, z1] = kernel_range(fluid, 2, place, radius);
    const auto [nx, ny, nz] = fluid.lattice.cells;
    const auto each = [&, x0 = x0, x1 = x1, y0 = y0, y1 = y1, z0 = z0, z1 = z1, nx = nx, ny = ny,
                       nz = nz](auto&& visit) {
        for (int z = z0; z < z1; ++z)
            for (int y = y0; y < y1; ++y)
                for (int x = x0; x < x1; ++x) {
                    const int i = x % nx, j = y % ny, k = z % nz;
                    const vec3 cell(i, j, k);
                    const double weight = kernel(fluid, place, fluid.lattice.h * (cell + first), radius);
                    const auto at = static_cast<std::size_t>(fluid.lattice.at(i, j, k));
                    if (weight > 0 && counts(cell, at)) visit(at, weight);
                }
    };
    double sum = 0;
    each([&](std::size_t, double weight) { sum += weight; });
    if (!(sum > 0)) return false;
    each([&](std::size_t at, double weight) { samples[at] += static_cast<float>(total * weight / sum); });
    return true;
}

double volume_of_cell(const Lattice& lattice) { return lattice.h * lattice.h * lattice.h; }

}  // namespace

ClassicIs::ClassicIs(MakeSolver make) { make_classic = make; }

Expected<void> check(const Settings& settings) {
    if (const auto fault = fault_of(settings)) return fail("fluid: " + *fault);
    return {};
}

Expected<Fluid> make_fluid(const Settings& settings) {
    if (const auto sound = check(settings); !sound) return sound.error();
    Fluid fluid{.settings = settings,
                .lattice = make_lattice(settings.cells, settings.h, settings.edges),
                .state = {},
                .work = std::unique_ptr<Workspace, DeleteWorkspace>(new Workspace)};
    fluid.state.velocity.fill(make_samples(fluid.lattice));
    fluid.state.push.fill(make_samples(fluid.lattice));
    fluid.state.pressure = make_samples(fluid.lattice);
    fluid.state.projected = make_samples(fluid.lattice);
    fluid.state.substances.assign(settings.substances.size(), make_samples(fluid.lattice));
    fluid.state.asleep = settings.lid == 0;
    if (settings.solver == Solver::thaum) {
        fluid.work->staggered = std::make_unique<StaggeredSolver>(settings, fluid.lattice);
        fluid.work->staggered->fill(settings, fluid.state.velocity);
    } else {
        fluid.work->apart = make_classic();
    }
    return fluid;
}

bool push(Fluid& fluid, const Push& push) {
    const double volume = volume_of_cell(fluid.lattice);
    if (!is_finite(push.place) || !is_finite(push.impulse) || !(push.radius >= 0) ||
        !std::isfinite(push.radius))
        return false;
    if (glm::length(push.impulse) > max_speed * volume) return false;
    const double radius = std::max(push.radius, 1.5 * fluid.lattice.h);
    bool taken = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double change = push.impulse[static_cast<int>(axis)] / volume;
        if (change == 0) continue;
        taken |= distribute(fluid, push.place, radius, change, fluid.place(axis), fluid.state.push[axis],
                            [&](vec3 cell, std::size_t at) { return is_free(fluid, axis, cell, at); });
    }
    if (!taken) return false;
    fluid.state.pushed = true;
    fluid.state.asleep = false;
    return true;
}

bool pour(Fluid& fluid, std::size_t substance, vec3 place, double radius, double amount) {
    if (substance >= fluid.state.substances.size() || !is_finite(place) || !(radius >= 0) ||
        !std::isfinite(radius))
        return false;
    const double volume = volume_of_cell(fluid.lattice);
    if (!(amount > 0) || !(amount <= max_density * volume)) return false;
    const double total = amount / volume;
    const bool poured = distribute(fluid, place, std::max(radius, 1.5 * fluid.lattice.h), total, vec3(0.5),
                                   fluid.state.substances[substance],
                                   [&](vec3, std::size_t at) { return holds_fluid(fluid, at); });
    if (!poured) return false;
    fill_ghosts(fluid.lattice, all_even, fluid.state.substances[substance]);
    fluid.state.asleep = false;
    return true;
}

StepReport advance(Fluid& fluid, double dt, Team* team) {
    if (fluid.state.asleep || !(dt > 0)) return {};
    dt = std::min(dt, 1.0);
    if (fluid.work->staggered) return fluid.work->staggered->step(fluid.settings, fluid.state, dt, team);
    return fluid.work->apart->step(fluid, dt);
}

void carry_substances(Fluid& fluid, double dt) {
    if (fluid.work->staggered)
        fluid.work->staggered->carry_substances(fluid.settings, fluid.state, dt);
    else
        fluid.work->apart->carry_substances(fluid, dt);
}

vec3 velocity_at(const Fluid& fluid, vec3 place) {
    if (!is_finite(place)) return vec3(0);
    const vec3 inside = fluid.lattice.h * into_box(fluid.lattice, place / fluid.lattice.h);
    vec3 result;
    for (std::size_t axis = 0; axis < 3; ++axis)
        result[static_cast<int>(axis)] = grid_of(fluid.lattice, fluid.state.velocity[axis], fluid.place(axis),
                                                 field::Kernel::linear)(inside)
                                             .value;
    return result;
}

void set_velocity(Fluid& fluid, const std::function<vec3(vec3)>& velocity) {
    for (std::size_t axis = 0; axis < 3; ++axis)
        each_cell(fluid.lattice, [&](int i, int j, int k, std::size_t at) {
            const vec3 cell(i, j, k);
            const vec3 value = velocity(fluid.lattice.h * (cell + fluid.place(axis)));
            fluid.state.velocity[axis][at] = static_cast<float>(value[static_cast<int>(axis)]);
        });
    const Solids* solids = fluid.work->staggered ? fluid.work->staggered->solids() : nullptr;
    for (std::size_t axis = 0; axis < 3 && solids != nullptr; ++axis)
        for (const CutFace& face : solids->cut_faces(axis))
            fluid.state.velocity[axis][face.at] =
                static_cast<float>(velocity(face.middle)[static_cast<int>(axis)]);
    refresh_after_edit(fluid);
}

void set_substance(Fluid& fluid, std::size_t substance, const std::function<double(vec3)>& density) {
    each_cell(fluid.lattice, [&](int i, int j, int k, std::size_t at) {
        const vec3 cell(i, j, k);
        const double value = density(fluid.lattice.h * (cell + 0.5));
        fluid.state.substances[substance][at] =
            static_cast<float>(holds_fluid(fluid, at) ? std::max(value, 0.0) : 0.0);
    });
    refresh_after_edit(fluid);
}

void refresh_after_edit(Fluid& fluid) {
    if (fluid.work->staggered)
        fluid.work->staggered->fill(fluid.settings, fluid.state.velocity);
    else
        fluid.work->apart->fill(fluid);
    fill_ghosts(fluid.lattice, all_even, fluid.state.pressure);
    fill_ghosts(fluid.lattice, all_even, fluid.state.projected);
    for (Samples& substance : fluid.state.substances) fill_ghosts(fluid.lattice, all_even, substance);
    fluid.state.asleep = false;
}

vec3 momentum(const Fluid& fluid) {
    vec3 result;
    for (std::size_t axis = 0; axis < 3; ++axis)
        result[static_cast<int>(axis)] =
            volume_of_cell(fluid.lattice) * total(fluid.lattice, fluid.state.velocity[axis]);
    return result;
}

double energy(const Fluid& fluid) {
    const auto* shares = fluid.work->staggered ? fluid.work->staggered->energy_shares() : nullptr;
    Team alone;
    return volume_of_cell(fluid.lattice) *
           velocity_norms(whole_rows(fluid.lattice), fluid.state.velocity, shares, alone).half_square;
}

double amount(const Fluid& fluid, std::size_t substance) {
    return volume_of_cell(fluid.lattice) * total(fluid.lattice, fluid.state.substances[substance]);
}

double mixing(const Fluid& fluid, std::size_t substance) {
    const Samples& density = fluid.state.substances[substance];
    double count = 0, sum = 0, square = 0;
    const auto each_wet = [&](auto&& visit) {
        each_cell(fluid.lattice, [&](int, int, int, std::size_t at) {
            if (holds_fluid(fluid, at)) visit(double{density[at]});
        });
    };
    each_wet([&](double value) {
        sum += value;
        ++count;
    });
    if (!(sum > 0)) return 0;
    const double mean = sum / count;
    each_wet([&](double value) { square += (value - mean) * (value - mean); });
    return std::max(0.0, 1 - std::sqrt(square / count) / mean);
}

double filled_share(const Fluid& fluid, const Samples& density) {
    double count = 0, sum = 0, square = 0;
    each_cell(fluid.lattice, [&](int, int, int, std::size_t at) {
        if (!holds_fluid(fluid, at)) return;
        const double value = density[at];
        sum += value;
        square += value * value;
        ++count;
    });
    return sum > 0 ? sum * sum / (count * square) : 0;
}

}  // namespace thaum::fluid
