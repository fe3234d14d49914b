// haptics/surface/detail/scene.h: a patch (the surfaces near the tip) prepared for one tick, and distances to
// its surfaces.
//
// The proxy stays `surface_gap` outside of the true surfaces. Rounding (1e-16 of a coordinate) then never
// decides on which side of a surface the proxy is. A triangle is hit if the path crosses the triangle itself,
// not the same triangle moved out by the gap: two moved triangles that meet in a ridge would leave a slit
// between them. So a mesh whose triangles share corners has no holes.
#pragma once
#include "haptics/surface/surface.h"

namespace thaum::haptics {

inline constexpr double place_tolerance = 1e-13;  ///< distance below which two places are the same (m)

/// Motion of a body over the last tick. `moved` maps a place of the last tick to its present place.
struct BodyMotion {
    mat3 turn{1.0};
    vec3 pivot_before{};
    vec3 pivot{};
    bool moving{};
    bool turning{};

    vec3 moved(vec3 before) const {
        if (!moving) return before;
        const vec3 arm = before - pivot_before;
        return pivot + (turning ? turn * arm : arm);
    }
};

BodyMotion motion_of(const SurfaceBody& body, double dt);

/// A plane, or the plane of a triangle. They are stored together because each test of a path reads all of
/// them.
struct Facet {
    vec3 normal;
    /// Distance of the true surface's plane from the origin along the normal (m).
    double offset;
    double gap;  ///< distance of the proxy in front of the true surface: surface_gap and the texture's height
                 ///< (m)
    std::uint32_t surface;
    SurfaceKind kind;
};

/// Data that a tick computes once from a patch (the surfaces near the tip). Only array entries below the
/// counts are set.
struct Scene {
    const SurfacePatch* patch;
    std::uint32_t flat_count;
    std::uint32_t solid_count;
    std::uint32_t body_count;
    std::array<Facet, surface_capacity> flats;
    std::array<std::uint32_t, surface_capacity> solids;
    std::array<vec3, surface_capacity> normal;  ///< normals of the flat surfaces (unit)
    std::array<double, surface_capacity> gap;
    /// Upper bound of the distance from a solid's centre to a proxy that rests on it, `gap` outside of its
    /// surface (m).
    std::array<double, surface_capacity> extent;
    std::array<BodyMotion, surface_body_capacity> motions;

    const Surface& surface(std::uint32_t i) const { return patch->surfaces[i]; }
    const SurfaceBody& body_of(std::uint32_t i) const { return patch->bodies[surface(i).body]; }
    /// Whether a solid is farther than `distance` from a place. Most solids are; the test needs no square
    /// root.
    bool beyond(std::uint32_t solid, vec3 place, double distance) const {
        const vec3 arm = place - patch->surfaces[solid].a;
        const double near = extent[solid] + distance;
        return glm::dot(arm, arm) > near * near;
    }
};

void set_scene(Scene& scene, const SurfacePatch& patch, double dt);

inline bool is_flat(SurfaceKind kind) { return kind <= SurfaceKind::sheet; }
inline bool is_triangle(SurfaceKind kind) {
    return kind == SurfaceKind::triangle || kind == SurfaceKind::sheet;
}

struct Distance {
    double value;  ///< distance from the true surface, negative inside (m)
    vec3 normal;   ///< outward normal (unit)
};

/// Distance from p to a solid: a sphere, capsule, box or cylinder.
Distance to_solid(const Surface& s, quat orientation, vec3 p);

/// Whether the point p of the plane lies in the triangle, or at most `slack` (m) beside it.
bool over_triangle(const Surface& s, vec3 normal, vec3 p, double slack);

}  // namespace thaum::haptics
