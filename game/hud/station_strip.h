// game/hud/station_strip.h: what a player at a station sees in place of the strip of wands, since the same
// keys choose something else there: haptic modes at the orb, tools at a crystal.
#pragma once
#include "game/hud/layout.h"
#include "render/scene.h"

namespace thaum::game::inline hud {

/// Adds the strip of a player who works at the orb or at a crystal: each mode or tool with the key that
/// chooses it, on a plate if it is active. Returns false and adds nothing for other players.
bool add_station_strip(render::Overlay& out, const Picture& picture, const ControlNames& controls,
                       std::uint32_t player, const ViewLayout& l);

}  // namespace thaum::game::inline hud
