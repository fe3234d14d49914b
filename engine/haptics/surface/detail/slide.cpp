#include "haptics/surface/detail/slide.h"

#include "haptics/surface/detail/round.h"
#include "haptics/surface/detail/straight.h"

namespace thaum::haptics {
namespace {

constexpr int max_moves = 32;

/// Ends a slide that has used up its moves, or has reached the end of the space whose surfaces are known. If
/// no wall (plane at a touched surface) is left, the last walls that held the proxy stay: otherwise the force
/// would vanish only because the slide ended early.
void settle(const Scene& scene, SlideState& slide, vec3 tip, const Walls& held) {
    if (is_round(scene, slide.walls, slide.x)) {
        refresh_round(scene, slide.walls, slide.x, false);
        if (!nearest_place(slide.walls, tip).found) slide.walls = held;
    }
    if (slide.walls.count == 0) slide.walls = held;
}

}  // namespace

[[gnu::flatten]] SlideState slide_to(const Scene& scene, vec3 start, vec3 tip, bool was_sliding) {
    SlideState slide{.x = start};
    Walls held;
    vec3 cleared{}, last = start;
    bool first = true;
    for (int move = 0; move < max_moves; ++move) {
        refresh_round(scene, slide.walls, slide.x, glm::length(slide.x - last) > place_tolerance);
        last = slide.x;
        const NearestPlace goal = nearest_place(slide.walls, tip);
        if (!goal.found) {  // no place is in front of all walls: the walls of the last move hold the proxy
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
        if (end == Straight::limited || slide.walls.count == 0 || all_stand(scene, slide.walls, slide.x))
            return slide;
        if (!first && glm::length(slide.x - cleared) < place_tolerance) return slide;
        first = false;
        cleared = slide.x;
        slide.walls.count = 0;
    }
    settle(scene, slide, tip, held);
    return slide;
}

}  // namespace thaum::haptics
