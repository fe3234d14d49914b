// haptics/balance_descent.h: where the path of balance.cpp fails: from kink to kink, always down. Slower, and the steepest direction where
// kinks meet comes from rounds over their forces. It serves a few sets in a million, such as kinks that miss each other by a
// billionth of the rest.
#pragma once
#include "haptics/optimality_check.h"

namespace thaum::haptics::balancing {

/// From x on, until what is missing is at most `accepted`, N. Improves on `best`.
void descend(Problem problem, vec3 x, double accepted, Solution& best, int& steps);

}  // namespace thaum::haptics::balancing
