// game/match/result.h: the result as people read it: who hit whom with what.
#pragma once
#include "game/match/simulation.h"

namespace thaum::game {

/// By one cause, for both players, over the whole match: "12 of 64 hit (19 %), 72 HP, 1 kill".
struct ResultRow {
    std::string_view cause;
    std::array<std::string, players> words;
};

using DeedsOfAll = decltype(Chronicle::deeds);

/// The causes by which anything was done.
std::vector<ResultRow> result_rows(const DeedsOfAll& deeds);

/// A line for each player and for each of their rows.
std::string result_table(const Simulation& match);

}  // namespace thaum::game
