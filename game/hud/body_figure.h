// game/hud/body_figure.h: a picture of the vibrations that a player feels on the body: the cells of front and
// back as white dots on a dark ground, larger for stronger vibration. So the picture needs no colours.
#pragma once
#include <array>

#include "game/hud/overlay.h"
#include "game/hud/panel.h"
#include "game/picture/picture.h"

namespace thaum::game::inline hud {

/// Size of the figure, front and back with a gap between them, where a view has enough room for it (HUD
/// units).
inline constexpr float figure_wide = 90, figure_high = 62;

/// Adds the figure. `felt` has the strength of the vibration in each cell, 0 to 1. Nothing is added to an
/// empty panel.
void add_figure(render::Overlay& out, const Panel& panel, const std::array<float, figure_cells>& felt);

}  // namespace thaum::game::inline hud
