// haptics/primitives/detail/balance_problem.h: the problem that balance() solves, in a frame of its own: a
// spring, constant forces, and terms with kinks. For balance.cpp and the files of its steps only.
//
// A plane is a directed force of s/2 plus s/2 |q.(x - p)|. So all kinks have one form, s |P (x - p)|, with an
// orthogonal projector P of rank 3 (point), 2 (line) or 1 (plane): a sum of Euclidean norms.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "haptics/primitives/balance.h"
#include "haptics/primitives/detail/symmetric.h"

namespace thaum::haptics::balancing {

inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

inline bool budget_spent(int steps) { return steps >= balance_step_budget; }

/// Part of the energy by one primitive: strength |P x - offset| in the problem's frame, P = identity I + dyad
/// q q^T.
struct Term {
    vec3 q;
    double identity, dyad;
    double strength;
    vec3 position, direction;  ///< position p and direction q of the primitive (world frame)
    vec3 offset;
    vec3 dual;      ///< y: the term's force is -y; |y| <= strength (N)
    vec3 distance;  ///< m = P x - offset: way from the kink to x when last measured (m)
    /// Error of a distance from the kink (m), because this primitive's position and the farthest one of the
    /// set are rounded.
    double rounding;
    std::size_t source;  ///< index of the primitive in the set
    bool active;         ///< true: x is assumed to lie on the term's kink
};

/// The terms of a problem, each of which is the energy of one primitive with a kink. They take 3 KB and are
/// copied at each guess, so only those in use are copied or cleared.
struct Terms {
    std::array<Term, primitive_capacity> items;
    std::size_t count = 0;

    Terms() {}  // NOLINT(modernize-use-equals-default): a default constructor would clear the items
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
    vec3 centre{};      ///< centre of the spring (world frame)
    vec3 load{};        ///< sum of the constant forces (N)
    vec3 origin{};      ///< origin of x (world frame)
    mat3 axes{1};       ///< axes of the problem's frame (columns, world frame)
    bool turned{};      ///< the axes differ from the world's
    vec3 target{};      ///< stiffness * (centre - origin) + load, in the problem's frame (N)
    double strength{};  ///< sum of the strengths of all terms (N)
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

/// Rotates a vector from the world frame to the problem's frame, or back.
inline vec3 to_problem_frame(const Problem& problem, vec3 v) { return problem.turned ? v * problem.axes : v; }
inline vec3 to_world_frame(const Problem& problem, vec3 v) { return problem.turned ? problem.axes * v : v; }

inline vec3 world_of(const Problem& problem, vec3 x) { return problem.origin + to_world_frame(problem, x); }

inline double rounding_of(vec3 position) { return 16 * epsilon * (1e-30 + glm::length(position)); }

/// Whether x is so near to a term's kink (the point, line or plane of its primitive) that world coordinates
/// cannot tell them apart. The rounding of the spring's centre does not count, because the centre may be 1e12
/// times as far away.
inline bool touches(const Term& term, double rounding_of_x) {
    const double least = std::max(term.rounding, rounding_of_x);
    return glm::dot(term.distance, term.distance) <= least * least;
}

inline void limit_dual(Term& term) {
    const double square = glm::dot(term.dual, term.dual);
    if (square > term.strength * term.strength) term.dual *= term.strength / std::sqrt(square);
}

Problem problem_of(const PrimitiveSet& set, const Spring& spring);
/// Sets the origin of the problem's frame (world frame), and with it the offsets of all terms. The caller
/// updates distances and x.
void set_origin(Problem& problem, vec3 origin);
/// Moves the origin of the problem's frame to the point nearest to x on the nearest kink (point, line or
/// plane), so that small distances have full precision. Does nothing if the present origin is nearer to x.
void move_origin(Problem& problem, vec3& x);
/// Measures the distance of x from the kink of each term.
void measure_distances(Problem& problem, vec3 x);
/// Place from which the search for the minimum starts: the one with the least energy among `free`, where the
/// spring and the constant forces alone would put x, and the places nearest to it on each of the kinks.
vec3 start_of(const Problem& problem, vec3 free);

}  // namespace thaum::haptics::balancing
