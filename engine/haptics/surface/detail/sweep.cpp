#include "haptics/surface/detail/sweep.h"

#include <algorithm>

namespace thaum::haptics {
namespace {

// Largest number of times that a point advances towards a shape; on a path that grazes a round side, each
// advance halves the distance.
constexpr int max_advances = 60;

/// Whether a hit on the path comes before another one. Of two simultaneous hits, the one at the steeper angle
/// to the surface comes first.
bool sooner(double at, double drop, const Hit& than, double length) {
    const double lead = (than.at - at) * length;
    return lead > place_tolerance || (lead > -place_tolerance && drop > than.drop);
}

}  // namespace

void sweep_flat(const Scene& scene, const Facet& flat, const Sweep& path, Hit& first) {
    vec3 normal = flat.normal;
    double offset = flat.offset;
    double start = glm::dot(normal, path.from) - offset;
    double drop = -glm::dot(normal, path.step);
    if (flat.kind == SurfaceKind::sheet && start < 0) {
        normal = -normal;
        offset = -offset;
        start = -start;
        drop = -drop;
    }
    const double end = start - drop;
    if (!(drop > 0) || end >= flat.gap - place_tolerance) return;
    if (flat.kind != SurfaceKind::plane && start < -surface_gap / 2) return;
    const double at = std::clamp((start - flat.gap) / drop, 0.0, 1.0);
    if (!sooner(at, drop, first, path.length)) return;
    if (flat.kind != SurfaceKind::plane) {
        const double crossing = end < 0 ? std::clamp(start / drop, 0.0, 1.0) : 1.0;
        if (!over_triangle(scene.surface(flat.surface), flat.normal, path.from + crossing * path.step,
                           place_tolerance))
            return;
    }
    first = {at, drop, {normal, offset + flat.gap, 0, flat.surface}};
}

/// Finds the hit of a moving point on a convex shape. The point advances again and again to the tangent plane
/// at the nearest point of the shape. The whole shape lies behind that plane, so no advance passes through
/// it.
void sweep_solid(const Scene& scene, std::uint32_t i, const Sweep& path, Hit& first) {
    if (scene.beyond(i, path.from, path.length)) return;
    const Surface& s = scene.surface(i);
    const quat orientation = scene.body_of(i).orientation;
    double at = 0;
    const double gap = scene.gap[i];
    double drop = 0;
    Distance here{};
    for (int n = 0; n < max_advances; ++n) {
        here = to_solid(s, orientation, path.from + at * path.step);
        drop = -glm::dot(here.normal, path.step);
        if (!(drop > 0) || here.value - (1 - at) * drop >= gap - place_tolerance) return;
        if (here.value <= gap + place_tolerance) break;
        at += (here.value - gap) / drop;
        if (at > first.at + 1e-9) return;
    }
    if (sooner(at, drop, first, path.length))
        first = {at, drop, wall_at(scene, path.from + at * path.step, here, i)};
}

Hit first_hit(const Scene& scene, const Sweep& path, SurfaceSet passed_over) {
    Hit first;
    for (std::uint32_t i = 0; i < scene.flat_count; ++i) {
        if ((passed_over & only(scene.flats[i].surface)) == 0) sweep_flat(scene, scene.flats[i], path, first);
    }
    for (std::uint32_t i = 0; i < scene.solid_count; ++i) {
        if ((passed_over & only(scene.solids[i])) == 0) sweep_solid(scene, scene.solids[i], path, first);
    }
    return first;
}

SurfaceSet Clearances::beyond(const Scene& scene, vec3 from, double distance) {
    // Distance to the place of the last measurement, as a multiple of `distance`, up to which that
    // measurement still serves.
    constexpr double stale = 4;
    double off = glm::length(from - place_);
    if (!(off <= stale * distance)) {
        measure(scene, from);
        off = 0;
    }
    SurfaceSet far = 0;
    for (std::uint32_t i = 0; i < scene.patch->count && i < surface_capacity; ++i)
        if (free_[i] > off + distance + place_tolerance) far |= only(i);
    return far;
}

void Clearances::measure(const Scene& scene, vec3 place) {
    place_ = place;
    for (std::uint32_t i = 0; i < scene.flat_count; ++i) {
        const Facet& flat = scene.flats[i];
        const double height = glm::dot(flat.normal, place) - flat.offset;
        free_[flat.surface] = (flat.kind == SurfaceKind::plane ? height : std::abs(height)) - flat.gap;
    }
    for (std::uint32_t i = 0; i < scene.solid_count; ++i) {
        const std::uint32_t solid = scene.solids[i];
        const Distance d = to_solid(scene.surface(solid), scene.body_of(solid).orientation, place);
        free_[solid] = d.value - scene.gap[solid];
    }
}

}  // namespace thaum::haptics
