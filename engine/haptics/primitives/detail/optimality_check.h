// haptics/primitives/detail/optimality_check.h: step 3 of balance.cpp: checks whether the primitives on whose
// kinks x is assumed to lie (the active ones) can cancel the sum of all other forces. If so, all forces sum
// to zero, and each is one that its primitive can exert. That holds at the minimum only, so x is the
// solution, however the active ones were guessed.
#pragma once
#include "haptics/primitives/detail/active_set.h"

namespace thaum::haptics::balancing {

/// The place with the smallest bound of the error (residual) that the search has found so far, and the forces
/// there.
struct Solution {
    vec3 proxy;  ///< position of the proxy (m, world)
    /// Bound of the error of the force (N, Balance::residual); infinite before the first solution.
    double residual = std::numeric_limits<double>::infinity();
    /// Forces of the problem's terms (one for each primitive with a kink), in their order (N, world frame).
    std::array<vec3, primitive_capacity> pulls;
};

/// Replaces `best` by x and the present forces of the terms if `residual` (N) is smaller than that of `best`.
void keep_if_better(Solution& best, const Problem& problem, vec3 x, double residual);

/// Largest distance between x and a kink of the active set, which is assumed to hold x (m); 0 if x lies on
/// all of them but for rounding.
double spread_of_active(Problem& problem, vec3 x);
/// Distributes the force that is missing for balance over the active terms, by the strength that each has
/// left. (A term is active if x is assumed to lie on its kink: a point, line or plane.) Repeats this with the
/// force that is still missing. Returns the part of the force that the terms cannot exert (N).
vec3 balance_active(Problem& problem, vec3 x);
/// Length of the sum of all forces at x (N), whichever terms are assumed to hold x. The force of every term
/// becomes the one that its primitive exerts at x, unless x lies on its kink.
double residual_at(Problem& problem, vec3 x);
/// Bound of the error of x and of the present forces of the terms (N). It follows from two facts: the energy
/// at x is at least k/2 |x - minimum|^2 above its minimum, and the dual problem's value at these forces is
/// below the minimum.
double duality_bound(Problem& problem, vec3 x);

/// Improves the forces of the best solution, and with them its place and its bound of the error. It serves
/// for sets on which the optimality check fails. Each term in turn takes its best force while the others keep
/// theirs: block coordinate ascent of the dual problem. The proxy is put where the spring balances these
/// forces. So no force is missing, and only the duality gap (difference of energy and dual value) bounds the
/// error.
void improve_by_dual_ascent(Problem& problem, double accepted, Solution& best, int& steps);

}  // namespace thaum::haptics::balancing
