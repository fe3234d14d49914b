// game/match/carry_over.h: carries a running match over to other data, for example numbers that a player has
// just edited.
//
// If the arena is the same, and both have spells, a brew and an orb or both have none, everything stays except
// what the data decides: a wizard's body keeps the position of its feet, and energy follows its wand to another
// slot. If not, the scene is created again from the new arena. Both wizards keep position, direction of view and
// state there.
#pragma once
#include "game/context/match_context.h"

namespace thaum::game {

/// Copies the state and the outputs of `from` into `to`, a match by the new data that has not run yet. The brew
/// must then be rebuilt.
void carry_over(const MatchContext& from, MatchContext& to);

}  // namespace thaum::game
