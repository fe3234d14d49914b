// game/context/fog.h: what fog hides.
#pragma once
#include "core/maths.h"
#include "ecs/world.h"

namespace thaum::game {

/// Whether fog hides one place from another: the straight way between them leads far enough through clouds. Nobody sees
/// through fog, not even the wizard who cast it. Reads Fog and Motion.
bool hidden_by_fog(const ecs::World& world, vec3 from, vec3 to);

}  // namespace thaum::game
