// fluid/classic/classic.h: the solver of the paper Mora and Lee 2008, section 4, as a baseline for
// measurements. It is Stam's stable fluids ("Real-Time Fluid Dynamics for Games", 2003) in three dimensions.
//
//     add forces -> diffuse -> project -> advect -> project;      substances: diffuse -> advect
//
// All components are sampled at cell centres. Diffusion and pressure are solved by a fixed number of
// Gauss-Seidel sweeps. Diffusion starts from the current field, pressure from zero. Advection traces each
// cell back along one straight line and interpolates linearly there. The solver is stable for any time step,
// but it smears, loses mass and leaves some divergence.
//
// Nothing was added to the method. Two mistakes of common ports are corrected: the divergence uses half the
// difference across two cells, and the viscosity is not multiplied by the number of cells. As in the paper,
// there are no solids inside the box. One viscosity holds for the whole box: that of the base fluid plus the
// mean of each substance's.
//
// The solver is a library of its own, thaum_fluid_classic. A program that uses it must link that library
// whole, because a static object in it registers the solver.
#pragma once
#include "fluid/fluid.h"

namespace thaum::fluid {

/// Work arrays of a step, kept so that the next step need not allocate them again. No step reads what an
/// earlier one left in them.
struct ClassicScratch {
    /// copies of velocities or of a substance, which a pass reads while it writes its result
    std::array<Samples, 3> before{};
    Samples source{};  ///< right-hand side of a solve, for diffusion or pressure
};

/// Advances the fluid by dt (s), > 0, in one step. Of the ghost cells it uses only the layer next to the box.
StepReport classic_step(Fluid& fluid, ClassicScratch& scratch, double dt);

/// Fills the ghost cells of the velocity in the layer next to the box, as the rules for its sides require.
void classic_fill(Fluid& fluid);

/// Advances only the substances by dt (s), carried by the current velocity.
void classic_carry_substances(Fluid& fluid, ClassicScratch& scratch, double dt);

}  // namespace thaum::fluid
