// haptics/optimality_check.h: step 3 of balance.cpp: can the active kinks exert what is missing? If so, the sum is zero with forces that each
// can exert, which only the one minimum allows: the proof does not depend on how the guess was made.
#pragma once
#include "haptics/active_set.h"

namespace thaum::haptics::balancing {

/// The best place so far.
struct Solution {
    vec3 proxy;  ///< m, world
    double residual = std::numeric_limits<double>::infinity();
    std::array<vec3, primitive_capacity> pulls;  ///< N, world: of the terms, in their order
};

/// Takes x and the forces as they are, where they are better.
void keep_if_better(Solution& best, const Problem& problem, vec3 x, double residual);

/// How far the active kinks miss x, m; zero where it is the rounding of positions.
double spread_of_active(Problem& problem, vec3 x);
/// Spreads what is missing over the active terms by the room each has left, and again what did not fit. What is left, N.
vec3 balance_active(Problem& problem, vec3 x);
/// The residual at x, N, whatever was active: every force becomes the one that its primitive exerts there, where x does not
/// touch it.
double residual_at(Problem& problem, vec3 x);
/// The bound of the error, N, with the forces as they are: f is by k/2 |x - minimum|^2 above its minimum, and the dual
/// problem's value at these forces is below it.
double duality_bound(Problem& problem, vec3 x);

/// For sets on which the proof fails: improves the forces of the best solution, and with them its place and residual. Each term in turn
/// takes the force that is best while the others keep theirs, which is block coordinate ascent of the dual problem. The proxy is where
/// the spring balances these forces, so nothing is missing and the bound is that of the gap alone.
void improve_by_dual_ascent(Problem& problem, double accepted, Solution& best, int& steps);

}  // namespace thaum::haptics::balancing
