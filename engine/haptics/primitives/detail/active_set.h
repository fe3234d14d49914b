// haptics/primitives/detail/active_set.h: step 2 of balance.cpp: finds the minimum on the intersection of
// the active kinks. That is a flat, an affine subspace of dimension 0 to 3. The other terms are smooth
// there, so Newton's method applies.
#pragma once
#include "haptics/primitives/detail/balance_problem.h"

namespace thaum::haptics::balancing {

/// Intersection of the active kinks: all x whose components along the normals are fixed.
struct Flat {
    std::array<vec3, 3> normals{};  ///< orthonormal
    std::size_t count{};

    vec3 along(vec3 v) const {
        for (std::size_t i = 0; i < count; ++i) v -= glm::dot(normals[i], v) * normals[i];
        return v;
    }
};

/// Two unit vectors normal to q and to each other.
std::array<vec3, 2> normals_to(vec3 q);
/// The active term if there is exactly one, else null.
Term* only_active(Problem& problem);
/// Makes active exactly the terms whose squared distance is below `square` (m^2).
void guess_active_set(Problem& problem, double square);
/// Moves x onto all active kinks. The kink that the others leave most free comes first, because a nearly
/// fixed direction is badly known. A direction that is already fixed is left to the check of distances.
Flat flat_of_active(Problem& problem, vec3& x);
/// Gradient of the smooth rest at x (N); infinite on the kink of an inactive term. `matrix` becomes its
/// derivative. Updates distances and forces of the inactive terms.
vec3 smooth_gradient(Problem& problem, vec3 x, Symmetric& matrix);
/// Newton's step from a slope along the flat.
vec3 newton_step(const Symmetric& m, const Flat& flat, vec3 slope, double stiffness);
/// Newton's method on the flat. It restarts from a nearer origin if x has moved far away. Returns false if it
/// does not converge: x is not near the minimum, or an inactive kink holds x. Ends early if the active kinks
/// clearly cannot hold x.
bool minimise_near(Problem& problem, Flat& flat, vec3& x, Symmetric& matrix, int& steps);
/// Removes the kinks whose force is at its limit from the active set. Moves x in the direction that becomes
/// free, to the minimum for unchanged forces. Returns false if no kink is at its limit.
bool release(Problem& problem, const Symmetric& matrix, vec3 missing, vec3& x);

}  // namespace thaum::haptics::balancing
