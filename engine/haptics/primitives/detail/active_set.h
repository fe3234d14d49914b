// haptics/primitives/detail/active_set.h: step 2 of balance.cpp: finds the minimum on the intersection of
// the active kinks, those on which x is assumed to lie. The intersection is a flat, an affine subspace of
// dimension 0 to 3. The other terms are smooth there, so Newton's method applies.
#pragma once
#include "haptics/primitives/detail/balance_problem.h"

namespace thaum::haptics::balancing {

/// Intersection of the active kinks (points, lines and planes that are assumed to hold x): all places whose
/// components along the normals are fixed.
struct Flat {
    std::array<vec3, 3> normals{};  ///< unit vectors, each normal to the others, along which x is fixed
    std::size_t count{};            ///< number of fixed directions, 0 to 3

    /// The part of v along the flat, the space within which x may move.
    vec3 along(vec3 v) const {
        for (std::size_t i = 0; i < count; ++i) v -= glm::dot(normals[i], v) * normals[i];
        return v;
    }
};

/// Two unit vectors normal to q and to each other.
std::array<vec3, 2> normals_to(vec3 q);
/// The active term (x is assumed to lie on its kink: a point, line or plane) if there is exactly one, else
/// null.
Term* only_active(Problem& problem);
/// Assumes that exactly those kinks hold x (are active) whose squared distance from x is below `square`
/// (m^2).
void guess_active_set(Problem& problem, double square);
/// Moves x onto all active kinks (points, lines and planes assumed to hold x), and returns their
/// intersection. Each round adds the kink whose normal lies most within the flat of the kinks added before.
/// If a normal is almost perpendicular to that flat, rounding makes the direction that the kink would fix
/// inaccurate. A kink that can fix no further direction is skipped; spread_of_active() checks later whether x
/// lies on it.
Flat flat_of_active(Problem& problem, vec3& x);
/// Gradient at x of the energy without the active terms, those on whose kinks (a point, line or plane each) x
/// is assumed to lie (N). It is infinite on the kink of an inactive term. `matrix` becomes the derivative of
/// the gradient. Updates distances and forces of the inactive terms.
vec3 smooth_gradient(Problem& problem, vec3 x, Symmetric& matrix);
/// Newton's step of x along the flat (the space within which x may move), for a gradient `slope` of the
/// energy along it and a second derivative `m`.
vec3 newton_step(const Symmetric& m, const Flat& flat, vec3 slope, double stiffness);
/// Newton's method for x on the flat, the intersection of the active kinks. It restarts from an origin nearer
/// to x if x has moved far away. Returns false if it does not converge: x is not near the minimum, or a kink
/// that is not in the active set holds x. Ends early if the active kinks clearly cannot hold x.
bool minimise_near(Problem& problem, Flat& flat, vec3& x, Symmetric& matrix, int& steps);
/// Removes from the active set (the kinks assumed to hold x) those whose force has reached their strength,
/// because they cannot hold x. Moves x along the force that is missing for balance, to the minimum that there
/// would be if the other forces stayed the same. Returns false if no kink has reached its strength.
bool release(Problem& problem, const Symmetric& matrix, vec3 missing, vec3& x);

}  // namespace thaum::haptics::balancing
