// tactile/phantom.h: phantom actuators, which let one place be felt between several actuators.
//
// Two motors that run together are felt as one, at the centroid of their places weighted by amplitude squared
// (Israr and Poupyrev 2011). So a share w_i of the energy goes to actuator i, with amplitude A sqrt(w_i), and
//
//     sum w_i = 1,   w_i >= 0,   sum w_i x_i = p            the felt place is p; the felt strength stays A
//
// Many sets of shares meet these conditions. We choose the one nearest to a Gaussian about p in relative
// entropy:
//
//     w_i = g_i exp(l . (x_i - p)) / Z,   g_i = exp(-|x_i - p|^2 / 2 sigma^2)
//
// where l is the minimum of the convex function log Z(l), found by Newton's method in two unknowns. sigma is
// the width of the Gaussian, and Z makes the sum of the shares 1. Interpolation between the nearest cells
// would be cheaper, but needs a grid; this method works for any layout. A place outside of all actuators is
// moved to the nearest one that they can render.
#pragma once
#include "tactile/layout.h"

namespace thaum::tactile {

/// Shares of the energy, one for each actuator; the sum is 1.
using Shares = std::array<float, max_actuators>;

/// Shares of the actuators in the energy with which a place between them is felt.
struct PhantomResult {
    Shares shares{};
    std::uint8_t strongest{};  ///< number of the actuator with the largest share
    double error{};  ///< distance between the wanted and the felt place, on the chart of the body (m)
};

/// Shares for a place. `sigma_cells` is the width of the Gaussian along the chart's two directions in cells,
/// each at least 0.2. Actuators with less than 1 % of the largest share get none, if the place can be
/// rendered without them. Actuators on the far side of the torso get none unless the effect is wider than one
/// side.
PhantomResult phantom(const Layout& layout, const ChartPlace& place, vec2 sigma_cells);

/// Place that is felt when actuators of a region run with these amplitudes: the offset from `about` on the
/// chart (m); zero if all are silent.
vec2 felt_offset(const Layout& layout, Region region, vec2 about, std::span<const double> amplitudes);

}  // namespace thaum::tactile
