// fluid/pressure.h: divergence and its adjoint on the staggered grid, of order 2 or 4:
//
//     4th:  ( 27 (u[1] - u[0]) - (u[2] - u[-1]) ) / 24 h
//
// The gradient is minus the transpose of the divergence, so a projection takes energy only.
#pragma once
#include <array>
#include <span>

#include "fluid/rows.h"

namespace thaum::fluid {

/// Of a velocity whose ghosts are filled; out without ghosts, x contiguous, one value for each cell. 1/s.
void divergence(const Lattice& lattice, int order, const std::array<Samples, 3>& velocity,
                std::span<float> out);

/// In the rows, velocity -= grad potential, whose ghosts are filled evenly. Ghosts of the velocity are left as they
/// are.
void subtract_gradient(const Rows& rows, int order, const Samples& potential,
                       std::array<Samples, 3>& velocity);

}  // namespace thaum::fluid
