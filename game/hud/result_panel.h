// game/hud/result_panel.h: the panel over the whole window at the end of a round or match, and while a replay
// is paused.
#pragma once
#include "game/hud/hud.h"

namespace thaum::game::inline hud {

/// Adds the panel for the end of a round or match, as large as the text size asks for and the window allows.
/// The panel covers the items behind it.
void add_result_panel(render::Overlay& out, const Picture& picture, const HudSettings& settings,
                      render::Rect window);

/// Adds the panel shown while a replay is paused. A paused match has a menu instead.
void add_pause_panel(render::Overlay& out, const Picture& picture, const HudSettings& settings,
                     render::Rect window);

}  // namespace thaum::game::inline hud
