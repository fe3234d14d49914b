// game/bots/armoury.h: which wand a bot takes, by how far the foe is, whether something hides them, and the energy there is.
// A bot knows wands only by how their shots go.
#pragma once
#include "game/bots/mind.h"

namespace thaum::game {

/// Presses the key of mind.wand where it is not yet in hand, and lets fire go. True where it is.
bool in_hand(const Self& self, Mind& mind);

/// Chooses mind.wand and mind.readiness anew now and then, and presses the key of the wand that is not yet in hand. True where it
/// is.
bool choose_wand(const Simulation& match, const Self& self, const Seat& seat, Mind& mind, Tick tick);

}  // namespace thaum::game
