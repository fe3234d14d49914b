// game/bots/errands.h: when a bot leaves off fighting: for what it needs and how far that is, or to hide.
#pragma once
#include "game/bots/mind.h"
#include "game/bots/nav.h"

namespace thaum::game {

/// Chooses mind.errand and mind.goal anew every quarter of a second. `from_here` is memory for the ways.
void choose_errand(const Simulation& match, const Self& self, const Seat& seat, const Eyes& eyes,
                   const WalkGrid& grid, WalkGrid::Ways& from_here, Mind& mind, Tick tick);

}  // namespace thaum::game
