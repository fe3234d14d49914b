// game/match/highlight.h: the moment of a match that makes the best picture.
#pragma once
#include "game/match/simulation.h"

namespace thaum::app {

/// Tick at which the two wizards were closest, among ticks when both lived, each saw the other and something
/// flew.
struct Highlight {
    double distance = 1e9;  ///< distance between the wizards at that tick (m)
    Tick tick = 0;          ///< 0: no such moment
};

/// Number of ticks between two looks at the match.
inline constexpr Tick highlight_interval = 50;

/// Updates `best` from the match; call this after every tick.
void watch_for_highlight(const game::Simulation& match, Highlight& best);

}  // namespace thaum::app
