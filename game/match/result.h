// game/match/result.h: the result of a match as text for people: shots, hits, harm and kills by cause.
#pragma once
#include "game/match/simulation.h"

namespace thaum::game::inline match {

/// Result of one player with one cause of harm over the whole match, such as "12 of 64 hit (19 %), 72 HP, 1
/// kill".
struct ResultRow {
    std::string_view cause;
    std::array<std::string, players> words;
    bool operator==(const ResultRow&) const = default;
};

using AllMatchStats = decltype(EventLog::match_stats);

/// Rows for all causes that have any result.
std::vector<ResultRow> result_rows(const AllMatchStats& match_stats);

/// Table with one line for each player, followed by the player's rows.
std::string result_table(const Simulation& match);

}  // namespace thaum::game::inline match
