// haptics/primitives/detail/optimality_check.h: step 3 of balance.cpp: checks whether the active kinks can
// exert the missing force. If so, all forces sum to zero and each is one that its primitive can exert. Only
// the minimum allows that, however the active set was guessed.
#pragma once
#include "haptics/primitives/detail/active_set.h"

namespace thaum::haptics::balancing {

/// The best place so far.
struct Solution {
    vec3 proxy;  ///< position of the proxy (m, world)
    double residual = std::numeric_limits<double>::infinity();
    /// Forces of the terms, in their order (N, world frame).
    std::array<vec3, primitive_capacity> pulls;
};

/// Takes x and the present forces if their residual is smaller.
void keep_if_better(Solution& best, const Problem& problem, vec3 x, double residual);

/// Largest distance between the active kinks and x (m); zero if it is the rounding of positions.
double spread_of_active(Problem& problem, vec3 x);
/// Distributes the missing force over the active terms by their remaining strength, and repeats with the
/// rest. Returns the force that is left (N).
vec3 balance_active(Problem& problem, vec3 x);
/// The residual at x (N), whichever terms are active. Every force becomes the one that its primitive exerts
/// at x, unless x touches its kink.
double residual_at(Problem& problem, vec3 x);
/// Bound of the error with the present forces (N). f is at least k/2 |x - minimum|^2 above its minimum. The
/// dual problem's value at these forces is below the minimum.
double duality_bound(Problem& problem, vec3 x);

/// Improves the forces of the best solution, and with them its place and residual, for sets on which the
/// check fails. Each term in turn takes its best force while the others keep theirs: block coordinate ascent
/// of the dual problem. The proxy is where the spring balances these forces. So no force is missing, and the
/// bound is that of the duality gap alone.
void improve_by_dual_ascent(Problem& problem, double accepted, Solution& best, int& steps);

}  // namespace thaum::haptics::balancing
