// game/match/round.h: begins and ends the rounds of a match and decides who has won.
#pragma once
#include "game/stations/cauldron/cauldron.h"
#include "game/stations/crystal/crystal.h"

namespace thaum::game::inline match {

/// Replaces the scene by that of a new round: the arena as its file describes it, both wizards on the pads
/// where they start.
void open_round(MatchContext& context, BrewSolver& solver, CrystalBodies& crystals);

/// Adds the system that ends a round and, after the last round, the match.
void add_round_system(MatchContext& context, ecs::Schedule& schedule);

/// Adds the system that waits between rounds. The next round begins when a player confirms, or by itself
/// after a while.
void add_interval_system(MatchContext& context, ecs::Schedule& schedule);
bool next_round_is_due(const MatchContext& context);
void begin_next_round(MatchContext& context, BrewSolver& solver, CrystalBodies& crystals);

}  // namespace thaum::game::inline match
