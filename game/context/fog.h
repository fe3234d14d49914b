// game/context/fog.h: whether clouds of fog hide something from view.
#pragma once
#include "core/maths.h"
#include "ecs/world.h"

namespace thaum::game::inline context {

/// Whether fog hides one position from another: true if the straight line between them runs far enough
/// through clouds. All wizards are blinded alike, also the one who cast the fog. Reads Fog and Motion.
bool hidden_by_fog(const ecs::World& world, vec3 from, vec3 to);

}  // namespace thaum::game::inline context
