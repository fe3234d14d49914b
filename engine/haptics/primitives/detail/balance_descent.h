// haptics/primitives/detail/balance_descent.h: descent from kink to kink, for sets of primitives on which the
// smoothed problems of balance.cpp fail. It is slower than they are: where kinks meet, the steepest direction
// is found by iterating over their forces. It serves a few sets in a million, for example kinks that miss
// each other by a billionth of the problem's size.
#pragma once
#include "haptics/primitives/detail/optimality_check.h"

namespace thaum::haptics::balancing {

/// Descends from x until the sum of all forces is at most `accepted` (N). `best` keeps the best place.
void descend(Problem problem, vec3 x, double accepted, Solution& best, int& steps);

}  // namespace thaum::haptics::balancing
