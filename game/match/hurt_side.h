// game/match/hurt_side.h: the direction from which a player is hurt, for code that shows it or puts it into
// words.
#pragma once
#include <optional>

#include "game/match/simulation.h"

namespace thaum::game::inline match {

/// Whether events of this kind hit their subject's body from a side, with or without harm.
bool strikes_body(EventKind kind);

/// Vector from the middle of the player's body towards the cause of an event (m, world). It points to the
/// event's place if that is beside the body, otherwise to the player who caused the event. So a burst may be
/// behind the player although the foe is in front. std::nullopt: no direction, as for a fall.
std::optional<vec3> way_to_cause(const Simulation& match, const Event& event, std::uint32_t player);

/// Like way_to_cause, but for words and for marks on the screen. A hit on the body comes from the direction
/// of the player who caused it, wherever on the body it is. A burst beside the body comes from the place of
/// the burst.
std::optional<vec3> way_to_source(const Simulation& match, const Event& event, std::uint32_t player);

}  // namespace thaum::game::inline match
