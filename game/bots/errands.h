// game/bots/errands.h: decides when a bot stops fighting to fetch a power-up or to hide.
#pragma once
#include "game/bots/mind.h"
#include "game/bots/nav.h"

namespace thaum::game {

/// Chooses mind.errand and mind.goal every quarter of a second. `from_here` is working memory for ways.
void choose_errand(const Simulation& match, const Self& self, const Seat& seat, const Eyes& eyes,
                   const WalkGrid& grid, WalkGrid::Ways& from_here, Mind& mind, Tick tick);

}  // namespace thaum::game
