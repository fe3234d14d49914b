// game/match/great_work.h: the Great Work (MANUAL.md, "The Great Work"). A wizard who holds both halves of
// it, Azoth and the Lens, for a set time wins the round. Death ends the attempt, since a dead wizard loses
// both halves.
#pragma once
#include "game/context/match_context.h"

namespace thaum::game::inline match {

/// Player who completes the Great Work in this tick, having held both its halves long enough, and so wins the
/// round; no_player: none. Reads GreatWork.
std::uint32_t great_worker(const MatchContext& context, Tick tick);

/// Time for which a player has held both halves of the Great Work (ticks); 0: the player does not hold both.
/// The halves are two rare things; to hold both long enough wins the round.
Tick held_both_for(const ecs::World& world, std::uint32_t player, Tick tick);

/// Adds the system that tracks, every gameplay tick, who holds both halves of the Great Work (two rare things
/// that win the round if held long enough).
void add_great_work_system(MatchContext& context, ecs::Schedule& schedule);

}  // namespace thaum::game::inline match
