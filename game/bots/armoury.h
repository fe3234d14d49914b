// game/bots/armoury.h: chooses the wand of a bot by the foe's distance and cover and by the energy left. Of a
// wand, bots know only how its shots fly.
#pragma once
#include "game/bots/turn.h"

namespace thaum::game::inline bots {

/// Selects the wand that the bot has chosen (mind.wand). If another wand is in hand, releases fire and
/// presses the key of the chosen one. Returns true if the chosen wand is in hand.
bool in_hand(const Self& self, Mind& mind);

/// Chooses from time to time a wand (mind.wand) and how far to charge or draw it (mind.readiness), and
/// selects the wand. Returns true if mind.wand is in hand.
bool choose_wand(const BotTurn& turn);

}  // namespace thaum::game::inline bots
