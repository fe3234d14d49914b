#include "haptics/primitives/detail/balance_descent.h"

#include <algorithm>

namespace thaum::haptics::balancing {
namespace {

/// Minimises the length of the missing force, the sum of all forces at x, and returns that sum (N). The force
/// of each active term (on whose kink x is assumed to lie) in turn takes its best value while the others keep
/// theirs. This converges.
vec3 least_missing(Problem& problem, vec3 x, int& steps) {
    const vec3 gradient = problem.stiffness * x - problem.target;
    vec3 missing = gradient;
    for (const Term& term : terms_of(problem)) missing += term.dual;
    const double rounding = epsilon * problem.strength;
    for (int round = 0; round < 200; ++round) {
        if (round % 16 == 15) ++steps;  // 16 rounds take as long as one Newton step
        double change = 0;
        for (Term& term : terms_of(problem)) {
            if (!term.active) continue;
            const vec3 before = term.dual;
            term.dual = project(term, before - missing);
            limit_dual(term);
            missing += term.dual - before;
            change = std::max(change, glm::length(term.dual - before));
        }
        if (change <= rounding) break;
    }
    return missing;
}

/// Slope of the energy along the step, at the fraction t of it. Active terms, on whose kinks (a point, line
/// or plane each) x is assumed to lie, do not count, nor does the term `but`, if any.
double sharp_slope(const Problem& problem, vec3 x, vec3 step, double t, const Term* but) {
    double slope = glm::dot(problem.stiffness * (x + t * step) - problem.target, step);
    for (const Term& term : terms_of(problem)) {
        if (term.active || &term == but) continue;
        const vec3 moved = project(term, step);
        const vec3 m = term.distance + t * moved;
        const double size = glm::length(m);
        if (size > 0) slope += term.strength * glm::dot(m, moved) / size;
    }
    return slope;
}

/// First kink (point, line or plane of a primitive) on the step between its fractions `low` and `high`;
/// `high` becomes the fraction at which the step meets it.
Term* first_hit(Problem& problem, vec3 x, vec3 step, double low, double& high) {
    Term* result = nullptr;
    const double rounding = rounding_of(world_of(problem, x));
    for (Term& term : terms_of(problem)) {
        const vec3 moved = project(term, step);
        const double square = glm::dot(moved, moved);
        // A kink that x already touches does not count: the step has just left it.
        if (term.active || square == 0 || touches(term, rounding)) continue;
        const double t = -glm::dot(term.distance, moved) / square;
        if (!(t > low && t < high)) continue;
        Term there = term;
        there.distance += t * moved;
        if (!touches(there, rounding_of(world_of(problem, x + t * step)))) continue;
        high = t;
        result = &term;
    }
    return result;
}

/// Moves x along the step to the place of least energy, at most eight times the step. A kink there is assumed
/// to hold x from now on (becomes active).
void go_down(Problem& problem, vec3& x, vec3 step) {
    const double fall = -sharp_slope(problem, x, step, 0, nullptr);
    double low = 0, high = 8;
    for (int hits = 0; hits < 16; ++hits) {
        double t = high;
        Term* const hit = first_hit(problem, x, step, low, t);
        const double jump = hit == nullptr ? 0 : hit->strength * glm::length(project(*hit, step));
        const double slope = sharp_slope(problem, x, step, t, hit);
        if (slope - jump < 0 && slope + jump > 0) {
            hit->active = true;
            x += t * step;
            return;
        }
        if (slope > 0) high = t;
        if (slope > 0 || hit == nullptr) break;
        low = t;
    }
    double t = high;
    for (int halvings = 0; halvings < 60; ++halvings) {
        t = halvings == 0 && low < 1 && high > 1 ? 1 : 0.5 * (low + high);
        const double slope = sharp_slope(problem, x, step, t, nullptr);
        if (std::abs(slope) <= 0.1 * fall) break;
        (slope > 0 ? high : low) = t;
    }
    x += t * step;
}

/// Adds the kinks that x touches to the active set (those assumed to hold x).
void activate_touched(Problem& problem, vec3 x) {
    measure_distances(problem, x);
    const double rounding = rounding_of(world_of(problem, x));
    for (Term& term : terms_of(problem)) term.active = term.active || touches(term, rounding);
}

}  // namespace

void descend(Problem problem, vec3 x, double accepted, Solution& best, int& steps) {
    double before = std::numeric_limits<double>::infinity();
    for (Term& term : terms_of(problem)) term.active = false;
    for (int tries = 0; tries < 40 && !budget_spent(steps); ++tries, ++steps) {
        measure_distances(problem, x);
        move_origin(problem, x);
        activate_touched(problem, x);
        const Flat flat = flat_of_active(problem, x);
        measure_distances(problem, x);
        Symmetric matrix;
        const vec3 slope = flat.along(smooth_gradient(problem, x, matrix));
        const double size = glm::length(slope);
        const bool stalls = size < 1e-9 && size > 0.5 * before;
        before = size;
        if (size > 0.25 * accepted && !stalls) {
            go_down(problem, x, newton_step(matrix, flat, slope, problem.stiffness));
            continue;
        }
        for (Term& term : terms_of(problem)) {
            if (!term.active) term.dual = term.distance * (term.strength / glm::length(term.distance));
        }
        const vec3 missing = least_missing(problem, x, steps);
        const double residual = residual_at(problem, x);
        keep_if_better(best, problem, x, residual);
        vec3 there = x;
        if (residual <= accepted || !release(problem, matrix, missing, there)) break;
        vec3 unused = x;
        go_down(problem, x, flat_of_active(problem, unused).along(there - x));
    }
}

}  // namespace thaum::haptics::balancing
