// game/hud/result_panel.h: the panel over the whole window at the end of a round or match, and in the pause of a
// replay.
#pragma once
#include "game/hud/hud.h"

namespace thaum::game {

/// Adds the panel, as large as the text size asks for and the window holds. It hides what is below it.
void add_result_panel(render::Overlay& out, const Picture& picture, const HudSettings& settings,
                      render::Rect window);

/// A match has a menu in its place.
void add_pause_panel(render::Overlay& out, const Picture& picture, const HudSettings& settings,
                     render::Rect window);

}  // namespace thaum::game
