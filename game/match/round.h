// game/match/round.h: when a round ends, and who has won it.
#pragma once
#include "game/match/stage.h"

namespace thaum::game {

void add_round_system(Stage& stage, ecs::Schedule& schedule);

}  // namespace thaum::game
