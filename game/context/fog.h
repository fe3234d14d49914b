// game/context/fog.h: what fog hides.
#pragma once
#include "core/maths.h"
#include "ecs/world.h"

namespace thaum::game::inline context {

/// Whether fog hides one position from another: true if the straight line between them is long enough inside
/// clouds. All wizards, also the one who cast the fog, are blinded alike. Reads Fog and Motion.
bool hidden_by_fog(const ecs::World& world, vec3 from, vec3 to);

}  // namespace thaum::game::inline context
