// game/match/spawn.h: turns the description of an arena into entities.
#pragma once
#include "ecs/world.h"
#include "game/arena/arena.h"

namespace thaum::game::inline match {

void spawn_arena(ecs::World& world, const Arena& arena);

/// Creates one body of the arena at its position. Scenarios also use this to build a scene.
ecs::Entity spawn_thing(ecs::World& world, const Thing& thing);

}  // namespace thaum::game::inline match
