#include "haptics/primitives/detail/balance_problem.h"

#include <algorithm>

namespace thaum::haptics::balancing {
namespace {

/// Factors for each PrimitiveKind (directed, point, line, plane): of the strength in the constant force, of
/// the identity I and of q q^T (q: direction) in the projector, and of the strength in the term. They are
/// tables, because kinds come in any order and branches would be mispredicted.
constexpr std::array<double, 4> load_of_kind{1, 0, 0, 0.5}, identity_of_kind{0, 1, 1, 0},
    dyad_of_kind{0, 0, -1, 1}, strength_of_kind{0, 1, 1, 0.5};

/// Fills a term (the energy of a primitive with a kink) except for its rounding and the values that
/// set_origin computes.
void fill(Term& term, const Primitive& primitive, std::size_t source) {
    const auto kind = static_cast<std::size_t>(primitive.kind);
    // The direction of a point primitive may have any value, so zero replaces it. This needs no branch
    // either.
    static constexpr vec3 none{};
    const vec3& direction = primitive.kind == PrimitiveKind::point ? none : primitive.direction;
    term.q = term.direction = direction;
    term.identity = identity_of_kind[kind];
    term.dyad = dyad_of_kind[kind];
    term.strength = strength_of_kind[kind] * primitive.strength;
    term.position = primitive.position;
    term.source = source;
}

/// Strength below which a primitive counts as none (N). Its square and its quotients would underflow or
/// overflow.
constexpr double min_strength = 1e-300;

/// Makes a term of each primitive that has a kink and is not of strength 0. Sums the constant forces of the
/// others and of planes.
void take_primitives(Problem& problem, const PrimitiveSet& set) {
    std::size_t source = 0;
    for (const Primitive& primitive : set.items()) {
        Term& next = problem.terms.items[problem.terms.count];
        fill(next, primitive, source++);
        problem.load += load_of_kind[static_cast<std::size_t>(primitive.kind)] * primitive.strength * next.q;
        problem.strength += next.strength;
        problem.terms.count += next.strength > 0 && primitive.strength >= min_strength ? 1 : 0;
    }
}

/// Energy at x (J), or any number above `most` if the energy exceeds `most`.
double energy(const Problem& problem, vec3 x, double most) {
    double result = 0.5 * problem.stiffness * glm::dot(x, x) - glm::dot(problem.target, x);
    for (const Term& term : terms_of(problem)) {
        if (result > most) break;
        result += term.strength * glm::length(project(term, x) - term.offset);
    }
    return result;
}

}  // namespace

void measure_distances(Problem& problem, vec3 x) {
    for (Term& term : terms_of(problem)) term.distance = project(term, x) - term.offset;
}

void set_origin(Problem& problem, vec3 origin) {
    problem.origin = origin;
    problem.target = to_problem_frame(problem, problem.stiffness * (problem.centre - origin) + problem.load);
    for (Term& term : terms_of(problem))
        term.offset = project(term, to_problem_frame(problem, term.position - origin));
}

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
    set_origin(problem, is_point ? nearest->position : before + to_world_frame(problem, x - distance));
    x = is_point ? distance : x + to_problem_frame(problem, before - problem.origin);
    measure_distances(problem, x);
}

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

Problem problem_of(const PrimitiveSet& set, const Spring& spring) {
    Problem problem;  // not `{}`, for which the compiler would clear 3 KB
    problem.stiffness = spring.stiffness;
    problem.centre = spring.centre;
    take_primitives(problem, set);
    // Kinks may lie at the world's origin. A rounding error in proportion to the coordinates would be zero
    // there, so 1e-30 m is added.
    double farthest = 0;
    for (Term& term : terms_of(problem)) {
        const double size = glm::length(term.position);
        term.rounding = 16 * epsilon * (1e-30 + size);
        farthest = std::max(farthest, size);
    }
    for (Term& term : terms_of(problem)) term.rounding = std::max(term.rounding, epsilon * farthest);
    return problem;
}

}  // namespace thaum::haptics::balancing
