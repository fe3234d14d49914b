// fluid/detail/buoyancy.h: the weight of substances: the force by which they sink or rise, how the flow moves
// that weight within a step, and the energy that diffusion adds by lifting it.
//
// If the buoyancy force used the densities at the start of a step, waves would grow: an oscillation of
// frequency w would gain (w dt)^2 / 2 of its kinetic energy in each step. With the densities half a
// step later, the step neither amplifies nor damps it.
#pragma once
#include <array>

#include "core/maths.h"
#include "core/team.h"
#include "fluid/rows.h"

namespace thaum::fluid {

/// Adds the force of gravity on `weight` (substances relative to the base fluid), whose ghost cells must be
/// filled, to the forces on the open faces. Along the vertical, the mean of every level (cells at one height)
/// is left out, because pressure balances it. `open` holds the shares of the faces that no solid covers; null
/// means all are open.
void add_weight(const Rows& rows, int order, const std::array<Samples, 3>* open, const vec3& gravity,
                const Samples& weight, std::array<Samples, 3>& force, Team& team);

/// Predicts for some layers where the flow will have carried `weight` after `time` (s), in one step of first
/// order with central differences. The ghosts of `weight` must be filled. The result is only a prediction:
/// the amount is not conserved, but a constant stays constant. `open` holds the open shares of faces; null
/// means all are open.
void predict_weight(const Rows& rows, Layers layers, const std::array<Samples, 3>& velocity,
                    const std::array<Samples, 3>* open, double time, const Samples& weight, Samples& moved);

/// Potential energy that diffusion with the coefficient k = 1 m^2/s adds per second, summed over cells (1/s^2
/// for a weight without unit). Diffusion adds energy because it spreads a heavy substance upwards from below.
/// The ghosts of `weight` must be filled. `open` holds the open shares of faces; null means all are open.
double lifted_by_diffusion(const Rows& rows, const std::array<Samples, 3>* open, const vec3& gravity,
                           const Samples& weight);

}  // namespace thaum::fluid
