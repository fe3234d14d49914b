#include "haptics/primitives/balance.h"

#include <algorithm>
#include <cmath>

#include "haptics/primitives/detail/balance_descent.h"
#include "haptics/primitives/detail/smoothed_problem.h"

// Method. Let x be the place of the proxy that is sought. Each primitive adds a term s |m| to the energy: s
// is its strength and m the vector from its point, line or plane to x (balance_problem.h). Where m is zero,
// the term has a kink. A kink is active if it is assumed to hold x.
//
//  1. Smoothed problem (smoothed_problem.h): Newton's method, with a smaller smoothing d at each step.
//  2. Active set (active_set.h): the kinks with |m|^2 < d * (length of the problem). As d falls, m falls in
//     proportion for the kinks that hold the proxy, and hardly changes for the others. On the intersection
//     of the active kinks, the other terms are smooth.
//  3. Optimality check (optimality_check.h): can the active kinks exert the missing force? If not, back to 1.
//
// Before step 1, the kink with the least energy is tried as the active one, which solves most small sets. If
// step 1 fails with three settings, the proxy descends from kink to kink (balance_descent.h). The descent is
// not the usual way because where several kinks meet it needs the steepest direction, which is as hard to
// find as the minimum. Coordinates are relative to a point on the nearest kink, because a unit vector m / |m|
// is only as accurate as m. If everything fails or the steps run out, the best forces so far are improved one
// by one (optimality_check.h). The duality gap then bounds the error: lines that differ from parallel by
// 1e-12 end there, within 1 mN.

namespace thaum::haptics {
namespace balancing {
namespace {

/// Rotates the problem's frame so that the active kinks (points, lines or planes assumed to hold x) lie along
/// its axes. If their terms are many times stiffer than the others, the matrix needs exact zeros in the
/// directions that the kinks leave free.
void align(Problem& problem, vec3& x) {
    vec3 unused{};
    const Flat flat = flat_of_active(problem, unused);
    mat3 turn(1);  // columns are the new axes in the old frame
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

/// Guesses from x which kinks are active, that is hold the proxy, finds the minimum on them, and checks it
/// (steps 2 and 3 of the method above). The first guess is all kinks at a squared distance below `square`
/// (m^2). Up to four guesses are tried, and `best` keeps the best place. If no place lies on all active
/// kinks, returns the distance by which they miss each other (m), else 0.
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
        // A term that is not assumed to hold x has the force that it exerts at x. The force of an active
        // term, which is assumed to hold x, is right only if x is still on its kink.
        const bool stayed = spread_of_active(problem, x) == 0;
        keep_if_better(best, problem, x, stayed ? glm::length(missing) : residual_at(problem, x));
        if (best.residual <= accepted || !release(problem, matrix, missing, x)) break;
    }
    return 0;
}

/// Length of the problem (m): the largest distance by which the terms can move x from where the spring and
/// the constant forces alone would put it; at least the rounding of coordinates there.
double length_of(Problem& problem) {
    double farthest = 0;
    for (const Term& term : terms_of(problem)) farthest = std::max(farthest, glm::length(term.distance));
    return std::max(std::min(problem.strength / problem.stiffness, farthest),
                    4 * rounding_of(problem.centre));
}

/// Settings of how fast the smoothing shrinks. `good` and `poor` are multiples of three gaps. The gap (m) is
/// how far x is from obeying the smoothed problem, see next_smoothing().
struct Pace {
    double good;   ///< new smoothing in units of three gaps, after a step as exact as on a quadratic problem
    double poor;   ///< new smoothing in units of three gaps, after a less exact step
    double least;  ///< smallest ratio of the new smoothing to the last smoothing
    int rounds;    ///< largest number of Newton steps
};

/// Computes the next smoothing (m). Each term has the distance m from its kink, the strength s and the force
/// -y. The gap is the largest difference, over all terms, of |m| and its lower bound y.m / s. At a minimum of
/// the smoothed problem it is at most 0.3 of the smoothing. If it is larger, x is far from that minimum, and
/// the smoothing must not shrink before x has come nearer.
double next_smoothing(Problem& problem, double smoothing, bool good, const Pace& pace) {
    double gap = 0;
    for (const Term& term : terms_of(problem))
        gap = std::max(gap, glm::length(term.distance) - glm::dot(term.dual, term.distance) / term.strength);
    return std::clamp((good ? pace.good : pace.poor) * 3 * gap, pace.least * smoothing, 3 * smoothing);
}

/// Number of Newton steps that nearly all sets of primitives need at most. After it, the solution of the
/// smoothed problem is a candidate for `best` too, in case the optimality check never succeeds.
constexpr int hard_rounds = 12;

/// Minimises smoothed problems of less and less smoothing, starting at x, until the optimality check
/// succeeds. `best` keeps the best place.
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
            // A kink is the point, line or plane at which a primitive can hold x. If many rounds have failed,
            // several kinks may nearly meet, and not all of them hold x. So every second round assumes that
            // only the nearest ones do.
            const bool small = round >= hard_rounds && round % 2 == 1;
            const double square = smoothing * std::max(small ? 0 : length, 9 * smoothing);
            Problem guess = problem;
            const double spread = try_active_sets(guess, x, square, accepted, best, steps);
            if (best.residual <= accepted) return;
            if (spread > 0 && spread < smoothing) {
                // Kinks that miss each other by less than the smoothing look like one. The search goes on at
                // the scale of that distance.
                move_origin(problem, x);
                length = 4 * spread;
            }
        }
        smoothing = std::max(next_smoothing(problem, smoothing, good, pace), 1e-14 * length);
    }
}

/// Sets the problem back to its start: no kink (point, line or plane) is assumed to hold x, no term (the
/// energy of one kink) exerts a force, and distances are those at x, the place of the proxy without the
/// terms.
void reset(Problem& problem, vec3 x) {
    set_origin(problem, problem.centre);
    for (Term& term : terms_of(problem)) term.dual = {}, term.active = false;
    measure_distances(problem, x);
}

/// Starts at the place of least energy among these: the one to which spring and constant forces alone would
/// take the proxy, and the nearest one to it on each kink. The kinks at the start are assumed to hold x; up
/// to three other guesses follow from them. This solves nine of ten small sets.
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

/// Computes the force of each primitive from that of its term, its part of the energy. The energy of a plane
/// is split into a term and a constant force, so both forces are added.
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
    // The shift of the spring's centre is a sum of small differences. So no rounding moves the centre of a
    // probe that rests far from the origin.
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
