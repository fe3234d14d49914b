// haptics/primitives/detail/smoothed_problem.h: step 1 of balance.cpp: the problem with |m| replaced by
// sqrt(|m|^2 + d^2). Newton's method with the forces y as separate unknowns (Chan, Golub, Mulet 1999;
// Andersen, Christiansen, Conn, Overton 2000). Degenerate sets (parallel, coincident or meeting in a point)
// need no special case: the matrix is k I plus a positive semidefinite part.
#pragma once
#include "haptics/primitives/detail/balance_problem.h"

namespace thaum::haptics::balancing {

/// One Newton step of x and of all forces. Expects and leaves the distances at x. `smoothing` is d (m).
/// Returns true if the step went as for a quadratic problem.
bool smoothed_step(Problem& problem, vec3& x, double smoothing);

}  // namespace thaum::haptics::balancing
