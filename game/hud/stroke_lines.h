// game/hud/stroke_lines.h: strokes as lines on the screen, x to the right and y upwards.
#pragma once

#include "game/hud/panel.h"
#include "gesture/stroke.h"
#include "render/scene.h"

namespace thaum::game::inline hud {

/// Maps hand positions to the screen.
struct StrokeFit {
    vec3 middle{};     ///< hand position that appears at `centre` (m)
    fvec2 centre{};    ///< position on the screen at which `middle` appears (px)
    double scale = 1;  ///< scale of the map (px/m)
};

/// The map with which a stroke fills a box. A stroke smaller than `min_size` is drawn as if it had that size
/// (m).
StrokeFit fit_stroke(gesture::Points stroke, const Panel& box, double min_size = 0.02);

struct StrokeLook {
    fvec4 colour{1};
    float width = 3;        ///< width of the line (px)
    bool by_force = false;  ///< true: green, yellow or red by the force at each point, instead of `colour`
};

void add_stroke(render::Overlay& out, gesture::Points stroke, const StrokeFit& fit, const StrokeLook& look);

/// Adds the ghost (faint shape) of a gesture: the path of its recorded stroke with an arrow at the start.
void add_ghost(render::Overlay& out, gesture::Points stroke, const Panel& box, fvec4 colour, float width);

}  // namespace thaum::game::inline hud
