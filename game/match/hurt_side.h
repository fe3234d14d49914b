// game/match/hurt_side.h: the side from which a player is hurt, for readers who tell or show it.
#pragma once
#include <optional>

#include "game/match/simulation.h"

namespace thaum::game {

/// Whether an event of this kind strikes the body of its subject from a side, be it harm or not.
bool strikes_body(EventKind kind);

/// Way from the middle of the player's body towards what has hurt it (m, world): the place of the event, or
/// the player who caused it. A burst may be behind, although the foe is ahead. std::nullopt: from no side, as a fall.
std::optional<vec3> way_to_cause(const Simulation& match, const Event& event, std::uint32_t player);

/// The same for words and marks: what has struck the body comes from the player who caused it, wherever on the body it
/// struck. A burst beside the body comes from its own place.
std::optional<vec3> way_to_source(const Simulation& match, const Event& event, std::uint32_t player);

}  // namespace thaum::game
