// game/bots/armoury.h: chooses the wand of a bot by the foe's distance and cover and by the energy left. Bots
// know wands only by the flight of their shots.
#pragma once
#include "game/bots/turn.h"

namespace thaum::game::inline bots {

/// Selects mind.wand: if another wand is in hand, releases fire and presses the key of mind.wand. Returns
/// true if mind.wand is in hand.
bool in_hand(const Self& self, Mind& mind);

/// Chooses mind.wand and mind.readiness from time to time, and selects the wand. Returns true if mind.wand is
/// in hand.
bool choose_wand(const BotTurn& turn);

}  // namespace thaum::game::inline bots
