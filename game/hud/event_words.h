// game/hud/event_words.h: words of events for players, made from the patterns of their rows.
#pragma once
#include <string>
#include <string_view>

#include "game/components/match.h"
#include "game/hud/figures.h"

namespace thaum::game {

/// Fills the names in braces of a row's words (game/data/presentation.h), such as {by} and {cause}.
/// `thing` is the thing that caused the event, such as "barrel"; empty: no thing.
std::string event_words(const std::string& pattern, const Event& event, const PlayerNames& names,
                        std::string_view thing = {});

/// A name with its first letter large.
std::string capitalised(std::string_view name);

}  // namespace thaum::game
