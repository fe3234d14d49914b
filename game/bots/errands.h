// game/bots/errands.h: decides when a bot stops fighting to fetch a power-up or to hide.
#pragma once
#include "game/bots/turn.h"

namespace thaum::game::inline bots {

/// Chooses mind.errand and mind.goal every quarter of a second.
void choose_errand(const BotTurn& turn);

}  // namespace thaum::game::inline bots
