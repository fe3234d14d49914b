// game/match/life.h: death, resurrection, and the health that is too much.
#pragma once
#include "game/match/stage.h"

namespace thaum::game {

void add_life_systems(Stage& stage, ecs::Schedule& schedule);

/// The pad farthest from a place; of two equally far ones the first.
Pad farthest_pad(const ecs::World& world, vec3 from);

}  // namespace thaum::game
