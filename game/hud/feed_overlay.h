// game/hud/feed_overlay.h: the feed, a list of recent events, in a player's view.
#pragma once
#include "game/hud/layout.h"
#include "render/scene.h"

namespace thaum::game::inline hud {

/// Adds the newest lines of the feed, as many as fit. If room is short, lines about the foe's recipes are
/// dropped first, since the player needs those about recipes of the player's own.
void add_feed(render::Overlay& out, const Picture& picture, const PlayerNames& names, std::uint32_t player,
              const ViewLayout& l);

}  // namespace thaum::game::inline hud
