// haptics/primitives/detail/smoothed_problem.h: step 1 of balance.cpp: minimises the energy with its kinks
// rounded off. The distance |m| of each term is replaced by sqrt(|m|^2 + d^2) with a smoothing d. The method
// is Newton's with x and the forces y of the terms as separate unknowns (Chan, Golub, Mulet 1999; Andersen,
// Christiansen, Conn, Overton 2000). Degenerate sets (parallel, coincident or meeting in a point) need no
// special case: the matrix is k I plus a positive semidefinite part.
#pragma once
#include "haptics/primitives/detail/balance_problem.h"

namespace thaum::haptics::balancing {

/// One Newton step of x and of the forces of all terms. The distances of the terms must be those at x, and
/// are so afterwards. `smoothing` is d (m). Returns true if the whole step was taken and ended near the
/// minimum along it, as on a quadratic problem.
bool smoothed_step(Problem& problem, vec3& x, double smoothing);

}  // namespace thaum::haptics::balancing
