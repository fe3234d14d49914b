#include "haptics/primitives/detail/optimality_check.h"

#include <algorithm>

namespace thaum::haptics::balancing {
namespace {

/// Residual (bound of the force's error) up to which a set of primitives counts as solved (N).
constexpr double solved = 1e-9;

/// Computes the distances of all terms (balance_problem.h) at x, and limits their forces to their strengths.
void refresh_terms(Problem& problem, vec3 x) {
    for (Term& term : terms_of(problem)) {
        term.distance = project(term, project(term, x) - term.offset);
        term.dual = project(term, term.dual);
        limit_dual(term);
    }
}

/// Largest difference between the force that the search has assigned to a term and the force that its
/// primitive exerts at x (N). Terms on whose kink x lies do not count, because x does not determine their
/// force.
double worst_misfit(const Problem& problem, vec3 x) {
    const double rounding = rounding_of(world_of(problem, x));
    double worst = 0;
    for (const Term& term : terms_of(problem)) {
        if (touches(term, rounding)) continue;
        const vec3 pull = term.distance * (term.strength / glm::length(term.distance));
        worst = std::max(worst, glm::length(term.dual - pull));
    }
    return worst;
}

/// Force that an active term (on whose kink x is assumed to lie) can still add until it reaches its strength
/// (N). 1 % of the strength is added, so that the result is never zero.
double remaining_strength(const Term& term) { return 1.01 * term.strength - glm::length(term.dual); }

/// Sum of all forces at x, which must vanish, and the strength that the active terms (whose kinks are assumed
/// to hold x) have left to cancel it.
struct Shortfall {
    vec3 force{};      ///< sum of all forces, which is zero in balance (N)
    Symmetric room{};  ///< sum of the active terms' projectors, weighted by their remaining strength (N)
    double most{};     ///< sum of the active terms' remaining strengths (N)
};

Shortfall shortfall(Problem& problem, vec3 gradient) {
    Shortfall result{.force = gradient};
    for (Term& term : terms_of(problem)) {
        result.force += term.dual;
        if (!term.active) continue;
        const double left = remaining_strength(term);
        add_projector(result.room, term, left);
        result.most += left;
    }
    return result;
}

/// Distributes the force that is missing for balance at the proxy x over the active terms, in proportion to
/// the strength that each has left. A term is active if x is assumed to lie on its kink: the point, line or
/// plane where its energy is not smooth.
void distribute(Problem& problem, const Shortfall& missing) {
    Symmetric room = missing.room;
    add_identity(room, 1e-14 * missing.most);
    const vec3 share = solve(room, missing.force, 1e-14 * missing.most);
    for (Term& term : terms_of(problem)) {
        if (!term.active) continue;
        term.dual -= remaining_strength(term) * project(term, share);
        limit_dual(term);
    }
}

}  // namespace

void keep_if_better(Solution& best, const Problem& problem, vec3 x, double residual) {
    if (!(residual < best.residual)) return;
    best.residual = residual;
    best.proxy = world_of(problem, x);
    std::size_t i = 0;
    for (const Term& term : terms_of(problem)) best.pulls[i++] = -to_world_frame(problem, term.dual);
}

double spread_of_active(Problem& problem, vec3 x) {
    const double rounding = rounding_of(world_of(problem, x));
    double spread = 0;
    for (Term& term : terms_of(problem)) {
        if (!term.active) continue;
        term.distance = project(term, x) - term.offset;
        if (!touches(term, rounding)) spread = std::max(spread, glm::dot(term.distance, term.distance));
    }
    return std::sqrt(spread);
}

double residual_at(Problem& problem, vec3 x) {
    refresh_terms(problem, x);
    const double rounding = rounding_of(world_of(problem, x));
    vec3 missing = problem.stiffness * x - problem.target;
    for (Term& term : terms_of(problem)) {
        if (!touches(term, rounding))
            term.dual = term.distance * (term.strength / glm::length(term.distance));
        missing += term.dual;
    }
    return glm::length(missing);
}

double duality_bound(Problem& problem, vec3 x) {
    refresh_terms(problem, x);
    vec3 missing = problem.stiffness * x - problem.target;
    double gap = 0;
    for (const Term& term : terms_of(problem)) {
        missing += term.dual;
        gap += std::max(0.0, term.strength * glm::length(term.distance) - glm::dot(term.dual, term.distance));
    }
    const double bound = std::sqrt(glm::dot(missing, missing) + 2 * problem.stiffness * gap);
    // If x is very near the kink of a strong term, the bound may be small although the term's force is wrong.
    // That does not count as solved.
    return bound <= solved && worst_misfit(problem, x) > solved ? 2 * solved : bound;
}

void improve_by_dual_ascent(Problem& problem, double accepted, Solution& best, int& steps) {
    constexpr int max_passes = 12;
    // Number of updates of single terms that cost as much as a Newton step of the largest set.
    constexpr std::size_t updates_of_a_pass = 256;
    std::size_t i = 0;
    vec3 sum{};
    for (Term& term : terms_of(problem)) {
        term.dual = std::isfinite(best.residual) ? -to_problem_frame(problem, best.pulls[i++]) : vec3(0);
        sum += term.dual;
    }
    int passes = std::clamp(balance_step_budget + max_passes - steps, 1, max_passes);
    for (; passes > 0 && best.residual > accepted; --passes, ++steps) {
        for (std::size_t done = 0; done < updates_of_a_pass; done += problem.terms.count) {
            for (Term& term : terms_of(problem)) {
                const vec3 others = sum - term.dual;
                term.dual = project(term, problem.target - others) - problem.stiffness * term.offset;
                limit_dual(term);
                sum = others + term.dual;
            }
        }
        const vec3 x = (problem.target - sum) / problem.stiffness;
        const double bound = duality_bound(problem, x);
        keep_if_better(best, problem, x, bound);
    }
}

vec3 balance_active(Problem& problem, vec3 x) {
    const vec3 gradient = problem.stiffness * x - problem.target;
    vec3 missing = gradient;
    std::size_t active = 0;
    for (Term& term : terms_of(problem)) {
        if (!term.active) missing += term.dual;
        active += term.active ? 1 : 0;
    }
    if (active == 0) return missing;
    if (Term* const only = active == 1 ? only_active(problem) : nullptr) {
        only->dual = -project(*only, missing);
        limit_dual(*only);
        return missing + only->dual;
    }
    const double rounding = 2 * epsilon * (problem.strength + glm::length(gradient));
    for (Term& term : terms_of(problem)) {
        if (term.active) term.dual = project(term, term.dual);
    }
    double before = std::numeric_limits<double>::infinity();
    for (;;) {
        const Shortfall current = shortfall(problem, gradient);
        const double size = glm::length(current.force);
        if (size <= rounding || current.most == 0 || size > 0.7 * before) return current.force;
        before = size;
        distribute(problem, current);
    }
}

}  // namespace thaum::haptics::balancing
