// game/match/kind_tables.h: the numbers of events, causes of harm, wands, ingredients and power-ups, as a log's header
// has them. Saved states and samples contain these numbers, so a log replays only in a program that numbers all kinds
// alike.
#pragma once
#include "game/data/match_data.h"
#include "input/log.h"

namespace thaum::game {

/// Tables "cause", "event", "ingredient", "potion", "power_up" and "wand". A wand's number is that of its key, as in input::DeviceSample::wand.
std::vector<input::KindTable> kind_tables(const MatchData& data);

/// First difference between the tables of a log and those of this program, in one line; empty if there is none.
std::string kind_difference(const std::vector<input::KindTable>& recorded,
                            const std::vector<input::KindTable>& here);

}  // namespace thaum::game
