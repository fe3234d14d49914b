#include "haptics/volume/implicit.h"

#include <algorithm>
#include <cmath>

namespace thaum::haptics {
namespace {

using field::Scalar;

/// Distance of a place from a core (a point or line of a shape), less a radius. `off` leads from the nearest
/// point of the core to the place. On the core itself any direction is right.
Scalar round_about(vec3 off, double radius) {
    const double length = glm::length(off);
    return {length - radius, length > 0 ? off / length : vec3(0, 1, 0)};
}

/// Axis of the largest component of a vector.
int largest_axis(vec3 v) { return v.x >= v.y && v.x >= v.z ? 0 : v.y >= v.z ? 1 : 2; }

}  // namespace

Scalar Ball::operator()(vec3 place) const { return round_about(place - centre, radius); }

Scalar HalfSpace::operator()(vec3 at) const { return {glm::dot(at - place, normal), normal}; }

Scalar Bar::operator()(vec3 place) const {
    const vec3 along = to - from;
    const double square = glm::dot(along, along);
    const double share = square > 0 ? std::clamp(glm::dot(place - from, along) / square, 0.0, 1.0) : 0;
    return round_about(place - from - share * along, radius);
}

Scalar Block::operator()(vec3 place) const {
    const vec3 off = place - centre;
    const vec3 sign(off.x < 0 ? -1 : 1, off.y < 0 ? -1 : 1, off.z < 0 ? -1 : 1);
    const vec3 beyond = glm::abs(off) - (half - vec3(round));
    const vec3 outside = glm::max(beyond, vec3(0));
    if (outside != vec3(0)) {
        Scalar result = round_about(outside, round);
        result.gradient *= sign;
        return result;
    }
    const int axis = largest_axis(beyond);
    Scalar result{beyond[axis] - round, vec3(0)};
    result.gradient[axis] = sign[axis];
    return result;
}

Scalar Ring::operator()(vec3 place) const {
    const vec3 off = place - centre;
    const vec3 flat = off - glm::dot(off, axis) * axis;
    const double out = glm::length(flat);
    const vec3 outward = out > 0 ? flat / out : perpendicular_to(axis);
    return round_about(off - radius * outward, thickness);
}

Scalar Merged::operator()(vec3 place) const {
    if (parts.empty() || !(blend > 0)) return {.value = HUGE_VAL};
    // The exponents are relative to the smallest potential found so far, so that none overflows.
    double least = HUGE_VAL, sum = 0;
    vec3 slope(0);
    for (const field::ScalarField& part : parts) {
        const Scalar here = part(place);
        if (here.value < least) {
            const double shrink = sum > 0 ? det::exp((here.value - least) / blend) : 0;
            sum = sum * shrink + 1;
            slope = slope * shrink + here.gradient;
            least = here.value;
        } else {
            const double weight = det::exp((least - here.value) / blend);
            sum += weight;
            slope += weight * here.gradient;
        }
    }
    if (!(sum > 0)) return {.value = least};
    return {least - blend * det::log(sum), slope / sum};
}

Scalar Thickened::operator()(vec3 place) const {
    Scalar here = object(place);
    here.value -= distance;
    return here;
}

Scalar Decorated::operator()(vec3 place) const {
    static constexpr BumpMap flat{};
    Scalar here = object(place);
    const Relief relief = relief_at(texture, bumps == nullptr ? flat : *bumps, place);
    here.value -= relief.height;
    here.gradient -= relief.slope;
    return here;
}

}  // namespace thaum::haptics
