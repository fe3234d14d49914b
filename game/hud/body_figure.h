// game/hud/body_figure.h: a picture of what the body feels: the cells of the body's front and back as white
// dots on dark, larger for stronger effects. So it needs no colours.
#pragma once
#include <array>

#include "game/hud/overlay.h"
#include "game/hud/panel.h"
#include "game/picture/picture.h"

namespace thaum::game::inline hud {

/// Size of the figure if there is room (HUD units): front and back with a gap between them.
inline constexpr float figure_wide = 90, figure_high = 62;

/// Adds the figure. `felt` has a strength of 0 to 1 for each cell. Nothing is added to an empty panel.
void add_figure(render::Overlay& out, const Panel& panel, const std::array<float, figure_cells>& felt);

}  // namespace thaum::game::inline hud
