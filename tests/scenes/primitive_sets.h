// tests/scenes/primitive_sets.h: random sets of haptic primitives (points, lines and planes that hold the
// proxy), for tests and the benchmark.
#pragma once
#include <cstddef>

#include "core/random.h"
#include "haptics/primitives/balance.h"

namespace thaum::haptics::sets {

struct Scale {
    double strength = 3;     ///< largest strength of a primitive (N)
    double size = 0.01;      ///< half the edge of the box that contains all positions (m)
    double stiffness = 300;  ///< stiffness of the spring (N/m)
};

/// Random direction, uniformly distributed.
inline vec3 random_direction(Random& random) {
    for (;;) {
        const vec3 v(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        const double length = glm::length(v);
        if (length > 0.1 && length <= 1) return v / length;
    }
}

inline vec3 random_position(Random& random, double size) {
    return size * vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
}

inline Primitive random_primitive(Random& random, const Scale& scale) {
    return {.kind = static_cast<PrimitiveKind>(random.below(4)),
            .position = random_position(random, scale.size),
            .direction = random_direction(random),
            .strength = scale.strength * random.uniform()};
}

inline vec3 random_axis(Random& random) {
    vec3 axis{};
    axis[static_cast<int>(random.below(3))] = random.below(2) == 0 ? 1 : -1;
    return axis;
}

/// Makes a new primitive degenerate with respect to an older one: zero, coincident, parallel, opposite,
/// incident, or along an axis.
inline void degenerate(Random& random, const Scale& scale, const Primitive& older, Primitive& p) {
    switch (random.below(8)) {
        case 0: p.strength = 0; break;
        case 1: p.position = older.position; break;
        case 2: p.position = older.position, p.direction = older.direction; break;
        case 3: p.direction = older.direction; break;
        case 4: p.position = older.position + random.uniform(-1, 1) * scale.size * older.direction; break;
        case 5: p.position = older.position, p.direction = -older.direction; break;
        case 6: p.direction = random_axis(random); break;
        default:
            p.direction = random_axis(random);
            p.position = scale.size / 2 * glm::round(2.0 / scale.size * p.position);
            p.strength = scale.strength / 4 * static_cast<double>(random.below(4));
    }
}

/// A random set. Every second set is degenerate, often with the spring's centre on a kink, which is the
/// point, line or plane where a primitive's force jumps.
struct Case {
    PrimitiveSet set;
    Spring spring;
};
inline Case random_case(Random& random, std::size_t count, const Scale& scale) {
    Case result;
    const bool is_degenerate = random.below(2) == 0;
    for (std::size_t i = 0; i < count; ++i) {
        Primitive p = random_primitive(random, scale);
        if (is_degenerate && i > 0) degenerate(random, scale, result.set.items()[random.below(i)], p);
        result.set.add(p);
    }
    result.spring = {random_position(random, scale.size), scale.stiffness};
    if (is_degenerate && random.below(4) == 0) result.spring.centre = result.set.items()[0].position;
    return result;
}

}  // namespace thaum::haptics::sets
