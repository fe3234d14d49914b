// fluid/classic.h: the paper's own solver, the baseline that ours is measured against: Stam's stable fluids ("Real-Time Fluid
// Dynamics for Games", 2003) in three dimensions, as Mora and Lee 2008, section 4, took it.
//
//     add forces -> diffuse -> project -> carry by itself -> project;      substances: diffuse -> carry
//
// All components stand at the centres of cells. Diffusion and pressure are solved by a fixed number of Gauss-Seidel sweeps, the
// first from the field as it stands and the second from zero; what flows is traced back by one straight line and read there
// linearly. So it is stable at any step and as exact as its sweeps: it smears, loses mass and leaves some divergence.
//
// Nothing is added to the method. Two slips of ports that are passed round are repaired: the divergence takes half the
// difference across two cells, and the viscosity is not multiplied by the number of cells. Solids other than the box are unknown
// to it, as to the paper, and viscosity is one number for the whole box: that of the base fluid and of each substance by its mean.
#pragma once
#include "fluid/fluid.h"

namespace thaum::fluid {

/// Kept between steps so that none allocates; no state.
struct ClassicScratch {
    std::array<Samples, 3> before{};  ///< velocities, or a substance, that a pass reads while it writes
    Samples source{};                 ///< the right-hand side of a solve
};

/// By dt seconds, > 0, in one step. Of the ghosts it reads and writes those next to the box.
StepReport classic_step(Fluid& fluid, ClassicScratch& scratch, double dt);

/// Writes the velocity's ghosts next to the box.
void classic_fill(Fluid& fluid);

/// The substances' part alone, by the velocity that stands there.
void classic_carry_substances(Fluid& fluid, ClassicScratch& scratch, double dt);

}  // namespace thaum::fluid
