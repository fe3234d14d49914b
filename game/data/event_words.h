// game/data/event_words.h: words of events for players, made from the patterns of their rows.
#pragma once
#include <string>
#include <string_view>

#include "game/components/match.h"
#include "game/data/presentation.h"
#include "game/data/teams.h"

namespace thaum::game::inline data {

/// Replaces names in braces in a text (game/data/presentation.h), such as {by} and {cause}. `thing` is the
/// thing that caused the event, such as "barrel"; empty: no thing. `brew` names potions and ingredients.
std::string event_words(const std::string& pattern, const Event& event, const PlayerNames& names,
                        std::string_view thing = {}, const BrewWords& brew = {});

/// Whether no one but the affected player caused the event.
bool is_alone(const Event& event);
/// The pattern of an event's line in the feed. There are different patterns for events caused by another
/// player, by no one, and by a mere fall.
const std::string& feed_pattern(const EventRow& row, const Event& event);

}  // namespace thaum::game::inline data
