// game/match/kind_tables.h: the numbers of causes of harm, events, ingredients, potions, power-ups, spells
// and wands, as a log's header stores them. Saved states and samples contain these numbers, so a log can only
// be replayed by a program with the same numbers.
#pragma once
#include "game/data/match_data.h"
#include "input/log.h"

namespace thaum::game::inline match {

/// Tables "cause", "event", "ingredient", "potion", "power_up", "spell" and "wand"; no "potion" if the data
/// have no recipes, and no "spell" if they have no spells. A wand's number is the number of its key, as in
/// input::DeviceSample::wand.
std::vector<input::KindTable> kind_tables(const MatchData& data);

/// First kind of a log's tables whose number means another kind in this program, in one line; empty if
/// there is none. Further wands, spells, potions and the like are no difference, because no state of the
/// log contains them; further events are, because this program may record them.
std::string kind_difference(const std::vector<input::KindTable>& recorded,
                            const std::vector<input::KindTable>& here);

}  // namespace thaum::game::inline match
