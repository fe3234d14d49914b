// fluid/fluid.h: the cauldron's fluid: an incompressible flow in a box or a bowl, with up to three substances (Mora and Lee 2008,
// "Real-time 3D fluid interaction with a haptic user interface", sections 4 and 5).
//
//     du/dt = -(u . grad) u - grad p + nu lap u + f,   div u = 0                                                    eq. 1
//     dc/dt = -(u . grad) c + k lap c + S              for each substance                                           eq. 2
//
//     pushes -> velocity -> substances -> report
//
// Two solvers stand behind one interface. `thaum`: staggered grid, differences of 2nd or 4th order that conserve momentum and
// energy (Morinishi, Lund, Vasilyev and Moin 1998), Runge-Kutta, a direct pressure solve; conservative substances that never
// fall below zero. `classic`: the paper's own method (Stam 1999 in three dimensions), the measured baseline.
//
// Plain data and functions; no thread, no clock. The same calls give the same bits on every run. Lengths in m, times in s; the
// density of the fluid is left out: pressures, forces and impulses are per density.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "core/error.h"
#include "core/maths.h"
#include "fluid/lattice.h"

namespace thaum::fluid {

enum class Solver : std::uint8_t { thaum, classic };

inline constexpr std::size_t substances_most = 3;
inline constexpr double viscosity_most = 1e6;  ///< m^2/s
inline constexpr double speed_most = 1e6;      ///< m/s; what would be faster is refused
/// Of one step. Where it wants more, a semi-Lagrangian step takes the place of all that are left.
inline constexpr int substeps_most = 3;

struct Substance {
    double viscosity{};  ///< m^2/s, added where its density is 1
    double weight{};     ///< share by which it is heavier than the base fluid where its density is 1
    double diffusion{};  ///< m^2/s
};

struct Settings {
    Solver solver = Solver::thaum;
    Cells cells{32, 32, 32};
    double h = 1.0 / 32;  ///< m
    Edges edges{Edge::free_slip, Edge::free_slip, Edge::free_slip};
    int order = 4;              ///< of thaum in space: 2 or 4; where there are solid cells it is 2
    int sweeps = 20;            ///< of classic, Gauss-Seidel, for each solve
    double viscosity{};         ///< m^2/s, of the base fluid
    vec3 gravity{0, -9.81, 0};  ///< m/s^2; acts on substances that are heavier or lighter than the base fluid
    double lid{};               ///< m/s along x, of the wall at the top of y; where that is a no-slip wall
    std::vector<Substance> substances{};
    /// Share of a place that is solid, 0 to 1, by the place (m). The wall stands where it is one half. Null: no solids but the edges.
    std::function<double(vec3)> solid{};
    bool solid_holds = true;  ///< no slip at solids
};

/// What stands in the box. State; all that the next step depends on.
struct State {
    std::array<Samples, 3> velocity;  ///< m/s, ghosts as the edges say; where components stand: Fluid::place
    std::array<Samples, 3> push;      ///< m/s, what the next step adds
    Samples pressure;                 ///< m^2/s^2, of the last step; where there are solids
    Samples projected;  ///< m^2/s, what the last projection took the gradient of away; there too
    std::vector<Samples> substances;  ///< densities, >= 0
    bool pushed = false;
    bool asleep = true;  ///< nothing moves or is going to
};

struct Workspace;  // what a step needs besides: tables, scratch; no state
struct DeleteWorkspace {
    void operator()(Workspace* workspace) const;
};

/// Moves, but cannot be copied: a copy would share the workspace. To repeat a step, keep `now` and put it back.
struct Fluid {
    Settings settings;
    Lattice lattice;
    State now;
    std::unique_ptr<Workspace, DeleteWorkspace> work;

    /// Where component `axis` of cell (0, 0, 0) stands, in cells.
    vec3 place(std::size_t axis) const {
        vec3 result(0.5);
        if (settings.solver == Solver::thaum) result[static_cast<int>(axis)] = 0;
        return result;
    }
};

/// The error names the setting: cells outside 1 to cells_most, order, sweeps, viscosity negative, not finite or above
/// viscosity_most, more than three substances, h, gravity or lid not finite.
Expected<void> check(const Settings& settings);

/// At rest, without substances. The error is that of `check`.
///
/// Of the settings of a fluid that goes on, viscosity, gravity, lid and the substances' numbers may be changed, if they are checked.
Expected<Fluid> make_fluid(const Settings& settings);

/// Momentum for the cells within `radius` of a place, by a smooth kernel whose sum is one.
struct Push {
    vec3 place{};     ///< m
    double radius{};  ///< m; at least the edge of a cell is taken
    vec3 impulse{};   ///< m^4/s: N s per density
};

/// m^3, of the fluid that a push within `radius` moves as fast as its middle: the integral of the kernel (1 - r^2 / radius^2)^2.
constexpr double pushed_volume(double radius) { return 32 * pi / 105 * radius * radius * radius; }

/// Before the next step. True where it was taken: finite, and reaching a cell that is not solid. What the walls take away again
/// follows in `advance`.
bool push(Fluid& fluid, const Push& push);

/// Adds `amount`, m^3, of a substance within `radius` of a place. False where nothing was added.
bool pour(Fluid& fluid, std::size_t substance, vec3 place, double radius, double amount);

/// What a step did.
struct StepReport {
    int substeps{};
    bool fell_back{};           ///< beyond `substeps_most`: what was left went by a semi-Lagrangian step
    int pressure_iterations{};  ///< of all sub-steps; a direct solve counts as one
    double divergence{};        ///< largest, times h by the largest speed
    double energy{};            ///< m^5/s^2: J per density
    double rescaled{};          ///< kinetic energy taken away, since no force had done that work (m^5/s^2)
    double speed{};             ///< m/s, the largest component
    std::int64_t cells{};       ///< visited: cells times sub-steps
};

/// By dt seconds, 0 < dt <= 1. At rest and without forces nothing is visited.
StepReport advance(Fluid& fluid, double dt);

/// The substances' part of a step alone, by the velocity that stands there.
void carry_substances(Fluid& fluid, double dt);

/// Of a place inside a cell to be sampled by: the velocity there, m/s, linear between samples.
vec3 velocity_at(const Fluid& fluid, vec3 place);

/// Sets the velocity from a function of the place, m -> m/s, wherever components stand: in the middle of the open part of each face.
void set_velocity(Fluid& fluid, const std::function<vec3(vec3)>& velocity);
void set_substance(Fluid& fluid, std::size_t substance, const std::function<double(vec3)>& density);

/// To be called after samples were written from outside: what edges and solids say holds again, the fluid is awake.
void altered(Fluid& fluid);

/// m^4/s and m^5/s^2, summed in double in a fixed order.
vec3 momentum(const Fluid& fluid);
double energy(const Fluid& fluid);
/// m^3.
double amount(const Fluid& fluid, std::size_t substance);
/// How evenly a substance is spread over the cells that hold fluid: 1 less the standard deviation of its density by the mean, at
/// least 0; 0 where there is none of it.
double mixing(const Fluid& fluid, std::size_t substance);

}  // namespace thaum::fluid
