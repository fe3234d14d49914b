// game/hud/feed_overlay.h: the feed of events in a player's view.
#pragma once
#include "game/hud/layout.h"
#include "render/scene.h"

namespace thaum::game {

/// Adds the newest lines of the feed, as many as there is room for. Where room lacks, the foe's recipes give way first,
/// since the player needs the own one.
void add_feed(render::Overlay& out, const Picture& picture, const PlayerNames& names, std::uint32_t player,
              const ViewLayout& l);

}  // namespace thaum::game
