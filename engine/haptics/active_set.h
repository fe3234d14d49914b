// haptics/active_set.h: step 2 of balance.cpp: on what the active kinks have in common, a flat of dimension 0 to 3, the rest is smooth,
// and Newton's method finds its lowest place.
#pragma once
#include "haptics/balance_problem.h"

namespace thaum::haptics::balancing {

/// What the active kinks have in common: all x with directions . x fixed.
struct Flat {
    std::array<vec3, 3> normals{};  ///< orthonormal
    std::size_t count{};

    vec3 along(vec3 v) const {
        for (std::size_t i = 0; i < count; ++i) v -= glm::dot(normals[i], v) * normals[i];
        return v;
    }
};

/// Two unit vectors normal to q and each other.
std::array<vec3, 2> normals_to(vec3 q);
/// The one that is active, where only one is.
Term* only_active(Problem& problem);
/// Holds those whose distance squared is below `square`, m^2, and no others.
void guess_active_set(Problem& problem, double square);
/// Puts x onto all active kinks: the one that the others leave most free first, since what is nearly fixed already is badly known. A
/// direction that is fixed is left to the check of distances.
Flat flat_of_active(Problem& problem, vec3& x);
/// The gradient of the smooth rest at x, N; infinite on the kink of a term that is not active. Matrix: its derivative. Of the
/// terms that are not active it leaves distances and pulls.
vec3 smooth_gradient(Problem& problem, vec3 x, Symmetric& matrix);
/// Newton's step from a slope along the flat.
vec3 newton_step(const Symmetric& m, const Flat& flat, vec3 slope, double stiffness);
/// Newton's method on the flat, from a nearer origin where x has gone far from this one. False where it does not converge: then x is
/// not near, or some kink holds it after all. Ends early where it is plain that the active ones cannot hold x.
bool minimise_near(Problem& problem, Flat& flat, vec3& x, Symmetric& matrix, int& steps);
/// Lets go of the kinks whose force is at its limit, and goes down the way that is left, to where the minimum would be
/// if they pulled on alike. False where there is none to let go of.
bool release(Problem& problem, const Symmetric& matrix, vec3 missing, vec3& x);

}  // namespace thaum::haptics::balancing
