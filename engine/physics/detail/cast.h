// physics/detail/cast.h: distance that a point or sphere can move before it touches a convex shape.
//
// Bullet's own casts stop at a relative tolerance and miss thin bodies at long range. This cast
// advances by support planes. The plane at the nearest point of the shape has the whole shape behind
// it. The sphere may therefore move up to that plane at once, and if it does not approach the plane it
// can never hit. A flat face needs one advance; a curved one is found by Newton's iteration from
// outside. No advance can pass through anything, at any speed.
#pragma once
#include <optional>

#include "core/maths.h"
#include "physics/physics.h"

namespace thaum::physics::detail {

/// Nearest point of a convex shape, relative to a given point.
struct NearestPoint {
    double distance;  ///< distance to the surface; <= 0 inside (m)
    vec3 normal;      ///< direction from the shape to the point (unit); zero if undefined
};

/// Distance below which a path counts as touching (m).
inline constexpr double touching = 1e-9;

/// Nearest point in the shape's own frame.
NearestPoint nearest_to(const BodyDesc&, vec3 point);
NearestPoint nearest_to_triangle(const vec3 (&corner)[3], vec3 point);
/// The distance alone, to the same bits.
double distance_to_triangle(const vec3 (&corner)[3], vec3 point);

/// Path of a moving point or sphere.
struct Path {
    vec3 from;
    vec3 direction;  ///< direction of the path (unit)
    double length;   ///< length of the path (m)
    double radius;   ///< radius of the sphere; 0: a ray (m)
};

/// Where a path first meets a shape.
struct CastHit {
    double travelled;  ///< distance travelled before the hit (m)
    vec3 normal;       ///< normal at the hit, outward from the shape (unit)
};

/// Casts a path against one convex shape. `nearest` maps a point to its NearestPoint.
template <class NearestTo>
std::optional<CastHit> cast(const Path& path, const NearestTo& nearest) {
    // When a path grazes a curved side, each advance halves the gap, so 30 advances are enough.
    constexpr int max_advances = 100;
    CastHit contact{0, -path.direction};
    for (int i = 0; i < max_advances; ++i) {
        const NearestPoint here = nearest(path.from + contact.travelled * path.direction);
        // If the direction is undefined here, the previous one is kept. At a start inside the shape there is
        // none.
        if (here.normal != vec3{} && (i > 0 || here.distance > 0)) contact.normal = here.normal;
        const double gap = here.distance - path.radius;
        if (gap <= touching) return contact;
        const double closing = -glm::dot(here.normal, path.direction);
        if (closing <= 0) return std::nullopt;
        contact.travelled += gap / closing;
        if (contact.travelled > path.length) return std::nullopt;
    }
    return contact;
}

}  // namespace thaum::physics::detail
