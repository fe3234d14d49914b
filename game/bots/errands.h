// game/bots/errands.h: decides when a bot stops fighting to fetch a power-up or to hide (an errand).
#pragma once
#include "game/bots/turn.h"

namespace thaum::game::inline bots {

/// Chooses what the bot does instead of fighting (mind.errand) and where it walks for that (mind.goal), every
/// quarter of a second.
void choose_errand(const BotTurn& turn);

}  // namespace thaum::game::inline bots
