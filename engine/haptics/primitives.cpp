#include "haptics/primitives.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>

// The method. A plane is a directed force of s/2 and s/2 |q.(x - p)|, so all kinks are of one form, s |P (x - p)| with an
// orthogonal projector P of rank 3 (point), 2 (line) or 1 (plane): a sum of Euclidean norms.
//
//  1. Smoothed problem: |m| becomes sqrt(|m|^2 + d^2). Newton's steps with the forces y as unknowns of their own
//     (Chan, Golub, Mulet 1999; Andersen, Christiansen, Conn, Overton 2000), d smaller at each. Degenerate sets (parallel,
//     coincident, meeting in a point) are nothing special here: the matrix is k I and something positive semidefinite.
//  2. Which kinks hold the proxy? Those with |m|^2 < d * (length of the problem): on the path m falls like d for them and
//     stays for the others. On what they have in common, a flat of dimension 0 to 3, the rest is smooth: Newton's method.
//  3. Can the held ones exert what is missing? If so, the sum is zero with forces that each can exert, which only the
//     one minimum allows: the proof does not depend on how the guess was made. If not, on with 1.
//
// The best kink to start from is tried before 1, which settles most small sets. Where 1 fails at two paces, the proxy descends
// from kink to kink. Why not always: that needs the steepest direction where several kinks meet, which is this problem again.
// Coordinates are relative to a point on the nearest kink, since a unit vector m / |m| is only as good as m. Should all fail, or
// the steps run out, the smoothed problem's best forces and place remain, whose duality gap bounds their error.

namespace thaum::haptics {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

bool spent(int steps) { return steps >= balance_step_budget; }

// ---- symmetric 3 by 3 matrices -------------------------------------------------------------------------------------

struct Symmetric {
    double xx{}, xy{}, xz{}, yy{}, yz{}, zz{};
};

Symmetric scaled_identity(double a) { return {a, 0, 0, a, 0, a}; }

/// M += a u u^T
void add_dyad(Symmetric& m, double a, vec3 u) {
    const vec3 v = a * u;
    m.xx += v.x * u.x, m.xy += v.x * u.y, m.xz += v.x * u.z;
    m.yy += v.y * u.y, m.yz += v.y * u.z, m.zz += v.z * u.z;
}

/// M += a (u v^T + v u^T)
void add_pair(Symmetric& m, double a, vec3 u, vec3 v) {
    const vec3 w = a * v;
    m.xx += 2 * w.x * u.x, m.xy += w.x * u.y + w.y * u.x, m.xz += w.x * u.z + w.z * u.x;
    m.yy += 2 * w.y * u.y, m.yz += w.y * u.z + w.z * u.y, m.zz += 2 * w.z * u.z;
}

void add_identity(Symmetric& m, double a) { m.xx += a, m.yy += a, m.zz += a; }

vec3 times(const Symmetric& m, vec3 v) {
    return {m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z,
            m.xz * v.x + m.yz * v.y + m.zz * v.z};
}

/// M x = b by L D L^T. A pivot below `least` is rounding error and taken for `least`.
inline vec3 solve(const Symmetric m, vec3 b, double least) {
    const double d0 = 1 / std::max(m.xx, least);
    const double l10 = m.xy * d0, l20 = m.xz * d0;
    const double d1 = 1 / std::max(m.yy - l10 * m.xy, least);
    const double u21 = m.yz - l20 * m.xy;
    const double l21 = u21 * d1;
    const double d2 = 1 / std::max(m.zz - l20 * m.xz - l21 * u21, least);
    const double y1 = b.y - l10 * b.x;
    const double y2 = b.z - l20 * b.x - l21 * y1;
    const double x2 = y2 * d2;
    const double x1 = y1 * d1 - l21 * x2;
    return {b.x * d0 - l10 * x1 - l20 * x2, x1, x2};
}

// ---- the problem ---------------------------------------------------------------------------------------------------

/// strength |P x - offset|, in the problem's frame; P = identity I + dyad q q^T.
struct Term {
    vec3 q;
    double identity, dyad;
    double strength;
    vec3 position, direction;  ///< world
    vec3 offset;
    vec3 dual;           ///< y: the term pulls with -y; |y| <= strength
    vec3 distance;       ///< m = P x - offset where it was last asked for
    double rounding;     ///< m: of the coordinates of its position, and a little of those of the farthest
    std::size_t source;  ///< index in the set
    bool held;           ///< x is taken to lie on its kink
};

/// Copies and clears no more than there are, for these are 4 KB and are copied at each guess.
struct Terms {
    std::array<Term, primitive_capacity> items;
    std::size_t count = 0;

    Terms() {}  // NOLINT(modernize-use-equals-default): that would clear the items
    Terms(const Terms& other) : count(other.count) { std::copy_n(other.items.begin(), count, items.begin()); }
    Terms& operator=(const Terms& other) {
        if (this == &other) return *this;
        count = other.count;
        std::copy_n(other.items.begin(), count, items.begin());
        return *this;
    }
    ~Terms() = default;
};

struct Problem {
    Terms terms;
    double stiffness{};
    vec3 centre{};      ///< world
    vec3 load{};        ///< N, constant forces
    vec3 origin{};      ///< world; x is from here, along
    mat3 axes{1};       ///< these columns,
    bool turned{};      ///< other than the world's
    vec3 target{};      ///< N: stiffness * (centre - origin) + load, in this frame
    double strength{};  ///< N, of all terms together
};

std::span<Term> terms_of(Problem& problem) { return {problem.terms.items.data(), problem.terms.count}; }
std::span<const Term> terms_of(const Problem& problem) {
    return {problem.terms.items.data(), problem.terms.count};
}

vec3 project(const Term& term, vec3 v) {
    return term.identity * v + term.dyad * glm::dot(term.q, v) * term.q;
}

void add_projector(Symmetric& m, const Term& term, double weight) {
    add_identity(m, weight * term.identity);
    add_dyad(m, weight * term.dyad, term.q);
}

/// A vector in the problem's frame, and one of that in the world's.
vec3 inward(const Problem& problem, vec3 v) { return problem.turned ? v * problem.axes : v; }
vec3 outward(const Problem& problem, vec3 v) { return problem.turned ? problem.axes * v : v; }

vec3 world_of(const Problem& problem, vec3 x) { return problem.origin + outward(problem, x); }

double rounding_of(vec3 position) { return 16 * epsilon * (1e-30 + glm::length(position)); }

/// Whether x is as near to the kink as the two can be told apart in the world's coordinates. Those of the place where x
/// would be without the terms do not count: that may be 1e12 times as far off.
bool touches(const Term& term, double rounding_of_x) {
    const double least = std::max(term.rounding, rounding_of_x);
    return glm::dot(term.distance, term.distance) <= least * least;
}

void measure_distances(Problem& problem, vec3 x) {
    for (Term& term : terms_of(problem)) term.distance = project(term, x) - term.offset;
}

void set_origin(Problem& problem, vec3 origin) {
    problem.origin = origin;
    problem.target = inward(problem, problem.stiffness * (problem.centre - origin) + problem.load);
    for (Term& term : terms_of(problem)) term.offset = project(term, inward(problem, term.position - origin));
}

/// What each kind makes of strength and direction. Tables and no branches: kinds come in any order.
constexpr std::array<double, 4> load_of_kind{1, 0, 0, 0.5}, identity_of_kind{0, 1, 1, 0},
    dyad_of_kind{0, 0, -1, 1}, strength_of_kind{0, 1, 1, 0.5};

/// All but the rounding and what set_origin finds.
void fill(Term& term, const Primitive& primitive, std::size_t source) {
    const auto kind = static_cast<std::size_t>(primitive.kind);
    // A point's may be anything, and is left out without a branch too.
    static constexpr vec3 none{};
    const vec3& direction = primitive.kind == PrimitiveKind::point ? none : primitive.direction;
    term.q = term.direction = direction;
    term.identity = identity_of_kind[kind];
    term.dyad = dyad_of_kind[kind];
    term.strength = strength_of_kind[kind] * primitive.strength;
    term.position = primitive.position;
    term.source = source;
}

/// Terms are those of strength that have a kink.
void take_primitives(Problem& problem, const PrimitiveSet& set) {
    std::size_t source = 0;
    for (const Primitive& primitive : set.items()) {
        Term& next = problem.terms.items[problem.terms.count];
        fill(next, primitive, source++);
        problem.load += load_of_kind[static_cast<std::size_t>(primitive.kind)] * primitive.strength * next.q;
        problem.strength += next.strength;
        problem.terms.count += next.strength > 0 ? 1 : 0;
    }
}

Problem problem_of(const PrimitiveSet& set, const Spring& spring) {
    Problem problem;  // with {} the compiler clears 3 KB
    problem.stiffness = spring.stiffness;
    problem.centre = spring.centre;
    take_primitives(problem, set);
    // Where kinks meet at the world's origin, coordinates have no size of their own.
    double farthest = 0;
    for (Term& term : terms_of(problem)) {
        const double size = glm::length(term.position);
        term.rounding = 16 * epsilon * (1e-30 + size);
        farthest = std::max(farthest, size);
    }
    for (Term& term : terms_of(problem)) term.rounding = std::max(term.rounding, epsilon * farthest);
    return problem;
}

void limit_dual(Term& term) {
    const double square = glm::dot(term.dual, term.dual);
    if (square > term.strength * term.strength) term.dual *= term.strength / std::sqrt(square);
}

// ---- 1: the smoothed problem ---------------------------------------------------------------------------------------

/// The smoothed problem's slope along the step, at the part t of it; N m.
double slope_along(const Problem& problem, vec3 x, double smoothing, vec3 step, double t) {
    double slope = glm::dot(problem.stiffness * (x + t * step) - problem.target, step);
    for (const Term& term : terms_of(problem)) {
        const vec3 moved = project(term, step);
        const vec3 m = term.distance + t * moved;
        slope += term.strength * glm::dot(m, moved) / std::sqrt(glm::dot(m, m) + smoothing * smoothing);
    }
    return slope;
}

/// Where on the step between low and high a kink is nearest: there the slope jumps. The middle where there is none.
double next_try(const Problem& problem, vec3 step, double low, double high) {
    for (const Term& term : terms_of(problem)) {
        const vec3 moved = project(term, step);
        const double t = -glm::dot(term.distance, moved) / glm::dot(moved, moved);
        if (t > low && t < high) return t;
    }
    return 0.5 * (low + high);
}

struct Part {
    double taken = 1;
    bool good = false;      ///< all of it, and the slope is small there
    bool falls_on = false;  ///< all of it, and it falls on
};

/// How much of the step to take: all of it, unless the smoothed problem rises there more steeply than a quarter of its fall
/// at the start; then about as far as to its lowest place.
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

/// One Newton step of x and of all forces. Whether it went as a quadratic problem would.
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

// ---- 2: on the held kinks ------------------------------------------------------------------------------------------

/// What the held kinks have in common: all x with directions . x fixed.
struct Flat {
    std::array<vec3, 3> normals{};  ///< orthonormal
    std::size_t count{};

    vec3 along(vec3 v) const {
        for (std::size_t i = 0; i < count; ++i) v -= glm::dot(normals[i], v) * normals[i];
        return v;
    }
};

/// Moves x within the flat onto q.x = height, and takes that up. q: unit.
void fix(Flat& flat, vec3& x, vec3 q, double height) {
    if (flat.count == 0) {
        x += q * (height - glm::dot(q, x));
        flat.normals[flat.count++] = q;
        return;
    }
    vec3 normal = flat.along(q);
    normal = glm::normalize(flat.along(glm::normalize(normal)));
    x += normal * ((height - glm::dot(q, x)) / glm::dot(q, normal));
    flat.normals[flat.count++] = normal;
}

/// Two unit vectors normal to q and each other.
std::array<vec3, 2> normals_to(vec3 q) {
    const vec3 axis = std::abs(q.x) < 0.6 ? vec3(1, 0, 0) : vec3(0, 1, 0);
    const vec3 first = glm::normalize(axis - glm::dot(axis, q) * q);
    return {first, glm::cross(q, first)};
}

/// Of the unit vectors normal to a kink the one that the flat leaves most free.
vec3 freest_normal(const Flat& flat, const Term& term) {
    if (term.identity == 0) return term.q;
    if (flat.count == 0) return normals_to(term.q)[0];
    const vec3 free = flat.count == 2 ? project(term, glm::cross(flat.normals[0], flat.normals[1]))
                                      : glm::cross(flat.normals[0], term.q);
    const double length = glm::length(free);
    return length > 1e-9 ? free / length : normals_to(term.q)[0];
}

/// The one that is held, where only one is.
Term* only_held(Problem& problem) {
    Term* result = nullptr;
    for (Term& term : terms_of(problem)) {
        if (!term.held) continue;
        if (result != nullptr) return nullptr;
        result = &term;
    }
    return result;
}

/// Puts x onto a line or plane.
Flat flat_of(const Term& term, vec3& x) {
    x -= project(term, x) - term.offset;
    if (term.identity == 0) return {{term.q}, 1};
    const auto normals = normals_to(term.q);
    return {{normals[0], normals[1]}, 2};
}

/// Puts x onto all held kinks: the one that the others leave most free first, since what is nearly fixed already is badly known. A
/// direction that is fixed is left to the check of distances.
Flat flat_of_held(Problem& problem, vec3& x) {
    Flat flat;
    for (const Term& term : terms_of(problem)) {
        if (!term.held || term.identity == 0 || term.dyad != 0) continue;
        x = term.offset;
        return {{vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)}, 3};
    }
    if (const Term* const only = only_held(problem)) return flat_of(*only, x);
    while (flat.count < 3) {
        const Term* best = nullptr;
        vec3 normal{};
        double most = 1e-12;
        for (const Term& term : terms_of(problem)) {
            if (!term.held) continue;
            const vec3 candidate = freest_normal(flat, term);
            const double left = glm::length(flat.along(candidate));
            if (left > most * (1 + 1e-9)) most = left, normal = candidate, best = &term;
        }
        if (best == nullptr) break;
        fix(flat, x, normal, glm::dot(normal, best->offset));
    }
    return flat;
}

/// The gradient of the smooth rest at x, N; infinite on the kink of a term that is not held. Matrix: its derivative. Of the
/// terms that are not held it leaves distances and pulls.
vec3 smooth_gradient(Problem& problem, vec3 x, Symmetric& matrix) {
    Symmetric sum = scaled_identity(problem.stiffness);
    vec3 gradient = problem.stiffness * x - problem.target;
    for (Term& term : terms_of(problem)) {
        if (term.held) continue;
        // Twice, since a small distance has been left a large part of rounding the other way.
        const vec3 distance = project(term, project(term, x) - term.offset);
        const double square = glm::dot(distance, distance);
        if (square == 0) return vec3(std::numeric_limits<double>::infinity());
        const double over = 1 / std::sqrt(square);
        const double weight = term.strength * over;
        const vec3 pull = weight * distance;
        gradient += pull;
        add_projector(sum, term, weight);
        add_dyad(sum, -weight * over * over, distance);
        term.distance = distance;
        term.dual = pull;
    }
    matrix = sum;
    return gradient;
}

/// The matrix on the flat, and k on what it fixes, so that it can be solved.
Symmetric restricted(const Symmetric& m, const Flat& flat, double stiffness) {
    Symmetric result = m;
    for (std::size_t i = 0; i < flat.count; ++i) {
        const vec3 n = flat.normals[i];
        const Symmetric& r = result;
        const vec3 rn = times(r, n);
        const double nrn = glm::dot(n, rn);
        add_pair(result, -1, n, rn);
        add_dyad(result, nrn + stiffness, n);
    }
    return result;
}

/// Newton's step from a slope along the flat.
vec3 newton_step(const Symmetric& m, const Flat& flat, vec3 slope, double stiffness) {
    if (flat.count == 0) return -solve(m, slope, stiffness);
    if (flat.count < 2) return -flat.along(solve(restricted(m, flat, stiffness), slope, stiffness));
    const vec3 free = glm::cross(flat.normals[0], flat.normals[1]);
    const double bend = std::max(stiffness, glm::dot(free, times(m, free)));
    return flat.along(free * (-glm::dot(free, slope) / bend));
}

/// N: of the held terms together.
double strength_of_held(const Problem& problem) {
    double result = 0;
    for (const Term& term : terms_of(problem)) result += term.held ? term.strength : 0;
    return result;
}

/// Newton's method on the flat. False where it does not converge: then x is not near, or some kink holds it after all. Ends
/// early where it is plain that the held ones cannot hold x.
bool minimise_on(Problem& problem, const Flat& flat, vec3& x, Symmetric& matrix, int& steps) {
    const double rounding = 4 * epsilon * (problem.strength + glm::length(problem.target));
    const double holding = strength_of_held(problem);
    double before = std::numeric_limits<double>::infinity();
    while (!spent(steps)) {
        const vec3 gradient = smooth_gradient(problem, x, matrix);
        const vec3 slope = flat.along(gradient);
        const double size = glm::length(slope);
        if (size <= rounding) return true;
        if (flat.count > 0 && glm::length(gradient - slope) > holding + size) return true;
        // Where rounding sets the floor, it cannot fall further.
        if (!(size < 0.5 * before)) return before <= 16 * rounding && size <= 16 * rounding;
        before = size;
        x += newton_step(matrix, flat, slope, problem.stiffness);
        ++steps;
    }
    return false;
}

// ---- 3: the proof --------------------------------------------------------------------------------------------------

/// How far the held kinks miss x, m; zero where it is the rounding of positions.
double spread_of_held(Problem& problem, vec3 x) {
    const double rounding = rounding_of(world_of(problem, x));
    double spread = 0;
    for (Term& term : terms_of(problem)) {
        if (!term.held) continue;
        term.distance = project(term, x) - term.offset;
        if (!touches(term, rounding)) spread = std::max(spread, glm::dot(term.distance, term.distance));
    }
    return std::sqrt(spread);
}

/// Distances at x and forces within the strengths.
void tidy(Problem& problem, vec3 x) {
    for (Term& term : terms_of(problem)) {
        term.distance = project(term, project(term, x) - term.offset);
        term.dual = project(term, term.dual);
        limit_dual(term);
    }
}

/// The residual at x, N, whatever was held: every force becomes the one that its primitive exerts there, where x does not
/// touch it.
double residual_at(Problem& problem, vec3 x) {
    tidy(problem, x);
    const double rounding = rounding_of(world_of(problem, x));
    vec3 missing = problem.stiffness * x - problem.target;
    for (Term& term : terms_of(problem)) {
        if (!touches(term, rounding))
            term.dual = term.distance * (term.strength / glm::length(term.distance));
        missing += term.dual;
    }
    return glm::length(missing);
}

/// N: what counts as solved.
constexpr double solved = 1e-9;

/// How far the most mistaken force is from the one that its primitive exerts at x, N.
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

/// The bound of the error, N, with the forces as they are: f is by k/2 |x - minimum|^2 above its minimum, and the dual
/// problem's value at these forces is below it.
double duality_bound(Problem& problem, vec3 x) {
    tidy(problem, x);
    vec3 missing = problem.stiffness * x - problem.target;
    double gap = 0;
    for (const Term& term : terms_of(problem)) {
        missing += term.dual;
        gap += std::max(0.0, term.strength * glm::length(term.distance) - glm::dot(term.dual, term.distance));
    }
    const double bound = std::sqrt(glm::dot(missing, missing) + 2 * problem.stiffness * gap);
    // The sum may be known while a strong force next to its kink is not: that is not solved.
    return bound <= solved && worst_misfit(problem, x) > solved ? 2 * solved : bound;
}

/// Spreads what is missing over the held terms by the room each has left, and again what did not fit. What is left, N.
vec3 balance_held(Problem& problem, vec3 x) {
    const vec3 gradient = problem.stiffness * x - problem.target;
    vec3 missing = gradient;
    std::size_t held = 0;
    for (Term& term : terms_of(problem)) {
        if (!term.held) missing += term.dual;
        held += term.held ? 1 : 0;
    }
    if (held == 0) return missing;
    if (Term* const only = held == 1 ? only_held(problem) : nullptr) {
        only->dual = -project(*only, missing);
        limit_dual(*only);
        return missing + only->dual;
    }
    const double rounding = 2 * epsilon * (problem.strength + glm::length(gradient));
    for (Term& term : terms_of(problem)) {
        if (term.held) term.dual = project(term, term.dual);
    }
    double before = std::numeric_limits<double>::infinity();
    for (;;) {
        missing = gradient;
        Symmetric room;
        double most = 0;
        for (Term& term : terms_of(problem)) {
            missing += term.dual;
            if (!term.held) continue;
            const double left = 1.01 * term.strength - glm::length(term.dual);
            add_projector(room, term, left);
            most += left;
        }
        const double size = glm::length(missing);
        if (size <= rounding || most == 0 || size > 0.7 * before) return missing;
        before = size;
        add_identity(room, 1e-14 * most);
        const vec3 share = solve(room, missing, 1e-14 * most);
        for (Term& term : terms_of(problem)) {
            if (!term.held) continue;
            const double left = 1.01 * term.strength - glm::length(term.dual);
            term.dual -= left * project(term, share);
            limit_dual(term);
        }
    }
}

// ---- all together --------------------------------------------------------------------------------------------------

/// The best place so far.
struct Answer {
    vec3 proxy;  ///< m, world
    double residual = std::numeric_limits<double>::infinity();
    std::array<vec3, primitive_capacity> pulls;  ///< N, world: of the terms, in their order
};

/// Takes x and the forces as they are, where they are better.
void improve(Answer& best, const Problem& problem, vec3 x, double residual) {
    if (!(residual < best.residual)) return;
    best.residual = residual;
    best.proxy = world_of(problem, x);
    std::size_t i = 0;
    for (const Term& term : terms_of(problem)) best.pulls[i++] = -outward(problem, term.dual);
}

/// Takes the point of the nearest kink next to x as origin, so that small distances are known to full precision. Not
/// where the origin is nearer.
void move_origin(Problem& problem, vec3& x) {
    const Term* nearest = nullptr;
    double least = glm::dot(x, x);
    for (Term& term : terms_of(problem)) {
        const double square = glm::dot(term.distance, term.distance);
        if (square < least) least = square, nearest = &term;
    }
    if (nearest == nullptr) return;
    const bool is_point = nearest->dyad == 0;
    const vec3 before = problem.origin;
    const vec3 distance = nearest->distance;
    set_origin(problem, is_point ? nearest->position : before + outward(problem, x - distance));
    x = is_point ? distance : x + inward(problem, before - problem.origin);
    measure_distances(problem, x);
}

/// Whether the origin is so far off that distances at x are not known to the rounding of the coordinates.
bool origin_is_far(const Problem& problem, vec3 x) {
    return glm::dot(x, x) > 16 * (1e-60 + glm::dot(world_of(problem, x), world_of(problem, x)));
}

void guess_held(Problem& problem, double square) {
    for (Term& term : terms_of(problem)) term.held = glm::dot(term.distance, term.distance) < square;
}

/// Newton's method on the flat, from a nearer origin where x has gone far from this one.
bool minimise_near(Problem& problem, Flat& flat, vec3& x, Symmetric& matrix, int& steps) {
    for (int frames = 0;; ++frames) {
        if (!minimise_on(problem, flat, x, matrix, steps)) return false;
        if (frames == 3 || !origin_is_far(problem, x)) return true;
        measure_distances(problem, x);
        move_origin(problem, x);
        flat = flat_of_held(problem, x);
    }
}

/// Lets go of the kinks whose force is at its limit, and goes down the way that is left, to where the minimum would be
/// if they pulled on alike. False where there is none to let go of.
bool release(Problem& problem, const Symmetric& matrix, vec3 missing, vec3& x) {
    bool any = false;
    for (Term& term : terms_of(problem)) {
        if (!term.held) continue;
        const double square = glm::dot(term.dual, term.dual);
        if (square < (1 - 1e-9) * term.strength * term.strength) continue;
        term.held = false;
        any = true;
    }
    const vec3 d = missing;
    x -= d * (glm::dot(d, d) / glm::dot(d, times(matrix, d)));
    return any;
}

/// Turns the frame so that the held kinks lie along its axes: where they are many times stiffer than the rest, the
/// matrix must have true zeros in the directions they leave free.
void align(Problem& problem, vec3& x) {
    vec3 unused{};
    const Flat flat = flat_of_held(problem, unused);
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
        if (!term.held) continue;
        for (int i = 0; i < 3; ++i) {
            if (std::abs(term.q[i]) < 4 * epsilon) term.q[i] = 0;
        }
        if (term.dyad != 0) term.q = glm::normalize(term.q);
    }
    set_origin(problem, problem.origin);
    measure_distances(problem, x);
}

/// Steps 2 and 3 from the smoothed state, whose kinks are held up to a distance: improves on `best` by up to four guesses. By how much
/// the held kinks miss each other, m, where that was in the way; else 0.
double settle(Problem& problem, vec3 x, double square, double accepted, Answer& best, int& steps) {
    move_origin(problem, x);
    guess_held(problem, square);
    for (int tries = 0; tries < 4; ++tries) {
        Flat flat = flat_of_held(problem, x);
        const double spread = spread_of_held(problem, x);
        if (spread > 0) return spread;
        Symmetric matrix;
        if (!minimise_near(problem, flat, x, matrix, steps)) break;
        const vec3 missing = balance_held(problem, x);
        // What is not held exerts what it does at x; so do the held ones, if x has stayed on their kinks.
        const bool stayed = spread_of_held(problem, x) == 0;
        improve(best, problem, x, stayed ? glm::length(missing) : residual_at(problem, x));
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

/// J, at x; or some number above `most` where it is more than that.
double energy(const Problem& problem, vec3 x, double most) {
    double result = 0.5 * problem.stiffness * glm::dot(x, x) - glm::dot(problem.target, x);
    for (const Term& term : terms_of(problem)) {
        if (result > most) break;
        result += term.strength * glm::length(project(term, x) - term.offset);
    }
    return result;
}

/// The best of where x would be without the terms and its nearest places on their kinks.
vec3 start_of(const Problem& problem, vec3 free) {
    vec3 best = free;
    double least = energy(problem, free, std::numeric_limits<double>::infinity());
    for (const Term& term : terms_of(problem)) {
        const vec3 foot = free - term.distance;
        const double here = energy(problem, foot, least);
        if (here < least) least = here, best = foot;
    }
    return best;
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

/// Few sets take more; from then on the smoothed answer itself is kept too, should the proof never succeed.
constexpr int hard_rounds = 12;

/// From x on, until the proof succeeds. Improves on `best`.
void follow(Problem problem, vec3 x, const Pace& pace, double accepted, Answer& best, int& steps) {
    double length = length_of(problem);
    x = start_of(problem, x);
    measure_distances(problem, x);
    double smoothing = 0.3 * length;
    for (int round = 0; round < pace.rounds && !spent(steps); ++round) {
        if (problem.strength > 1e6 * problem.stiffness * smoothing) {
            move_origin(problem, x);
            guess_held(problem, smoothing * std::max(length, 9 * smoothing));
            align(problem, x);
        }
        const bool good = smoothed_step(problem, x, smoothing);
        ++steps;
        if (round >= hard_rounds) {
            const double bound = duality_bound(problem, x);
            improve(best, problem, x, bound);
        }
        if (round >= 3) {
            const bool small = round >= hard_rounds && round % 2 == 1;  // kinks that nearly meet
            const double square = smoothing * std::max(small ? 0 : length, 9 * smoothing);
            Problem guess = problem;
            const double spread = settle(guess, x, square, accepted, best, steps);
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

// ---- where the path fails ------------------------------------------------------------------------------------------
//
// From kink to kink, always down: slower, and the steepest direction where kinks meet comes from rounds over their forces.
// It serves a few sets in a million, such as kinks that miss each other by a billionth of the rest.

/// The least sum of the gradient and the held forces: each in turn takes the best of its own. Converges to it.
vec3 least_missing(Problem& problem, vec3 x, int& steps) {
    const vec3 gradient = problem.stiffness * x - problem.target;
    vec3 missing = gradient;
    for (const Term& term : terms_of(problem)) missing += term.dual;
    const double rounding = epsilon * problem.strength;
    for (int round = 0; round < 200; ++round) {
        if (round % 16 == 15) ++steps;  // as dear as one
        double change = 0;
        for (Term& term : terms_of(problem)) {
            if (!term.held) continue;
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

/// The slope along the step without the term `but`, and with no smoothing.
double sharp_slope(const Problem& problem, vec3 x, vec3 step, double t, const Term* but) {
    double slope = glm::dot(problem.stiffness * (x + t * step) - problem.target, step);
    for (const Term& term : terms_of(problem)) {
        if (term.held || &term == but) continue;
        const vec3 moved = project(term, step);
        const vec3 m = term.distance + t * moved;
        const double size = glm::length(m);
        if (size > 0) slope += term.strength * glm::dot(m, moved) / size;
    }
    return slope;
}

/// The first kink between low and high that the step runs into, and where.
Term* first_hit(Problem& problem, vec3 x, vec3 step, double low, double& high) {
    Term* result = nullptr;
    const double rounding = rounding_of(world_of(problem, x));
    for (Term& term : terms_of(problem)) {
        const vec3 moved = project(term, step);
        const double square = glm::dot(moved, moved);
        // Where it starts on a kink, that has been let go of.
        if (term.held || square == 0 || touches(term, rounding)) continue;
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

/// Goes along the step to the lowest place, which may be a kink: that is then held. At most eight times the step.
void go_down(Problem& problem, vec3& x, vec3 step) {
    const double fall = -sharp_slope(problem, x, step, 0, nullptr);
    double low = 0, high = 8;
    for (int hits = 0; hits < 16; ++hits) {
        double t = high;
        Term* const hit = first_hit(problem, x, step, low, t);
        const double jump = hit == nullptr ? 0 : hit->strength * glm::length(project(*hit, step));
        const double slope = sharp_slope(problem, x, step, t, hit);
        if (slope - jump < 0 && slope + jump > 0) {
            hit->held = true;
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

/// Holds whatever x touches.
void hold_touched(Problem& problem, vec3 x) {
    measure_distances(problem, x);
    const double rounding = rounding_of(world_of(problem, x));
    for (Term& term : terms_of(problem)) term.held = term.held || touches(term, rounding);
}

void descend(Problem problem, vec3 x, double accepted, Answer& best, int& steps) {
    double before = std::numeric_limits<double>::infinity();
    for (Term& term : terms_of(problem)) term.held = false;
    for (int tries = 0; tries < 40 && !spent(steps); ++tries, ++steps) {
        measure_distances(problem, x);
        move_origin(problem, x);
        hold_touched(problem, x);
        const Flat flat = flat_of_held(problem, x);
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
            if (!term.held) term.dual = term.distance * (term.strength / glm::length(term.distance));
        }
        const vec3 missing = least_missing(problem, x, steps);
        const double residual = residual_at(problem, x);
        improve(best, problem, x, residual);
        vec3 there = x;
        if (residual <= accepted || !release(problem, matrix, missing, there)) break;
        vec3 unused = x;
        go_down(problem, x, flat_of_held(problem, unused).along(there - x));
    }
}

/// At x, which is where the proxy would be without the terms.
void begin(Problem& problem, vec3 x) {
    set_origin(problem, problem.centre);
    for (Term& term : terms_of(problem)) term.dual = {}, term.held = false;
    measure_distances(problem, x);
}

/// The best start, held where it is, and what becomes of it when it is let go of: settles nine of ten small sets.
void settle_start(Problem& problem, vec3 x, double accepted, Answer& best, int& steps) {
    x = start_of(problem, x);
    measure_distances(problem, x);
    const double touching = 2 * rounding_of(world_of(problem, x));
    settle(problem, x, touching * touching, accepted, best, steps);
}

void solve(Problem& problem, Answer& best, int& steps) {
    const vec3 x = problem.load / problem.stiffness;
    begin(problem, x);
    if (problem.terms.count == 0) return improve(best, problem, x, 0);
    const double accepted = 256 * epsilon * (problem.strength + glm::length(problem.load));
    settle_start(problem, x, accepted, best, steps);
    if (best.residual <= accepted) return;
    begin(problem, x);
    static constexpr std::array paces{Pace{0.1, 0.3, 0.01, 24}, Pace{0.3, 1, 0.05, 60},
                                      Pace{0.5, 1, 0.2, 150}};
    for (const Pace& pace : paces) {
        follow(problem, x, pace, accepted, best, steps);
        if (best.residual <= accepted || spent(steps)) return;
    }
    descend(problem, start_of(problem, x), accepted, best, steps);
}

bool in_range(const Spring& spring) {
    const auto in = [](double a) { return std::abs(a) <= primitive_limit; };
    return in(spring.centre.x) && in(spring.centre.y) && in(spring.centre.z) && spring.stiffness >= 1e-6 &&
           spring.stiffness <= 1e9;
}

/// What each primitive exerts, from the pulls of the terms.
void share_forces(const PrimitiveSet& set, const Problem& problem, const Answer& answer, Balance& result) {
    std::size_t i = 0;
    for (const Primitive& primitive : set.items()) {
        if (primitive.kind == PrimitiveKind::directed)
            result.primitive[i] = primitive.strength * primitive.direction;
        ++i;
    }
    i = 0;
    for (const Term& term : terms_of(problem)) {
        vec3& force = result.primitive[term.source] = answer.pulls[i++];
        if (term.identity == 0) force += term.strength * term.direction;
    }
    for (std::size_t k = 0; k < set.items().size(); ++k) result.force += result.primitive[k];
}

}  // namespace

PrimitiveFault fault_of(const Primitive& primitive) noexcept {
    const bool has_position = primitive.kind != PrimitiveKind::directed;
    const bool has_direction = primitive.kind != PrimitiveKind::point;
    if (!std::isfinite(primitive.strength) || (has_position && !is_finite(primitive.position)) ||
        (has_direction && !is_finite(primitive.direction)))
        return PrimitiveFault::not_finite;
    if (primitive.strength < 0) return PrimitiveFault::negative;
    if (primitive.strength > primitive_limit) return PrimitiveFault::out_of_range;
    if (has_position && glm::length(primitive.position) > primitive_limit)
        return PrimitiveFault::out_of_range;
    if (has_direction && std::abs(glm::length(primitive.direction) - 1) > 1e-6)
        return PrimitiveFault::not_unit;
    return PrimitiveFault::none;
}

PrimitiveFault PrimitiveSet::add(const Primitive& primitive) noexcept {
    if (count_ == items_.size()) return PrimitiveFault::full;
    const auto fault = fault_of(primitive);
    if (fault != PrimitiveFault::none) return fault;
    Primitive& taken = items_[count_++] = primitive;
    if (taken.kind != PrimitiveKind::point) taken.direction = glm::normalize(taken.direction);
    return fault;
}

Expected<PrimitiveSet> checked(std::span<const Primitive> primitives) {
    static constexpr std::array words{"",
                                      "one too many: there is room for 16",
                                      "a field is not finite",
                                      "position or strength is beyond 1e6",
                                      "strength is negative",
                                      "the direction is not a unit vector"};
    PrimitiveSet set;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
        const auto fault = set.add(primitives[i]);
        if (fault != PrimitiveFault::none)
            return fail("primitive " + std::to_string(i) + ": " + words[static_cast<std::size_t>(fault)]);
    }
    return set;
}

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
    if (!in_range(spring)) {
        result.residual = std::numeric_limits<double>::infinity();
        return result;
    }
    Problem problem = problem_of(set, spring);
    Answer answer;
    solve(problem, answer, result.steps);
    result.proxy = answer.proxy;
    result.residual = answer.residual;
    share_forces(set, problem, answer, result);
    return result;
}

}  // namespace thaum::haptics
