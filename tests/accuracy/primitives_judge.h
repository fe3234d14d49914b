// accuracy/primitives_judge.h: judges a balance by its documentation; shares no code with the solver.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "haptics/primitives.h"

namespace thaum::haptics::sets {

/// Of `new` in this program so far.
std::size_t allocations();

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
