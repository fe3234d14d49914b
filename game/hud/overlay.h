// game/hud/overlay.h: flat shapes that the HUD and the menus share.
#pragma once
#include <string>

#include "render/scene.h"

namespace thaum::game {

/// Adds text with a dark copy below it, readable on any background.
void add_text(render::Overlay& out, std::string words, fvec2 position, float size, fvec4 paint,
              render::Align align);

/// Adds the mark of a team: a ring or a triangle.
void add_mark(render::Overlay& out, std::uint32_t team, fvec2 centre, float radius);

}  // namespace thaum::game
