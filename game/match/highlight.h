// game/match/highlight.h: finds the moment of a match that makes the best picture.
#pragma once
#include "game/match/simulation.h"

namespace thaum::game::inline match {

/// The tick at which the two wizards were closest to each other. Only ticks count at which both lived, each
/// saw the other and a missile flew.
struct Highlight {
    double distance = 1e9;  ///< distance between the wizards at the chosen tick (m)
    Tick tick = 0;          ///< tick of the moment; 0: none found
};

/// Number of ticks between two looks at the match.
inline constexpr Tick highlight_interval = 50;

/// Updates `best` from the match; call this after every tick.
void watch_for_highlight(const Simulation& match, Highlight& best);

}  // namespace thaum::game::inline match
