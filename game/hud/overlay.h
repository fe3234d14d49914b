// game/hud/overlay.h: the flat shapes that the HUD and the menus share.
#pragma once
#include <string>

#include "render/scene.h"

namespace thaum::game {

/// With a dark copy below it, so that it can be read on anything.
void add_text(render::Overlay& out, std::string words, fvec2 position, float size, fvec4 paint,
              render::Align align);

/// The mark of a team: ring or triangle.
void add_mark(render::Overlay& out, std::uint32_t team, fvec2 centre, float radius);

}  // namespace thaum::game
