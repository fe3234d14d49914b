// haptics/smoothed_problem.h: step 1 of balance.cpp: the problem with |m| replaced by sqrt(|m|^2 + d^2). Newton's steps with the forces y
// as unknowns of their own (Chan, Golub, Mulet 1999; Andersen, Christiansen, Conn, Overton 2000). Degenerate sets (parallel,
// coincident, meeting in a point) are nothing special here: the matrix is k I and something positive semidefinite.
#pragma once
#include "haptics/balance_problem.h"

namespace thaum::haptics::balancing {

/// One Newton step of x and of all forces; distances are those at x, before and after. smoothing: d, m. Whether it went as a quadratic
/// problem would.
bool smoothed_step(Problem& problem, vec3& x, double smoothing);

}  // namespace thaum::haptics::balancing
