// game/match/carry_over.h: continues a running match with other data, for example numbers that a player has
// just edited.
//
// If the arena is the same, and both or neither have spells, a brew, an orb and crystals, everything is kept
// except values that the data define: a wizard's body keeps the position of its feet, and energy follows its
// wand to another slot. Otherwise the scene is created again from the new arena, in which both wizards keep
// position, direction of view and state.
#pragma once
#include "game/context/match_context.h"

namespace thaum::game::inline match {

/// Copies state and outputs of `from` into `to`, a match with the new data that has played no tick yet. The
/// caller must then rebuild the brew's solver.
void carry_over(const MatchContext& from, MatchContext& to);

}  // namespace thaum::game::inline match
