// haptics/primitives/detail/balance_descent.h: descent from kink to kink, for sets on which the path of
// balance.cpp fails. It is slower than the path: where kinks meet, the steepest direction is found by
// iterating over their forces. It serves a few sets in a million, for example kinks that miss each other by a
// billionth of the problem's size.
#pragma once
#include "haptics/primitives/detail/optimality_check.h"

namespace thaum::haptics::balancing {

/// Descends from x until the forces cancel, but for at most `accepted` (N). Improves `best`.
void descend(Problem problem, vec3 x, double accepted, Solution& best, int& steps);

}  // namespace thaum::haptics::balancing
