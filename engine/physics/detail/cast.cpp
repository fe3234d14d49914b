#include "physics/detail/cast.h"

#include <algorithm>

#include "core/assert.h"

namespace thaum::physics::detail {
namespace {

/// Nearest point of a shape with flat sides; `outward` leads from it to the given point. At a distance below
/// `touching`, that direction is only noise.
NearestPoint beyond(vec3 outward) {
    const double distance = glm::length(outward);
    return {distance, distance > touching ? outward / distance : vec3{}};
}

/// Nearest point of a shape that contains all points within `radius` of a core; `from_core` leads from the
/// core's nearest point to the given point.
NearestPoint round(vec3 from_core, double radius) {
    const double length = glm::length(from_core);
    return {length - radius, length > touching ? from_core / length : vec3{}};
}

NearestPoint to_box(vec3 half, vec3 p) { return beyond(p - glm::clamp(p, -half, half)); }

NearestPoint to_capsule(double radius, double half_length, vec3 p) {
    return round({p.x, p.y - std::clamp(p.y, -half_length, half_length), p.z}, radius);
}

NearestPoint to_cylinder(double radius, double half_length, vec3 p) {
    const double across = std::sqrt(p.x * p.x + p.z * p.z);
    const double scale = across > radius ? radius / across : 1.0;
    return beyond(p - vec3{p.x * scale, std::clamp(p.y, -half_length, half_length), p.z * scale});
}

/// Nearest point of a triangle by its Voronoi regions (Christer Ericson, Real-Time Collision Detection,
/// 2005, 5.1.5).
vec3 nearest_point(const vec3 (&corner)[3], vec3 p) {
    const vec3 a = corner[0], b = corner[1], c = corner[2];
    const vec3 ab = b - a, ac = c - a;
    const double d1 = glm::dot(ab, p - a), d2 = glm::dot(ac, p - a);
    if (d1 <= 0 && d2 <= 0) return a;
    const double d3 = glm::dot(ab, p - b), d4 = glm::dot(ac, p - b);
    if (d3 >= 0 && d4 <= d3) return b;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + ab * (d1 / (d1 - d3));
    const double d5 = glm::dot(ab, p - c), d6 = glm::dot(ac, p - c);
    if (d6 >= 0 && d5 <= d6) return c;
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + ac * (d2 / (d2 - d6));
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 >= d3 && d5 >= d6) return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    const double whole = va + vb + vc;
    return a + ab * (vb / whole) + ac * (vc / whole);
}

}  // namespace

NearestPoint nearest_to(const BodyDesc& desc, vec3 p) {
    switch (desc.shape) {
        case Shape::box: return to_box(desc.size, p);
        case Shape::sphere: return round(p, desc.size.x);
        case Shape::capsule: return to_capsule(desc.size.x, desc.size.y, p);
        case Shape::cylinder: return to_cylinder(desc.size.x, desc.size.y, p);
        case Shape::mesh: break;
    }
    THAUM_ASSERT(false, "a mesh is not convex");
}

NearestPoint nearest_to_triangle(const vec3 (&corner)[3], vec3 p) {
    return beyond(p - nearest_point(corner, p));
}

double distance_to_triangle(const vec3 (&corner)[3], vec3 p) {
    return glm::length(p - nearest_point(corner, p));
}

}  // namespace thaum::physics::detail
