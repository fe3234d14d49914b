// fluid/detail/pressure.h: divergence and gradient on the staggered grid, of order 2 or 4. At order 4 a
// difference along one axis is:
//
//     ( 27 (u[1] - u[0]) - (u[2] - u[-1]) ) / 24 h
//
// The gradient is minus the transpose of the divergence. So a projection, which subtracts a gradient to
// remove the divergence, can only remove energy.
#pragma once
#include <array>
#include <span>

#include "fluid/rows.h"

namespace thaum::fluid {

/// Divergence (1/s) of a velocity with filled ghost cells, in some layers. `out` has one value for each cell
/// of the lattice, x contiguous, without ghost cells.
void divergence(const Lattice& lattice, Layers layers, int order, const std::array<Samples, 3>& velocity,
                std::span<float> out);

/// Subtracts the gradient of `potential` from the velocity in some layers of `rows`. The ghosts of
/// `potential` must be filled as mirror images (GhostRule::even). The ghosts of the velocity are not
/// changed.
void subtract_gradient(const Rows& rows, Layers layers, int order, const Samples& potential,
                       std::array<Samples, 3>& velocity);

}  // namespace thaum::fluid
