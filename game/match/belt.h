// game/match/belt.h: the systems of the match that serve all wands.
#pragma once
#include "game/context/match_context.h"

namespace thaum::game::inline match {

/// Adds the system that selects the wand in hand, restores energy and uses the wand.
void add_belt_system(MatchContext& context, ecs::Schedule& schedule);

/// Adds the systems by which wands push bodies. They run before the bodies move.
void add_wand_forces(MatchContext& context, ecs::Schedule& schedule);

/// Adds the systems that move missiles. They run after the new positions of bodies are known.
void add_missile_systems(MatchContext& context, ecs::Schedule& schedule);

/// Ends the use of the wand in hand: drops its charge, or what it holds. Writes all components that wands may
/// write.
void put_away_wand(MatchContext& context, ecs::Entity wizard, Tick tick);

}  // namespace thaum::game::inline match
