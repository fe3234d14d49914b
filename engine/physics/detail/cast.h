// physics/detail/cast.h: how far a point or sphere can move before it touches a convex shape.
//
// Bullet's own casts stop at a relative tolerance and lose thin things at long range. Ours advances by support planes:
// at the nearest point of the shape stands a plane that has the whole shape behind it, so the sphere may move up to that
// plane at once, and if it does not approach the plane it can never hit. Against a flat face this ends after one advance,
// against a curved one it is Newton's iteration from outside. No step can pass through anything, at any speed.
#pragma once
#include <optional>

#include "core/maths.h"
#include "physics/physics.h"

namespace thaum::physics::detail {

/// Of a point to a convex shape.
struct NearestPoint {
    double distance;  ///< m; <= 0 inside
    vec3 normal;      ///< unit, from the shape to the point; zero where that is not defined
};

/// m; nearer than this is a hit.
inline constexpr double touching = 1e-9;

/// All in the shape's own frame.
NearestPoint nearest_to(const BodyDesc&, vec3 point);
NearestPoint nearest_to_triangle(const vec3 (&corner)[3], vec3 point);

/// A moving point or sphere.
struct Path {
    vec3 from;
    vec3 direction;  ///< unit
    double length;   ///< m
    double radius;   ///< m; 0: a ray
};

struct CastHit {
    double travelled;  ///< m
    vec3 normal;       ///< unit, outward of the shape
};

/// `nearest` tells a point's Nearest to one convex shape.
template <class NearestTo>
std::optional<CastHit> cast(const Path& path, const NearestTo& nearest) {
    constexpr int most_advances = 100;  // grazing a curved side halves the gap each time; 30 suffice
    CastHit touch{0, -path.direction};
    for (int i = 0; i < most_advances; ++i) {
        const NearestPoint here = nearest(path.from + touch.travelled * path.direction);
        // Without a direction here the last one still holds; from inside, the surface has none to offer.
        if (here.normal != vec3{} && (i > 0 || here.distance > 0)) touch.normal = here.normal;
        const double gap = here.distance - path.radius;
        if (gap <= touching) return touch;
        const double closing = -glm::dot(here.normal, path.direction);
        if (closing <= 0) return std::nullopt;
        touch.travelled += gap / closing;
        if (touch.travelled > path.length) return std::nullopt;
    }
    return touch;
}

}  // namespace thaum::physics::detail
