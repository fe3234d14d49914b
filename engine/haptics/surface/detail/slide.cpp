#include "haptics/surface/detail/slide.h"

#include <algorithm>

#include "haptics/surface/detail/feel.h"
#include "haptics/surface/detail/round.h"
#include "haptics/surface/detail/sweep.h"

namespace thaum::haptics {
namespace {

constexpr int most_moves = 32;

/// Fraction of a straight path from x that stays within the patch's reach.
double allowed(const SurfacePatch& patch, vec3 x, vec3 way) {
    if (!(patch.reach < HUGE_VAL)) return 1;
    const vec3 arm = x - patch.centre;
    const double a = glm::dot(way, way), b = glm::dot(arm, way),
                 c = glm::dot(arm, arm) - patch.reach * patch.reach;
    if (a + 2 * b + c <= 0) return 1;  // the end lies within
    if (!(a > 0)) return 0;
    const double root = b * b - a * c;
    return root > 0 ? std::clamp((std::sqrt(root) - b) / a, 0.0, 1.0) : 0.0;
}

bool supported(const Scene& scene, const SlideState& slide) {
    for (std::size_t i = 0; i < slide.walls.count; ++i)
        if (!stands(scene, slide.walls.items[i], slide.x)) return false;
    return true;
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

/// Moves the proxy by the free part of the path.
void move_by(SlideState& slide, vec3 way) {
    slide.x += way;
    if (slide.walls.count != 0 && glm::dot(way, way) > place_tolerance * place_tolerance) slide.slid = true;
}

enum class Straight : std::uint8_t { met_a_wall, arrived, limited };

/// Surface at which the proxy stands on its path although the patch's reach leaves no room to move. Without
/// it, a force would end where the patch ends.
Hit hit_at_reach(const Scene& scene, const SlideState& slide, vec3 way) {
    const Sweep ahead(slide.x, way);
    Hit hit = first_hit(scene, ahead);
    if (hit.at * ahead.length > place_tolerance) hit.at = 2;
    return hit;
}

/// Moves straight towards the goal until a surface, friction or the patch's reach stops the proxy.
Straight go_straight(const Scene& scene, SlideState& slide, vec3 goal, bool was_sliding) {
    const vec3 whole = held_back(scene, slide, goal, was_sliding) - slide.x;
    const double part = allowed(*scene.patch, slide.x, whole);
    const vec3 way = part * whole;
    Hit hit = first_hit(scene, Sweep(slide.x, way));
    if (part < 1 && hit.at > 1 && slide.walls.count == 0) hit = hit_at_reach(scene, slide, whole);
    move_by(slide, std::min(hit.at, 1.0) * way);
    if (hit.at <= 1) {
        add_wall(slide.walls, hit.wall);
        return Straight::met_a_wall;
    }
    slide.limited = part < 1;
    return slide.limited ? Straight::limited : Straight::arrived;
}

/// Ends a slide that has used up its moves or its patch. If no wall is left, the last walls that held the
/// proxy stay: the force never vanishes because the moves are used up.
void settle(const Scene& scene, SlideState& slide, vec3 tip, const Walls& held) {
    if (is_round(scene, slide.walls, slide.x)) {
        refresh_round(scene, slide.walls, slide.x, false);
        if (!nearest_place(slide.walls, tip).found) slide.walls = held;
    }
    if (slide.walls.count == 0) slide.walls = held;
}

}  // namespace

SlideState slide_to(const Scene& scene, vec3 start, vec3 tip, bool was_sliding) {
    SlideState slide{.x = start};
    Walls held;
    vec3 cleared{}, last = start;
    bool first = true;
    for (int move = 0; move < most_moves; ++move) {
        refresh_round(scene, slide.walls, slide.x, glm::length(slide.x - last) > place_tolerance);
        last = slide.x;
        const NearestPlace goal = nearest_place(slide.walls, tip);
        if (!goal.found) {  // no room: the proxy stays, held by the walls before
            if (held.count != 0) slide.walls = held;
            return slide;
        }
        if (slide.walls.count != 0) held = slide.walls;
        if (is_round(scene, slide.walls, slide.x)) {
            const RoundEnd end = slide_round(scene, slide, {tip, goal.place, was_sliding});
            if (end == RoundEnd::rests) return slide;
            if (end == RoundEnd::limited) break;
            continue;
        }
        const Straight end = go_straight(scene, slide, goal.place, was_sliding);
        if (end == Straight::met_a_wall) continue;
        if (end == Straight::limited || slide.walls.count == 0 || supported(scene, slide)) return slide;
        if (!first && glm::length(slide.x - cleared) < place_tolerance) return slide;
        first = false;
        cleared = slide.x;
        slide.walls.count = 0;
    }
    settle(scene, slide, tip, held);
    return slide;
}

}  // namespace thaum::haptics
