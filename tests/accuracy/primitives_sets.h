// accuracy/primitives_sets.h: random sets of primitives, and a judge of a balance that shares no code with the solver.
#pragma once
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/random.h"
#include "haptics/primitives.h"

namespace thaum::haptics::sets {

/// Of `new` in this program so far.
std::size_t allocations();

struct Scale {
    double strength = 3;     ///< N, the most
    double size = 0.01;      ///< m, half the edge of the box all positions lie in
    double stiffness = 300;  ///< N/m
};

/// Uniform in direction.
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

/// Makes the new one degenerate together with an older one: zero, coincident, parallel, opposite, on it, along an axis.
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

/// Every second set is degenerate, and its spring often centred on a kink.
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

/// How far, in N, the balance is from what its documentation says: the spring against the sum of the forces, and every force
/// against what its primitive can exert at the proxy. A position is known to `touching` m, so a force whose direction
/// depends on it is known no better than that allows.
inline double fault(const PrimitiveSet& set, const Spring& spring, const Balance& balance, double touching) {
    const auto items = set.items();
    double worst = 0;
    vec3 sum{};
    for (std::size_t i = 0; i < items.size(); ++i) {
        const Primitive& p = items[i];
        const vec3 force = balance.primitive[i];
        sum += force;
        vec3 m = balance.proxy - p.position;
        vec3 expected{};
        double distance = 0;
        vec3 outside{};  // what the primitive cannot exert, wherever the proxy is
        if (p.kind == PrimitiveKind::directed) {
            worst = std::max(worst, glm::length(force - p.strength * p.direction));
            continue;
        }
        if (p.kind == PrimitiveKind::plane) {
            const double height = glm::dot(m, p.direction);
            expected = height < 0 ? p.strength * p.direction : vec3(0);
            distance = std::abs(height);
            const double along = glm::dot(force, p.direction);
            outside = force - std::clamp(along, 0.0, p.strength) * p.direction;
        } else {
            if (p.kind == PrimitiveKind::line) m -= glm::dot(m, p.direction) * p.direction;
            distance = glm::length(m);
            expected = distance > 0 ? m * (-p.strength / distance) : vec3(0);
            if (p.kind == PrimitiveKind::line) outside = glm::dot(force, p.direction) * p.direction;
            worst = std::max(worst, glm::length(force) - p.strength);
        }
        worst = std::max(worst, glm::length(outside));
        if (distance <= touching) continue;  // on its kink it may exert any of these
        const double doubt = p.kind == PrimitiveKind::plane ? 0 : p.strength * 2 * touching / distance;
        worst = std::max(worst, glm::length(force - expected) - doubt);
    }
    const double doubt = spring.stiffness * touching;
    worst = std::max(worst, glm::length(sum - balance.force));
    return std::max(worst, glm::length(spring.stiffness * (spring.centre - balance.proxy) + sum) - doubt);
}

}  // namespace thaum::haptics::sets
