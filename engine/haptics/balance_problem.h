// haptics/balance_problem.h: what balance() solves, in a frame of its own: a spring, constant forces, and terms with kinks. Used by
// balance.cpp and its steps alone.
//
// A plane is a directed force of s/2 and s/2 |q.(x - p)|, so all kinks are of one form, s |P (x - p)| with an orthogonal projector P of
// rank 3 (point), 2 (line) or 1 (plane): a sum of Euclidean norms.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "haptics/balance.h"
#include "haptics/symmetric.h"

namespace thaum::haptics::balancing {

inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

inline bool budget_spent(int steps) { return steps >= balance_step_budget; }

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
    bool active;         ///< x is taken to lie on its kink
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

inline std::span<Term> terms_of(Problem& problem) {
    return {problem.terms.items.data(), problem.terms.count};
}
inline std::span<const Term> terms_of(const Problem& problem) {
    return {problem.terms.items.data(), problem.terms.count};
}

inline vec3 project(const Term& term, vec3 v) {
    return term.identity * v + term.dyad * glm::dot(term.q, v) * term.q;
}

inline void add_projector(Symmetric& m, const Term& term, double weight) {
    add_identity(m, weight * term.identity);
    add_dyad(m, weight * term.dyad, term.q);
}

/// A vector in the problem's frame, and one of that in the world's.
inline vec3 to_problem_frame(const Problem& problem, vec3 v) { return problem.turned ? v * problem.axes : v; }
inline vec3 to_world_frame(const Problem& problem, vec3 v) { return problem.turned ? problem.axes * v : v; }

inline vec3 world_of(const Problem& problem, vec3 x) { return problem.origin + to_world_frame(problem, x); }

inline double rounding_of(vec3 position) { return 16 * epsilon * (1e-30 + glm::length(position)); }

/// Whether x is as near to the kink as the two can be told apart in the world's coordinates. Those of the place where x
/// would be without the terms do not count: that may be 1e12 times as far off.
inline bool touches(const Term& term, double rounding_of_x) {
    const double least = std::max(term.rounding, rounding_of_x);
    return glm::dot(term.distance, term.distance) <= least * least;
}

inline void limit_dual(Term& term) {
    const double square = glm::dot(term.dual, term.dual);
    if (square > term.strength * term.strength) term.dual *= term.strength / std::sqrt(square);
}

Problem problem_of(const PrimitiveSet& set, const Spring& spring);
/// World; the offsets of all terms follow, distances and x are the caller's.
void set_origin(Problem& problem, vec3 origin);
/// Takes the point of the nearest kink next to x as origin, so that small distances are known to full precision. Not
/// where the origin is nearer.
void move_origin(Problem& problem, vec3& x);
/// Of all terms from x.
void measure_distances(Problem& problem, vec3 x);
/// The best of where x would be without the terms and its nearest places on their kinks.
vec3 start_of(const Problem& problem, vec3 free);

}  // namespace thaum::haptics::balancing
