#include "fluid/classic/classic.h"

#include <algorithm>
#include <cmath>

#include "fluid/detail/solver_apart.h"
#include "fluid/detail/sums.h"

namespace thaum::fluid {
namespace {

/// Rule for the values of a field in its ghost cells, the cells around the box that stand for what lies
/// beyond its sides. This solver uses only the layer of them next to the box.
struct Border {
    /// For each axis, value of a ghost cell beyond a wall, divided by that of the nearest inner cell: 1 or
    /// -1.
    std::array<float, 3> factor{1, 1, 1};
    /// Velocity that is added in the ghost cells above the top of y: twice that of the moving wall there
    /// (m/s).
    float lid{};
};

Border border_of_scalar() { return {}; }

Border border_of_velocity(const Settings& settings, std::size_t component) {
    Border result;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const bool through = axis == component;
        if (through || settings.edges[axis] == Edge::no_slip) result.factor[axis] = -1;
    }
    // The wall lies half-way between the inner cell and the ghost cell, so the mean of their velocities must
    // be the speed of the wall.
    if (component == 0 && settings.edges[1] == Edge::no_slip)
        result.lid = static_cast<float>(2 * settings.lid);
    return result;
}

/// One row of cells along an axis, described so that the ghost cells at its two ends can be filled.
struct RowEnds {
    std::ptrdiff_t last;    ///< index distance from the first cell of the row to the last
    std::ptrdiff_t stride;  ///< index distance from a cell to the next
    bool periodic;
    float factor, lid;

    void fill(float* first) const {
        float* const end = first + last;
        first[-stride] = periodic ? *end : factor * *first;
        end[stride] = periodic ? *first : factor * *end + lid;
    }
};

/// Fills the ghost cells of a field, one axis after another. The rows along an axis include the ghost cells
/// of the axes filled before, so that the ghost cells at edges and corners of the box get right values, too.
void fill_border(const Lattice& lattice, const Border& border, Samples& samples) {
    const auto [nx, ny, nz] = lattice.cells;
    const auto sides = [&](std::size_t axis) {
        const auto stride = lattice.stride[axis];
        return RowEnds{(lattice.cells[axis] - 1) * stride, stride, lattice.edges[axis] == Edge::periodic,
                       border.factor[axis], axis == 1 ? border.lid : 0.0F};
    };
    float* const field = samples.data();
    const RowEnds x = sides(0), y = sides(1), z = sides(2);
    for (int k = 0; k < nz; ++k) {
        for (int j = 0; j < ny; ++j) x.fill(field + lattice.at(0, j, k));
    }
    for (int k = 0; k < nz; ++k) {
        for (int i = -1; i <= nx; ++i) y.fill(field + lattice.at(i, 0, k));
    }
    for (int j = -1; j <= ny; ++j) {
        for (int i = -1; i <= nx; ++i) z.fill(field + lattice.at(i, j, 0));
    }
}

/// Solves x = (source + share * sum of the six neighbours of x) / (own + 6 share) by Gauss-Seidel sweeps.
/// `own` is 1 for diffusion and 0 for pressure.
void relax(const Lattice& lattice, const Border& border, int sweeps, float own, float share,
           const Samples& source, Samples& x) {
    const auto ny = lattice.stride[1], nz = lattice.stride[2];
    const int n = lattice.cells[0];
    const float inverse = 1 / (own + 6 * share);
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        each_row(lattice, [&](std::ptrdiff_t first) {
            const float* const b = source.data() + first;
            float* const c = x.data() + first;
            float west = c[-1];
            for (int i = 0; i < n; ++i) {
                // The neighbour that was written last is added last. Then only this addition, and not the
                // whole sum, must wait for the previous iteration.
                const float others = c[i + 1] + c[i - ny] + c[i + ny] + c[i - nz] + c[i + nz];
                west = (b[i] + share * (others + west)) * inverse;
                c[i] = west;
            }
        });
        fill_border(lattice, border, x);
    }
}

/// Implicit diffusion: finds the field that, diffused backwards in time, gives the old field.
void diffuse(const Fluid& fluid, const Border& border, double coefficient, double dt, ClassicScratch& scratch,
             Samples& samples) {
    if (!(coefficient > 0)) return;
    const double share = coefficient * dt / (fluid.lattice.h * fluid.lattice.h);
    scratch.source = samples;
    relax(fluid.lattice, border, fluid.settings.sweeps, 1, static_cast<float>(share), scratch.source,
          samples);
}

/// Writes -h^2 times the divergence: the right-hand side of the pressure solve.
void write_divergence(const Fluid& fluid, Samples& result) {
    const auto [sx, sy, sz] = fluid.lattice.stride;
    const int n = fluid.lattice.cells[0];
    const auto scale = static_cast<float>(-0.5 * fluid.lattice.h);
    each_row(fluid.lattice, [&, sy = sy, sz = sz](std::ptrdiff_t first) {
        const float* const u = fluid.state.velocity[0].data() + first;
        const float* const v = fluid.state.velocity[1].data() + first;
        const float* const w = fluid.state.velocity[2].data() + first;
        float* const to = result.data() + first;
        for (int i = 0; i < n; ++i)
            to[i] = scale * (u[i + 1] - u[i - 1] + v[i + sy] - v[i - sy] + w[i + sz] - w[i - sz]);
    });
}

void subtract_gradient(Fluid& fluid, const Samples& pressure) {
    const auto scale = static_cast<float>(0.5 / fluid.lattice.h);
    const int n = fluid.lattice.cells[0];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto next = fluid.lattice.stride[axis];
        each_row(fluid.lattice, [&](std::ptrdiff_t first) {
            const float* const p = pressure.data() + first;
            float* const u = fluid.state.velocity[axis].data() + first;
            for (int i = 0; i < n; ++i) u[i] -= scale * (p[i + next] - p[i - next]);
        });
    }
}

/// Subtracts the gradient of the pressure, so that the flow becomes nearly free of divergence. Some
/// divergence remains for two reasons: a few Gauss-Seidel sweeps do not solve the pressure exactly, and a
/// difference across two cells is zero for the shortest waves.
void project(Fluid& fluid, ClassicScratch& scratch) {
    write_divergence(fluid, scratch.source);
    std::ranges::fill(fluid.state.pressure, 0.0F);
    relax(fluid.lattice, border_of_scalar(), fluid.settings.sweeps, 0, 1, scratch.source,
          fluid.state.pressure);
    subtract_gradient(fluid, fluid.state.pressure);
    classic_fill(fluid);
}

/// A place between eight cell centres, for interpolation.
struct TracedPlace {
    std::ptrdiff_t corner;      ///< index of the cell, of the eight, with the lowest coordinates
    std::array<float, 3> part;  ///< position between that cell and the next along each axis, 0 to 1
};

/// Place from which the fluid of a cell came, along one axis: the lower cell, and the position between it and
/// the next cell, 0 to 1.
struct AxisPlace {
    std::ptrdiff_t cell;
    float part;
};

/// Splits `place` (cells, 0 at the centre of the first cell) into cell and fraction. Walls limit it to
/// half a cell beyond the outer centres; a periodic box wraps it.
AxisPlace along(float place, int n, bool periodic) {
    const auto cells = static_cast<float>(n);
    if (periodic) place -= cells * std::floor(place / cells);
    // A place that is NaN becomes the lower bound.
    place = std::min(std::max(-0.5F, place), cells - (periodic ? 0.0F : 0.5F));
    const float low = std::min(std::floor(place), cells - 1);
    return {static_cast<std::ptrdiff_t>(low), place - low};
}

struct Tracer {
    const Lattice& lattice;
    const std::array<Samples, 3>& velocity;
    float cells_per_speed;  ///< dt / h: distance that fluid with a speed of 1 m/s moves (cells)
    std::array<bool, 3> periodic;

    TracedPlace back(int i, int j, int k) const {
        const std::array<int, 3> from{i, j, k};
        const auto at = static_cast<std::size_t>(lattice.at(i, j, k));
        TracedPlace result{lattice.first, {}};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const float place = static_cast<float>(from[axis]) - cells_per_speed * velocity[axis][at];
            const AxisPlace found = along(place, lattice.cells[axis], periodic[axis]);
            result.corner += found.cell * lattice.stride[axis];
            result.part[axis] = found.part;
        }
        return result;
    }
};

Tracer tracer_of(const Fluid& fluid, const std::array<Samples, 3>& velocity, double dt) {
    Tracer result{fluid.lattice, velocity, static_cast<float>(dt / fluid.lattice.h), {}};
    for (std::size_t axis = 0; axis < 3; ++axis)
        result.periodic[axis] = fluid.settings.edges[axis] == Edge::periodic;
    return result;
}

float mix(float a, float b, float part) { return a + part * (b - a); }

/// Value of a field at the place from which fluid came, by linear interpolation along each axis.
float sample(const Lattice& lattice, const TracedPlace& place, const Samples& samples) {
    const auto [sx, sy, sz] = lattice.stride;
    const float* const c = samples.data() + place.corner;
    const auto [px, py, pz] = place.part;
    const float low = mix(mix(c[0], c[sx], px), mix(c[sy], c[sy + sx], px), py);
    const float high = mix(mix(c[sz], c[sz + sx], px), mix(c[sz + sy], c[sz + sy + sx], px), py);
    return mix(low, high, pz);
}

/// Calls `f` with the index of each cell and the place where the fluid now in that cell was dt earlier.
template <class F>
void trace_back(const Tracer& tracer, F&& f) {
    const auto [nx, ny, nz] = tracer.lattice.cells;
    for (int k = 0; k < nz; ++k) {
        for (int j = 0; j < ny; ++j) {
            for (int i = 0; i < nx; ++i)
                f(static_cast<std::size_t>(tracer.lattice.at(i, j, k)), tracer.back(i, j, k));
        }
    }
}

void carry_velocity(Fluid& fluid, ClassicScratch& scratch, double dt) {
    std::swap(fluid.state.velocity, scratch.before);
    auto& to = fluid.state.velocity;
    trace_back(tracer_of(fluid, scratch.before, dt), [&](std::size_t cell, const TracedPlace& from) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            to[axis][cell] = sample(fluid.lattice, from, scratch.before[axis]);
    });
    classic_fill(fluid);
}

void carry_substance(Fluid& fluid, Samples& substance, ClassicScratch& scratch, double dt) {
    Samples& before = scratch.before[0];
    std::swap(substance, before);
    trace_back(tracer_of(fluid, fluid.state.velocity, dt), [&](std::size_t cell, const TracedPlace& from) {
        substance[cell] = sample(fluid.lattice, from, before);
    });
    fill_border(fluid.lattice, border_of_scalar(), substance);
}

double cells_of(const Lattice& lattice) {
    return double(lattice.cells[0]) * double(lattice.cells[1]) * double(lattice.cells[2]);
}

double viscosity_of(const Fluid& fluid) {
    double result = fluid.settings.viscosity;
    for (std::size_t s = 0; s < fluid.settings.substances.size(); ++s) {
        const double added = fluid.settings.substances[s].viscosity;
        if (added > 0)
            result += added * total(fluid.lattice, fluid.state.substances[s]) / cells_of(fluid.lattice);
    }
    return result;
}

void add_pushes(State& state) {
    if (!state.pushed) return;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t i = 0; i < state.push[axis].size(); ++i)
            state.velocity[axis][i] += state.push[axis][i];
        std::ranges::fill(state.push[axis], 0.0F);
    }
    state.pushed = false;
}

void add_buoyancy(Fluid& fluid, double dt) {
    for (std::size_t s = 0; s < fluid.settings.substances.size(); ++s) {
        const vec3 change = fluid.settings.gravity * (fluid.settings.substances[s].weight * dt);
        const Samples& density = fluid.state.substances[s];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto along_axis = static_cast<float>(change[static_cast<int>(axis)]);
            if (along_axis == 0) continue;
            Samples& velocity = fluid.state.velocity[axis];
            for (std::size_t i = 0; i < velocity.size(); ++i) velocity[i] += along_axis * density[i];
        }
    }
}

void add_forces(Fluid& fluid, double dt) {
    add_pushes(fluid.state);
    add_buoyancy(fluid, dt);
    classic_fill(fluid);
}

void diffuse_velocity(Fluid& fluid, ClassicScratch& scratch, double dt) {
    const double viscosity = viscosity_of(fluid);
    for (std::size_t axis = 0; axis < 3; ++axis)
        diffuse(fluid, border_of_velocity(fluid.settings, axis), viscosity, dt, scratch,
                fluid.state.velocity[axis]);
}

StepReport report_of(const Fluid& fluid, Samples& divergence) {
    StepReport result{.substeps = 1, .pressure_iterations = 2 * fluid.settings.sweeps};
    for (const Samples& component : fluid.state.velocity)
        result.speed = std::max(result.speed, largest(fluid.lattice, component));
    write_divergence(fluid, divergence);
    // write_divergence gives the divergence times -h^2; the report holds the divergence times h, divided by
    // the largest speed.
    if (result.speed > 0)
        result.divergence = largest(fluid.lattice, divergence) / (fluid.lattice.h * result.speed);
    result.energy = energy(fluid);
    result.cells = static_cast<std::int64_t>(cells_of(fluid.lattice));
    return result;
}

void prepare(const Lattice& lattice, ClassicScratch& scratch) {
    for (Samples& s : scratch.before) s.resize(lattice.size);
    scratch.source.resize(lattice.size);
}

}  // namespace

void classic_fill(Fluid& fluid) {
    for (std::size_t axis = 0; axis < 3; ++axis)
        fill_border(fluid.lattice, border_of_velocity(fluid.settings, axis), fluid.state.velocity[axis]);
}

void classic_carry_substances(Fluid& fluid, ClassicScratch& scratch, double dt) {
    prepare(fluid.lattice, scratch);
    for (std::size_t s = 0; s < fluid.settings.substances.size(); ++s) {
        Samples& substance = fluid.state.substances[s];
        fill_border(fluid.lattice, border_of_scalar(), substance);
        diffuse(fluid, border_of_scalar(), fluid.settings.substances[s].diffusion, dt, scratch, substance);
        carry_substance(fluid, substance, scratch, dt);
    }
}

StepReport classic_step(Fluid& fluid, ClassicScratch& scratch, double dt) {
    prepare(fluid.lattice, scratch);
    add_forces(fluid, dt);
    diffuse_velocity(fluid, scratch, dt);
    project(fluid, scratch);
    carry_velocity(fluid, scratch, dt);
    project(fluid, scratch);
    classic_carry_substances(fluid, scratch, dt);
    return report_of(fluid, scratch.source);
}

namespace {

class ClassicSolver final : public SolverApart {
public:
    StepReport step(Fluid& fluid, double dt) override { return classic_step(fluid, scratch_, dt); }
    void carry_substances(Fluid& fluid, double dt) override { classic_carry_substances(fluid, scratch_, dt); }
    void fill(Fluid& fluid) override { classic_fill(fluid); }

private:
    ClassicScratch scratch_;
};

const ClassicIs registered([]() -> std::unique_ptr<SolverApart> {
    return std::make_unique<ClassicSolver>();
});

}  // namespace

}  // namespace thaum::fluid
