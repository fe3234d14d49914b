#include "haptics/balance.h"

#include <algorithm>
#include <cmath>

#include "haptics/balance_descent.h"
#include "haptics/smoothed_problem.h"

// The method. All kinks are of one form, a norm (balance_problem.h).
//
//  1. The smoothed problem (smoothed_problem.h): Newton's steps, the smoothing d smaller at each.
//  2. Which kinks hold the proxy? Those with |m|^2 < d * (length of the problem): on the path m falls like d for them and
//     stays for the others. On what they have in common the rest is smooth (active_set.h).
//  3. Can the active ones exert what is missing (optimality_check.h)? If not, on with 1.
//
// The best kink to start from is tried before 1, which settles most small sets. Where 1 fails at three paces, the proxy descends from
// kink to kink (balance_descent.h). Why not always: that needs the steepest direction where several kinks meet, which is this
// problem again. Coordinates are relative to a point on the nearest kink, since a unit vector m / |m| is only as good as m. Should
// all fail, or the steps run out, the best forces so far are improved one by one (optimality_check.h), and the duality gap bounds the
// error: lines that are parallel but for 1e-12 end there, within 1 mN.

namespace thaum::haptics {
namespace balancing {
namespace {

/// Turns the frame so that the active kinks lie along its axes: where they are many times stiffer than the rest, the
/// matrix must have true zeros in the directions they leave free.
void align(Problem& problem, vec3& x) {
    vec3 unused{};
    const Flat flat = flat_of_active(problem, unused);
    mat3 turn(1);  // columns: the new axes in the old frame
    if (flat.count == 0 || flat.count == 3) return;
    turn[0] = flat.normals[0];
    turn[1] = flat.count == 2 ? flat.normals[1] : normals_to(turn[0])[0];
    turn[2] = glm::normalize(glm::cross(turn[0], turn[1]));
    problem.axes = problem.axes * turn;
    problem.turned = true;
    x = x * turn;
    for (Term& term : terms_of(problem)) {
        term.q = term.direction * problem.axes;
        term.dual = term.dual * turn;
        if (!term.active) continue;
        for (int i = 0; i < 3; ++i) {
            if (std::abs(term.q[i]) < 4 * epsilon) term.q[i] = 0;
        }
        if (term.dyad != 0) term.q = glm::normalize(term.q);
    }
    set_origin(problem, problem.origin);
    measure_distances(problem, x);
}

/// Steps 2 and 3 from the smoothed state, whose kinks are active up to a distance: improves on `best` by up to four guesses. By how much
/// the active kinks miss each other, m, where that was in the way; else 0.
double try_active_sets(Problem& problem, vec3 x, double square, double accepted, Solution& best, int& steps) {
    move_origin(problem, x);
    guess_active_set(problem, square);
    for (int tries = 0; tries < 4; ++tries) {
        Flat flat = flat_of_active(problem, x);
        const double spread = spread_of_active(problem, x);
        if (spread > 0) return spread;
        Symmetric matrix;
        if (!minimise_near(problem, flat, x, matrix, steps)) break;
        const vec3 missing = balance_active(problem, x);
        // What is not active exerts what it does at x; so do the active ones, if x has stayed on their kinks.
        const bool stayed = spread_of_active(problem, x) == 0;
        keep_if_better(best, problem, x, stayed ? glm::length(missing) : residual_at(problem, x));
        if (best.residual <= accepted || !release(problem, matrix, missing, x)) break;
    }
    return 0;
}

/// How far the terms can move x from where it is without them; at least the rounding there.
double length_of(Problem& problem) {
    double farthest = 0;
    for (const Term& term : terms_of(problem)) farthest = std::max(farthest, glm::length(term.distance));
    return std::max(std::min(problem.strength / problem.stiffness, farthest),
                    4 * rounding_of(problem.centre));
}

/// How fast the smoothing follows the gap.
struct Pace {
    double good;   ///< of the gap, after a step that went as a quadratic problem would
    double poor;   ///< after another
    double least;  ///< of the smoothing before
    int rounds;
};

/// The next smoothing. On the path the gap between |m| and its lower bound y.m / s is at most 0.3 of the smoothing; far
/// from the path it is more, and the smoothing must not run ahead.
double next_smoothing(Problem& problem, double smoothing, bool good, const Pace& pace) {
    double gap = 0;
    for (const Term& term : terms_of(problem))
        gap = std::max(gap, glm::length(term.distance) - glm::dot(term.dual, term.distance) / term.strength);
    return std::clamp((good ? pace.good : pace.poor) * 3 * gap, pace.least * smoothing, 3 * smoothing);
}

/// Few sets take more; from then on the smoothed solution itself is kept too, should the proof never succeed.
constexpr int hard_rounds = 12;

/// From x on, until the proof succeeds. Improves on `best`.
void follow_path(Problem problem, vec3 x, const Pace& pace, double accepted, Solution& best, int& steps) {
    double length = length_of(problem);
    x = start_of(problem, x);
    measure_distances(problem, x);
    double smoothing = 0.3 * length;
    for (int round = 0; round < pace.rounds && !budget_spent(steps); ++round) {
        if (problem.strength > 1e6 * problem.stiffness * smoothing) {
            move_origin(problem, x);
            guess_active_set(problem, smoothing * std::max(length, 9 * smoothing));
            align(problem, x);
        }
        const bool good = smoothed_step(problem, x, smoothing);
        ++steps;
        if (round >= hard_rounds) {
            const double bound = duality_bound(problem, x);
            keep_if_better(best, problem, x, bound);
        }
        if (round >= 3) {
            const bool small = round >= hard_rounds && round % 2 == 1;  // kinks that nearly meet
            const double square = smoothing * std::max(small ? 0 : length, 9 * smoothing);
            Problem guess = problem;
            const double spread = try_active_sets(guess, x, square, accepted, best, steps);
            if (best.residual <= accepted) return;
            if (spread > 0 && spread < smoothing) {
                // From here these kinks look like one: nearer.
                move_origin(problem, x);
                length = 4 * spread;
            }
        }
        smoothing = std::max(next_smoothing(problem, smoothing, good, pace), 1e-14 * length);
    }
}

/// At x, which is where the proxy would be without the terms.
void reset(Problem& problem, vec3 x) {
    set_origin(problem, problem.centre);
    for (Term& term : terms_of(problem)) term.dual = {}, term.active = false;
    measure_distances(problem, x);
}

/// The best start, active where it is, and what becomes of it when it is let go of: settles nine of ten small sets.
void try_start(Problem& problem, vec3 x, double accepted, Solution& best, int& steps) {
    x = start_of(problem, x);
    measure_distances(problem, x);
    const double touching = 2 * rounding_of(world_of(problem, x));
    try_active_sets(problem, x, touching * touching, accepted, best, steps);
}

void find_solution(Problem& problem, Solution& best, int& steps) {
    const vec3 x = problem.load / problem.stiffness;
    reset(problem, x);
    if (problem.terms.count == 0) return keep_if_better(best, problem, x, 0);
    const double accepted = 256 * epsilon * (problem.strength + glm::length(problem.load));
    try_start(problem, x, accepted, best, steps);
    if (best.residual <= accepted) return;
    reset(problem, x);
    static constexpr std::array paces{Pace{0.1, 0.3, 0.01, 24}, Pace{0.3, 1, 0.05, 60},
                                      Pace{0.5, 1, 0.2, 150}};
    for (const Pace& pace : paces) {
        follow_path(problem, x, pace, accepted, best, steps);
        if (best.residual <= accepted) return;
        if (budget_spent(steps)) break;
    }
    if (!budget_spent(steps)) descend(problem, start_of(problem, x), accepted, best, steps);
    if (best.residual > accepted) improve_by_dual_ascent(problem, accepted, best, steps);
}

bool in_range(const Spring& spring) {
    const auto in = [](double a) { return std::abs(a) <= primitive_limit; };
    return in(spring.centre.x) && in(spring.centre.y) && in(spring.centre.z) && spring.stiffness >= 1e-6 &&
           spring.stiffness <= 1e9;
}

/// What each primitive exerts, from the pulls of the terms.
void share_forces(const PrimitiveSet& set, const Problem& problem, const Solution& solution,
                  Balance& result) {
    std::size_t i = 0;
    for (const Primitive& primitive : set.items()) {
        if (primitive.kind == PrimitiveKind::directed)
            result.primitive[i] = primitive.strength * primitive.direction;
        ++i;
    }
    i = 0;
    for (const Term& term : terms_of(problem)) {
        vec3& force = result.primitive[term.source] = solution.pulls[i++];
        if (term.identity == 0) force += term.strength * term.direction;
    }
    for (std::size_t k = 0; k < set.items().size(); ++k) result.force += result.primitive[k];
}

}  // namespace
}  // namespace balancing

Spring effective_spring(const ProxyCoupling& coupling, vec3 probe, vec3 probe_velocity, vec3 proxy_before,
                        double period) noexcept {
    const double damper = coupling.damping / period;
    const double stiffness = coupling.stiffness + damper;
    // As a sum of small parts, so that a still probe far from the origin is not moved by rounding.
    const vec3 shift = damper * (proxy_before - probe) + coupling.damping * probe_velocity;
    return {probe + shift / stiffness, stiffness};
}

Balance balance(const PrimitiveSet& set, const Spring& spring) noexcept {
    Balance result{.proxy = spring.centre};
    if (!balancing::in_range(spring)) {
        result.residual = std::numeric_limits<double>::infinity();
        return result;
    }
    auto problem = balancing::problem_of(set, spring);
    balancing::Solution solution;
    balancing::find_solution(problem, solution, result.steps);
    result.proxy = solution.proxy;
    result.residual = solution.residual;
    balancing::share_forces(set, problem, solution, result);
    return result;
}

}  // namespace thaum::haptics
