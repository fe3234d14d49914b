// fluid/fluid.h: the cauldron's fluid, an incompressible flow in a box or a bowl with up to three
// substances. The equations are those of Mora and Lee 2008, "Real-time 3D fluid interaction with a
// haptic user interface", sections 4 and 5.
//
//     du/dt = -(u . grad) u - grad p + nu lap u + f,   div u = 0                                    eq. 1
//     dc/dt = -(u . grad) c + k lap c + S              for each substance                           eq. 2
//
//     pushes -> velocity -> substances -> report
//
// Two solvers share this interface:
//
//     thaum      Staggered grid with differences of 2nd or 4th order that conserve momentum and energy
//                (momentum.h). Runge-Kutta in time. The pressure is solved directly in a box, by
//                conjugate gradients around solids.
//                Substances are conserved and never fall below zero.
//     classic    The paper's own method (Stam 1999 in three dimensions): the measured baseline.
//
// The interface is plain data and functions, without clocks or threads of its own: the caller may lend a
// team of threads to a step. The same calls give the same bits on every run. Lengths are in m, times in s.
// The density of the fluid is left out: pressures, forces and impulses are per unit of density.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>

#include "core/error.h"
#include "core/maths.h"
#include "core/team.h"
#include "fluid/lattice.h"

namespace thaum::fluid {

/// Method of solution; see the top of this file.
enum class Solver : std::uint8_t { thaum, classic };

inline constexpr std::size_t max_substances = 3;  ///< largest number of substances
inline constexpr double max_viscosity = 1e6;      ///< largest kinematic viscosity that is accepted (m^2/s)
/// Largest speed that one push may give one cell; a stronger push is refused (m/s).
inline constexpr double max_speed = 1e6;
/// Largest number of sub-steps of one step. If more are needed, one semi-Lagrangian step covers the
/// remaining time.
inline constexpr int max_substeps = 3;

/// One substance carried by the fluid. What it adds to the fluid's viscosity and weight is proportional to
/// its density.
struct Substance {
    double viscosity{};  ///< kinematic viscosity that the substance adds where its density is 1 (m^2/s)
    /// Weight that the substance adds where its density is 1, relative to the weight of the base fluid.
    double weight{};
    double diffusion{};  ///< diffusion coefficient (m^2/s)
};

/// Settings of a fluid; the defaults are a valid box.
struct Settings {
    Solver solver = Solver::thaum;
    Cells cells{32, 32, 32};  ///< number of cells along x, y, z
    double h = 1.0 / 32;      ///< edge length of a cell (m)
    /// Kind of the two sides of the box across x, y, z.
    Edges edges{Edge::free_slip, Edge::free_slip, Edge::free_slip};
    int order = 4;              ///< spatial order of `thaum`, 2 or 4; always 2 if there are solids
    int sweeps = 20;            ///< Gauss-Seidel sweeps in each solve of `classic`
    double viscosity{};         ///< kinematic viscosity of the base fluid (m^2/s)
    vec3 gravity{0, -9.81, 0};  ///< acts on substances heavier or lighter than the base fluid (m/s^2)
    double lid{};               ///< speed along x of the no-slip wall at the top of y (m/s)
    std::vector<Substance> substances{};
    /// Solid share at a place (m), 0 to 1. The wall is the surface where it is 0.5. Null: no solids inside
    /// the box.
    std::function<double(vec3)> solid{};
    bool no_slip_at_solids = true;  ///< true: no slip at solids; false: free slip
};

/// Contents of the box: everything that the next step depends on.
struct State {
    /// Velocity (m/s). The ghost cells around the box are filled as Settings::edges requires. Fluid::place
    /// has the positions of the samples.
    std::array<Samples, 3> velocity;
    std::array<Samples, 3> push;  ///< velocity that the next step adds (m/s)
    /// Pressure of the last step, from which the next one starts if there are solids; scratch memory of
    /// `classic` (m^2/s^2).
    Samples pressure;
    /// Potential whose gradient the last removal of divergence (projection) subtracted; with solids, the next
    /// one starts from it (m^2/s).
    Samples projected;
    std::vector<Samples> substances;  ///< densities of each substance, >= 0
    bool pushed = false;              ///< true: `push` is not all zero
    bool asleep = true;               ///< true: nothing moves and nothing can start to move
};

struct Workspace;  // tables and scratch memory of a step; holds no state
/// Deletes a Workspace, whose definition only fluid.cpp knows.
struct DeleteWorkspace {
    void operator()(Workspace* workspace) const;
};

/// A fluid: settings, grid, state, and memory for computing steps. It moves, but cannot be copied: a copy
/// would share the workspace. To repeat a step, keep a copy of `state` and assign it back.
struct Fluid {
    Settings settings;
    Lattice lattice;
    State state;
    std::unique_ptr<Workspace, DeleteWorkspace> work;

    /// Position of the sample of velocity component `axis` in cell (0, 0, 0) (cells).
    vec3 place(std::size_t axis) const {
        vec3 result(0.5);
        if (settings.solver == Solver::thaum) result[static_cast<int>(axis)] = 0;
        return result;
    }
};

/// Checks settings. The error names the setting that is wrong: cells outside 1 to max_cells, an order
/// or number of sweeps out of range, more than three substances, and a viscosity, h, gravity, lid,
/// weight or diffusion that is not finite or outside of its range.
Expected<void> check(const Settings& settings);

/// Makes a fluid at rest, without substances. The error is that of `check`.
///
/// While a fluid runs, its viscosity, gravity, lid and the numbers of its substances may be changed.
/// Check the new settings first.
Expected<Fluid> make_fluid(const Settings& settings);

/// Momentum given to the fluid within `radius` of a place, distributed over the cells by a smooth kernel
/// whose sum is one.
struct Push {
    vec3 place{};     ///< centre (m)
    double radius{};  ///< radius, raised to at least 1.5 cells (m)
    vec3 impulse{};   ///< impulse per unit of density (m^4/s)
};

/// Volume of fluid that a push would move if all of it had the speed of the centre (m^3). It is the
/// integral of the kernel (1 - r^2 / radius^2)^2.
constexpr double pushed_volume(double radius) { return 32 * pi / 105 * radius * radius * radius; }

/// Queues a push for the next step. Returns false if the push was refused: it is not finite, too strong, or
/// reaches only solid cells. Momentum that walls absorb is removed later, in `advance`.
bool push(Fluid& fluid, const Push& push);

/// Adds `amount` (m^3) of a substance within `radius` (m) of a place (m), or within 1.5 cells if that is
/// more. Returns false if nothing was added.
bool pour(Fluid& fluid, std::size_t substance, vec3 place, double radius, double amount);

/// Result of one step.
struct StepReport {
    int substeps{};  ///< number of Runge-Kutta sub-steps
    /// True: `max_substeps` sub-steps were not enough, so one semi-Lagrangian step (less exact) covered the
    /// remaining time.
    bool fell_back{};
    /// Number of iterations of the pressure solve over all sub-steps; a direct solve counts as one.
    int pressure_iterations{};
    double divergence{};   ///< largest divergence times h, divided by the largest speed
    double energy{};       ///< kinetic energy per unit of density (m^5/s^2)
    double rescaled{};     ///< kinetic energy removed because no force had done that work (m^5/s^2)
    double speed{};        ///< largest velocity component (m/s)
    std::int64_t cells{};  ///< work of the step: number of cells times sub-steps
};

/// Advances the fluid by dt (s), 0 < dt <= 1. A fluid at rest without forces costs nothing. Helpers of
/// `team`, if it is not null, share the work of `thaum`; the bits of the result do not depend on them.
StepReport advance(Fluid& fluid, double dt, Team* team = nullptr);

/// Advances only the substances by dt (s), carried by the current velocity.
void carry_substances(Fluid& fluid, double dt);

/// Velocity at a place (m), interpolated linearly between samples (m/s). Places outside the box are
/// moved into it.
vec3 velocity_at(const Fluid& fluid, vec3 place);

/// Sets the velocity (m/s) from a function of the place (m). The function is evaluated where each sample
/// stands: with `thaum` at the centre of a face, or of the part that no solid covers; with `classic` at the
/// centre of a cell.
void set_velocity(Fluid& fluid, const std::function<vec3(vec3)>& velocity);
/// Sets the density of a substance from a function of the place (m), evaluated at cell centres.
void set_substance(Fluid& fluid, std::size_t substance, const std::function<double(vec3)>& density);

/// Must be called after the caller has changed samples. Makes velocities and ghost cells fit the box's sides
/// and the solids again, and wakes the fluid.
void refresh_after_edit(Fluid& fluid);

/// Total momentum per unit of density (m^4/s), summed in double in a fixed order.
vec3 momentum(const Fluid& fluid);
/// Total kinetic energy per unit of density (m^5/s^2), summed in double in a fixed order. If the fluid slips
/// along solids, a face is weighted by the part of it that no solid covers.
double energy(const Fluid& fluid);
/// Total amount of a substance (m^3).
double amount(const Fluid& fluid, std::size_t substance);
/// Evenness of a substance over the cells that hold fluid, 0 to 1: one minus the standard deviation of
/// its density divided by the mean. 0 if there is none of it.
double mixing(const Fluid& fluid, std::size_t substance);
/// Share of the cells that hold fluid which a substance of these densities fills, 0 to 1: the square of the
/// mean over the mean of the squares. Unlike `mixing`, it distinguishes a small blob from a larger one. Where
/// mixing is above 0, the share is 1 / (1 + (1 - mixing)^2). 0 if there is none of the substance.
double filled_share(const Fluid& fluid, const Samples& density);

}  // namespace thaum::fluid
