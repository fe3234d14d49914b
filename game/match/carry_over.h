// game/match/carry_over.h: what of a running match goes on under other data: numbers that somebody has just changed.
//
// In the same arena everything stays as it is but for what the data decides: a wizard's body keeps its feet where they
// are, energy follows its wand to another slot. In another arena the scene begins anew, and the two wizards are in it
// where they were, looking where they looked, as they were.
#pragma once
#include "game/match/stage.h"

namespace thaum::game {

/// `to` is the first moment of a match by the new data.
void carry_over(const Stage& from, Stage& to);

}  // namespace thaum::game
