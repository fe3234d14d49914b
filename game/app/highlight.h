// game/app/highlight.h: the moment of a match that is worth a picture.
#pragma once
#include "game/match/simulation.h"

namespace thaum::app {

/// The closest that the two have come to each other while both lived, player 1 saw the other and something flew.
struct Highlight {
    double distance = 1e9;  ///< m
    Tick tick = 0;          ///< 0: there was none
};

/// Looks at the match every so many ticks.
inline constexpr Tick highlight_interval = 50;

/// Call after every tick.
void watch_for_highlight(const game::Simulation& match, Highlight& best);

}  // namespace thaum::app
