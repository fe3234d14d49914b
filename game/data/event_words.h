// game/data/event_words.h: texts that tell players of events. Data files have a pattern for each kind of
// event, such as "{by} hits {whom}".
#pragma once
#include <string>
#include <string_view>

#include "game/components/match.h"
#include "game/data/presentation.h"
#include "game/data/teams.h"

namespace thaum::game::inline data {

/// Replaces the names in braces in a pattern (game/data/presentation.h), such as {by} and {cause}. `thing` is
/// the thing that caused the event, such as "barrel"; empty: no thing did. `shown` names spells,
/// potions and ingredients.
std::string event_words(const std::string& pattern, const Event& event, const PlayerNames& names,
                        std::string_view thing = {}, const Presentation& shown = {});

/// Whether the event was caused by the affected player or by nobody, but not by another player.
bool is_alone(const Event& event);
/// The pattern of an event's line in the feed, the list of recent events on the screen. There are different
/// patterns for events caused by another player, by no other player, and by a mere fall.
const std::string& feed_pattern(const EventRow& row, const Event& event);

}  // namespace thaum::game::inline data
