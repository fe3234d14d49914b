#include "haptics/surface/detail/straight.h"

#include <algorithm>

#include "haptics/surface/detail/sweep.h"

namespace thaum::haptics {
namespace {

/// Fraction of a straight path from x that stays within the patch's reach, the sphere of which the patch
/// knows all surfaces.
double allowed(const SurfacePatch& patch, vec3 x, vec3 way) {
    if (!(patch.reach < HUGE_VAL)) return 1;
    const vec3 arm = x - patch.centre;
    const double a = glm::dot(way, way), b = glm::dot(arm, way),
                 c = glm::dot(arm, arm) - patch.reach * patch.reach;
    if (a + 2 * b + c <= 0) return 1;  // the end of the path lies within the patch's sphere
    if (!(a > 0)) return 0;
    const double root = b * b - a * c;
    return root > 0 ? std::clamp((std::sqrt(root) - b) / a, 0.0, 1.0) : 0.0;
}

/// Place up to which friction lets the proxy move on a straight path to its goal.
vec3 held_back(const Scene& scene, const SlideState& slide, vec3 goal, bool sliding) {
    if (slide.walls.count == 0) return goal;
    const vec3 away = slide.x - goal;
    const double distance = glm::length(away);
    if (distance <= friction_reach(scene, slide.walls, slide.x, sliding || slide.slid) + place_tolerance)
        return slide.x;
    return goal + away * (friction_reach(scene, slide.walls, slide.x, true) / distance);
}

/// First surface on the path, if the proxy already stands at it. This is for a proxy at the end of the
/// patch's reach (the sphere whose surfaces are known), which cannot move on to meet the surface. Without it,
/// the force would end where the reach ends.
Hit hit_at_reach(const Scene& scene, const SlideState& slide, vec3 way) {
    const Sweep ahead(slide.x, way);
    Hit hit = first_hit(scene, ahead);
    if (hit.at * ahead.length > place_tolerance) hit.at = 2;
    return hit;
}

}  // namespace

Straight go_straight(const Scene& scene, SlideState& slide, vec3 goal, bool was_sliding) {
    const vec3 whole = held_back(scene, slide, goal, was_sliding) - slide.x;
    const double part = allowed(*scene.patch, slide.x, whole);
    const vec3 way = part * whole;
    Hit hit = first_hit(scene, Sweep(slide.x, way));
    if (part < 1 && hit.at > 1 && slide.walls.count == 0) hit = hit_at_reach(scene, slide, whole);
    const vec3 free = std::min(hit.at, 1.0) * way;
    slide.x += free;
    if (slide.walls.count != 0 && glm::dot(free, free) > place_tolerance * place_tolerance) slide.slid = true;
    if (hit.at <= 1) {
        add_wall(slide.walls, hit.wall);
        return Straight::met_a_wall;
    }
    slide.limited = part < 1;
    return slide.limited ? Straight::limited : Straight::arrived;
}

}  // namespace thaum::haptics
