// accuracy/primitives_judge.h: checks whether a balance, the proxy position at which the spring and the
// haptic primitives cancel each other, is what the documentation (haptics/primitives/balance.h) promises,
// without any code of the solver.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "haptics/primitives/balance.h"

namespace thaum::haptics::sets {

/// Largest violation of the documentation by a balance (N). The spring's force must equal the sum of the
/// primitives' forces, and each of these must be a force that its primitive can exert at the proxy. A
/// position is accurate only to `touching` (m), which limits the accuracy of forces whose direction depends
/// on it.
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
        vec3 outside{};  // part of the force that the primitive cannot exert, wherever the proxy is
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
        // Where the force jumps, any force within the primitive's strength is right.
        if (distance <= touching) continue;
        const double doubt = p.kind == PrimitiveKind::plane ? 0 : p.strength * 2 * touching / distance;
        worst = std::max(worst, glm::length(force - expected) - doubt);
    }
    const double doubt = spring.stiffness * touching;
    worst = std::max(worst, glm::length(sum - balance.force));
    return std::max(worst, glm::length(spring.stiffness * (spring.centre - balance.proxy) + sum) - doubt);
}

using Real = long double;
struct Triple {
    Real x, y, z;
};
inline Triple triple(vec3 v) { return {v.x, v.y, v.z}; }
inline Triple operator+(Triple a, Triple b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Triple operator*(Real s, Triple a) { return {s * a.x, s * a.y, s * a.z}; }
inline Real dot(Triple a, Triple b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Real length(Triple a) { return std::sqrt(dot(a, a)); }

/// A proven bound on the error of the force (N), computed only from the result, with 64 bits of mantissa. The
/// proxy is assumed to be on no kink (a place where a primitive's force jumps). Let f(x) be the energy of the
/// spring plus the potentials of the primitives. It is at least k/2 |x - minimum|^2 above its minimum. The
/// dual value at the returned forces is below the minimum. With `gap`, the difference between f(x) and the
/// dual value, this gives k |x - minimum| <= sqrt(|missing force|^2 + 2 k gap).
inline double proven_bound(const PrimitiveSet& set, const Spring& spring, const Balance& balance) {
    const Triple x = triple(balance.proxy);
    const Real k = spring.stiffness;
    Triple missing = k * (triple(spring.centre) + Real{-1} * x);
    Real gap = 0;
    std::size_t i = 0;
    for (const Primitive& p : set.items()) {
        const Triple force = triple(balance.primitive[i++]);
        missing = missing + force;
        if (p.kind == PrimitiveKind::directed) continue;
        Triple m = x + Real{-1} * triple(p.position);
        const Triple q = triple(p.direction);
        const Real along = dot(m, q), s = p.strength;
        if (p.kind == PrimitiveKind::line) m = m + -along * q;
        const Real energy = p.kind == PrimitiveKind::plane ? s * std::max(Real{0}, -along) : s * length(m);
        gap += std::max(Real{0}, energy + dot(force, m));
    }
    return static_cast<double>(std::sqrt(dot(missing, missing) + 2 * k * gap));
}

/// Largest amount (N) by which rounding may increase proven_bound. Forces are rounded, and so are the proxy
/// and all positions, which moves the places where forces jump.
inline double bound_rounding(const PrimitiveSet& set, const Spring& spring, const Balance& balance) {
    double reach = glm::length(balance.proxy), strength = 0;
    for (const Primitive& p : set.items()) {
        if (p.kind != PrimitiveKind::directed) reach = std::max(reach, glm::length(p.position));
        strength += p.strength;
    }
    const double gap = 2e-14 * strength * reach;
    return std::sqrt(2 * spring.stiffness * gap) + 1e-12 * strength + 1e-14 * spring.stiffness * reach;
}

}  // namespace thaum::haptics::sets
