// game/hud/stroke_picture.h: strokes as lines on the screen, x to the right and y upwards.
#pragma once
#include <span>

#include "game/hud/panel.h"
#include "gesture/stroke.h"
#include "render/scene.h"

namespace thaum::game {

/// Maps places of a hand to the screen.
struct StrokeFit {
    vec3 middle{};     ///< place that appears at `centre` (m)
    fvec2 centre{};    ///< (px)
    double scale = 1;  ///< px per m
};

/// The map by which a stroke fills a box. Strokes smaller than `least_size` are not made larger than it (m).
StrokeFit fit_stroke(gesture::Points stroke, const Panel& box, double least_size = 0.02);

struct StrokeLook {
    fvec4 colour{1};
    float width = 3;        ///< (px)
    bool by_force = false;  ///< true: green, yellow and red by the force of each point, instead of `colour`
};

/// Calls `take(from, to)` with the numbers of two points for each piece of a stroke's picture: for every step of the hand,
/// or, of a stroke of more than `most` steps, for pieces of about equal length. So a rest takes no pieces from the motion.
/// `at(i)` is the place of a point, a vector.
template <class At, class Take>
void each_piece(std::size_t count, std::size_t most, At&& at, Take&& take) {
    const auto step = [&](std::size_t i) { return static_cast<double>(glm::distance(at(i - 1), at(i))); };
    double length = 0, gone = 0;
    for (std::size_t i = 1; i < count; ++i) length += step(i);
    const double least = count > most + 1 ? length / static_cast<double>(most) : 0;
    for (std::size_t i = 1, from = 0; i < count; ++i) {
        gone += step(i);
        if (gone < least && i + 1 < count) continue;
        take(from, i);
        from = i;
        gone = 0;
    }
}

void add_stroke(render::Overlay& out, gesture::Points stroke, const StrokeFit& fit, const StrokeLook& look);

/// Adds the way of a stroke with an arrow at its start: the ghost of a gesture.
void add_ghost(render::Overlay& out, gesture::Points stroke, const Panel& box, fvec4 colour, float width);

}  // namespace thaum::game
