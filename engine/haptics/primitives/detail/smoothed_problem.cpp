#include "haptics/primitives/detail/smoothed_problem.h"

namespace thaum::haptics::balancing {
namespace {

/// Slope of the smoothed energy (with its kinks rounded off) along the step, at the fraction t of it (N m).
double slope_along(const Problem& problem, vec3 x, double smoothing, vec3 step, double t) {
    double slope = glm::dot(problem.stiffness * (x + t * step) - problem.target, step);
    for (const Term& term : terms_of(problem)) {
        const vec3 moved = project(term, step);
        const vec3 m = term.distance + t * moved;
        slope += term.strength * glm::dot(m, moved) / std::sqrt(glm::dot(m, m) + smoothing * smoothing);
    }
    return slope;
}

/// Fraction of the step to try next, between `low` and `high`. It is where the step passes nearest to a kink,
/// because the slope changes quickly there, or the middle of `low` and `high` if the step passes no kink.
double next_try(const Problem& problem, vec3 step, double low, double high) {
    for (const Term& term : terms_of(problem)) {
        const vec3 moved = project(term, step);
        const double t = -glm::dot(term.distance, moved) / glm::dot(moved, moved);
        if (t > low && t < high) return t;
    }
    return 0.5 * (low + high);
}

/// Fraction of a Newton step to take.
struct Part {
    double taken = 1;       ///< the fraction, 0 to 1
    bool good = false;      ///< the whole step was taken and the slope at its end is small
    bool falls_on = false;  ///< the whole step was taken and the energy still falls at its end
};

/// Chooses the fraction of the step. The whole step is taken, unless the energy rises at its end with more
/// than a quarter of the slope with which it fell at the start. Then it is about the fraction with the least
/// energy. `fall` is the slope at the start (N m, negative).
Part part_of(const Problem& problem, vec3 x, double smoothing, vec3 step, double fall) {
    double low = 0, high = 1, t = 1;
    for (int tries = 0; tries < 24; ++tries) {
        const double slope = slope_along(problem, x, smoothing, step, t);
        const bool flat = std::abs(slope) <= -0.25 * fall;
        if (flat || (t == 1 && slope < 0)) return {t, flat && t == 1, !flat};
        (slope > 0 ? high : low) = t;
        t = next_try(problem, step, low, high);
    }
    return {t, false, false};
}

}  // namespace

bool smoothed_step(Problem& problem, vec3& x, double smoothing) {
    Symmetric matrix = scaled_identity(problem.stiffness);
    vec3 gradient = problem.stiffness * x - problem.target;
    std::array<double, primitive_capacity> inverse{};
    std::size_t i = 0;
    for (Term& term : terms_of(problem)) {
        const vec3 m = term.distance;
        const double over = 1 / std::sqrt(glm::dot(m, m) + smoothing * smoothing);
        const double weight = term.strength * over;
        gradient += weight * m;
        add_projector(matrix, term, weight);
        add_pair(matrix, -0.5 * over * over, term.dual, m);
        inverse[i++] = over;
    }
    vec3 step = -solve(matrix, gradient, problem.stiffness);
    const Part part = part_of(problem, x, smoothing, step, glm::dot(gradient, step));
    step *= part.taken;
    x += step;
    i = 0;
    for (Term& term : terms_of(problem)) {
        const vec3 moved = project(term, step);
        const vec3 m = term.distance;
        const double over = inverse[i++];
        term.dual = over * (term.strength * (m + moved) - glm::dot(m, moved) * over * term.dual);
        limit_dual(term);
        term.distance = project(term, x) - term.offset;
        if (part.falls_on && glm::dot(term.distance, term.distance) > smoothing * smoothing)
            term.dual =
                term.distance *
                (term.strength / std::sqrt(glm::dot(term.distance, term.distance) + smoothing * smoothing));
    }
    return part.good;
}

}  // namespace thaum::haptics::balancing
