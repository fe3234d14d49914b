// fluid/buoyancy.h: the weight of substances: its course within a step, and what diffusion lifts.
//
// A force taken from the densities at the start of a step feeds waves: every step of an oscillation of frequency w adds
// (w dt)^2 / 2 of its kinetic energy. Taken from the densities half a step later, the same step neither feeds nor damps it.
#pragma once
#include <array>

#include "core/maths.h"
#include "fluid/rows.h"

namespace thaum::fluid {

/// Moves `weight`, with its ghosts, by the velocity for `time` (s) in one step of first order with central differences.
/// Only for a prediction: it conserves nothing, but a constant stays a constant. `open`: shares of open faces; null: all open.
void predict_weight(const Rows& rows, const std::array<Samples, 3>& velocity,
                    const std::array<Samples, 3>* open, double time, const Samples& weight, Samples& moved);

/// Potential energy that diffusion with k = 1 m^2/s adds in a second, summed over cells (1/s^2 for a weight without unit): what is
/// heavy below spreads upwards. The weight's ghosts are filled; `open` as above.
double lifted_by_diffusion(const Rows& rows, const std::array<Samples, 3>* open, const vec3& gravity,
                           const Samples& weight);

}  // namespace thaum::fluid
