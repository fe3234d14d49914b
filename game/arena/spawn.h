// game/arena/spawn.h: an arena's things become entities.
#pragma once
#include "ecs/world.h"
#include "game/arena/arena.h"

namespace thaum::game {

void spawn_arena(ecs::World& world, const Arena& arena);

/// One thing, at its place; how scenarios set a scene.
ecs::Entity spawn_thing(ecs::World& world, const Thing& thing);

}  // namespace thaum::game
