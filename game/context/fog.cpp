#include "game/context/fog.h"

#include <algorithm>
#include <cmath>

#include "game/components/body.h"
#include "game/components/fog.h"

namespace thaum::game::inline context {
namespace {

/// Length of the part of a straight line that lies in a ball (m).
double length_within(vec3 from, vec3 to, vec3 middle, double radius) {
    const double whole = glm::distance(from, to);
    if (!(whole > 0)) return 0;
    const vec3 way = (to - from) / whole;
    const double nearest = glm::dot(middle - from, way);
    const vec3 off = middle - from - way * nearest;
    const double half_squared = radius * radius - glm::dot(off, off);
    if (half_squared <= 0) return 0;
    const double half = std::sqrt(half_squared);
    return std::max(0.0, std::min(whole, nearest + half) - std::max(0.0, nearest - half));
}

}  // namespace

bool hidden_by_fog(const ecs::World& world, vec3 from, vec3 to) {
    double hidden = 0;  // optical depth of the fog so far; from 1 on nothing is seen
    world.view<const Fog, const Motion>().each([&](const Fog& fog, const Motion& motion) {
        hidden += length_within(from, to, motion.position, fog.radius) / fog.sight;
    });
    return hidden >= 1;
}

}  // namespace thaum::game::inline context
