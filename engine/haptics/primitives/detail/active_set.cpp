#include "haptics/primitives/detail/active_set.h"

#include <algorithm>

namespace thaum::haptics::balancing {

std::array<vec3, 2> normals_to(vec3 q) {
    const vec3 axis = std::abs(q.x) < 0.6 ? vec3(1, 0, 0) : vec3(0, 1, 0);
    const vec3 first = glm::normalize(axis - glm::dot(axis, q) * q);
    return {first, glm::cross(q, first)};
}

Term* only_active(Problem& problem) {
    Term* result = nullptr;
    for (Term& term : terms_of(problem)) {
        if (!term.active) continue;
        if (result != nullptr) return nullptr;
        result = &term;
    }
    return result;
}

void guess_active_set(Problem& problem, double square) {
    for (Term& term : terms_of(problem)) term.active = glm::dot(term.distance, term.distance) < square;
}

// ---- flat: the intersection of the active kinks -----------------------------------------------------------

namespace {

/// Moves x onto the plane q.x = height, without leaving the flat (the intersection of the kinks taken so
/// far). The flat then becomes its intersection with that plane. q is a unit vector.
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

/// Unit vector normal to a kink (point, line or plane) along which x can still move best within the flat, the
/// intersection of the kinks taken so far.
vec3 freest_normal(const Flat& flat, const Term& term) {
    if (term.identity == 0) return term.q;
    if (flat.count == 0) return normals_to(term.q)[0];
    const vec3 free = flat.count == 2 ? project(term, glm::cross(flat.normals[0], flat.normals[1]))
                                      : glm::cross(flat.normals[0], term.q);
    const double length = glm::length(free);
    return length > 1e-9 ? free / length : normals_to(term.q)[0];
}

/// Moves x onto the line or plane of a primitive, given by its term, and returns that line or plane.
Flat flat_of(const Term& term, vec3& x) {
    x -= project(term, x) - term.offset;
    if (term.identity == 0) return {{term.q}, 1};
    const auto normals = normals_to(term.q);
    return {{normals[0], normals[1]}, 2};
}

}  // namespace

Flat flat_of_active(Problem& problem, vec3& x) {
    Flat flat;
    for (const Term& term : terms_of(problem)) {
        if (!term.active || term.identity == 0 || term.dyad != 0) continue;
        x = term.offset;
        return {{vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)}, 3};
    }
    if (const Term* const only = only_active(problem)) return flat_of(*only, x);
    while (flat.count < 3) {
        const Term* best = nullptr;
        vec3 normal{};
        double most = 1e-12;
        for (const Term& term : terms_of(problem)) {
            if (!term.active) continue;
            const vec3 candidate = freest_normal(flat, term);
            const double left = glm::length(flat.along(candidate));
            if (left > most * (1 + 1e-9)) most = left, normal = candidate, best = &term;
        }
        if (best == nullptr) break;
        fix(flat, x, normal, glm::dot(normal, best->offset));
    }
    return flat;
}

// ---- Newton's method on the flat --------------------------------------------------------------------------

vec3 smooth_gradient(Problem& problem, vec3 x, Symmetric& matrix) {
    Symmetric sum = scaled_identity(problem.stiffness);
    vec3 gradient = problem.stiffness * x - problem.target;
    for (Term& term : terms_of(problem)) {
        if (term.active) continue;
        // The vector is projected twice: after the first time, rounding is a large part of a small distance.
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

namespace {

/// The energy's second derivative `m`, restricted to the flat, the space within which x may move. In the
/// other directions it gets the spring's stiffness, so that it stays invertible.
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

}  // namespace

vec3 newton_step(const Symmetric& m, const Flat& flat, vec3 slope, double stiffness) {
    if (flat.count == 0) return -solve(m, slope, stiffness);
    if (flat.count < 2) return -flat.along(solve(restricted(m, flat, stiffness), slope, stiffness));
    const vec3 free = glm::cross(flat.normals[0], flat.normals[1]);
    const double bend = std::max(stiffness, glm::dot(free, times(m, free)));
    return flat.along(free * (-glm::dot(free, slope) / bend));
}

namespace {

/// Sum of the strengths of the active terms (those on whose kink x is assumed to lie) (N).
double strength_of_active(const Problem& problem) {
    double result = 0;
    for (const Term& term : terms_of(problem)) result += term.active ? term.strength : 0;
    return result;
}

/// Newton's method for x on the flat (the intersection of the active kinks), without a change of the frame's
/// origin. Returns false if it does not converge.
bool minimise_on(Problem& problem, const Flat& flat, vec3& x, Symmetric& matrix, int& steps) {
    const double rounding = 4 * epsilon * (problem.strength + glm::length(problem.target));
    const double holding = strength_of_active(problem);
    double before = std::numeric_limits<double>::infinity();
    while (!budget_spent(steps)) {
        const vec3 gradient = smooth_gradient(problem, x, matrix);
        const vec3 slope = flat.along(gradient);
        const double size = glm::length(slope);
        if (size <= rounding) return true;
        if (flat.count > 0 && glm::length(gradient - slope) > holding + size) return true;
        // The slope did not halve: either rounding limits it, or the method does not converge.
        if (!(size < 0.5 * before)) return before <= 16 * rounding && size <= 16 * rounding;
        before = size;
        x += newton_step(matrix, flat, slope, problem.stiffness);
        ++steps;
    }
    return false;
}

/// Whether x is so far from the origin of its frame that the rounding of coordinates makes distances
/// inaccurate.
bool origin_is_far(const Problem& problem, vec3 x) {
    return glm::dot(x, x) > 16 * (1e-60 + glm::dot(world_of(problem, x), world_of(problem, x)));
}

}  // namespace

bool minimise_near(Problem& problem, Flat& flat, vec3& x, Symmetric& matrix, int& steps) {
    for (int frames = 0;; ++frames) {
        if (!minimise_on(problem, flat, x, matrix, steps)) return false;
        if (frames == 3 || !origin_is_far(problem, x)) return true;
        measure_distances(problem, x);
        move_origin(problem, x);
        flat = flat_of_active(problem, x);
    }
}

bool release(Problem& problem, const Symmetric& matrix, vec3 missing, vec3& x) {
    bool any = false;
    for (Term& term : terms_of(problem)) {
        if (!term.active) continue;
        const double square = glm::dot(term.dual, term.dual);
        if (square < (1 - 1e-9) * term.strength * term.strength) continue;
        term.active = false;
        any = true;
    }
    const vec3 d = missing;
    x -= d * (glm::dot(d, d) / glm::dot(d, times(matrix, d)));
    return any;
}

}  // namespace thaum::haptics::balancing
