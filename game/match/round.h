// game/match/round.h: when a round begins, when it ends, and who has won it.
#pragma once
#include "game/match/stage.h"

namespace thaum::game {

/// The scene of a round's first moment: the arena as its file has it, both wizards on their pads. What was there is gone.
void open_round(Stage& stage);

/// Ends the round, and with the last one the match.
void add_round_system(Stage& stage, ecs::Schedule& schedule);

/// Between rounds: the next one comes when a player confirms, or by itself after a while.
void add_interval_system(Stage& stage, ecs::Schedule& schedule);
bool next_round_is_due(const Stage& stage);
void begin_next_round(Stage& stage);

}  // namespace thaum::game
