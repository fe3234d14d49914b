// game/hud/result_panel.h: the panel over the whole window at the end of a round or match, and in the pause of a
// replay.
#pragma once
#include "game/hud/hud.h"

namespace thaum::game {

/// `unit`: length of a HUD unit (px). The panel shrinks to fit the window.
void add_result_panel(render::Overlay& out, const Picture& picture, const HudSettings& settings,
                      render::Rect window, float unit);

/// A match has a menu in its place.
void add_pause_panel(render::Overlay& out, const Picture& picture, const HudSettings& settings,
                     render::Rect window, float unit);

}  // namespace thaum::game
