// game/hud/view_overlay.h: the overlay of one player's view: crosshair, health, wands, messages.
#pragma once
#include "game/hud/layout.h"
#include "render/scene.h"

namespace thaum::game::inline hud {

/// Adds the overlay of one player's view, which must be present in `layout`.
void add_view_overlay(render::Overlay& out, const Picture& picture, const HudSettings& settings,
                      std::uint32_t player, const HudLayout& layout);

}  // namespace thaum::game::inline hud
