// game/hud/station_card.h: the card of a wizard at the orb or at a crystal, in the form of the card at the
// cauldron (rim_card.h).
//
//     +-------+  Find the core, stay there for 1.5 s                             the next step
//     | curve |  Force and follow, [1] to [6] change                             the state
//     |       |  Haste 12 s                                                      potions that act now
//     +-------+  [===|       ]                                                   time at the core, or overlap
//                [=======    ]                                                   focus
#pragma once
#include "game/hud/rim_card.h"

namespace thaum::game::inline hud {

/// Whether a player is at a station (cauldron, orb or crystal), so that a card, a panel about the work there,
/// is shown for that player.
bool has_card(const PlayerPicture& p);

/// The card of a player who is at a station.
RimCard card_of(const Picture& picture, const HudSettings& settings, std::uint32_t player);

}  // namespace thaum::game::inline hud
