// game/match/life.h: death, return to life, and the slow loss of health above the initial value.
#pragma once
#include "game/context/match_context.h"

namespace thaum::game::inline match {

void add_life_systems(MatchContext& context, ecs::Schedule& schedule);

/// The pad (place where wizards start) that is farthest from a position; the first one if two are equally
/// far.
Pad farthest_pad(const ecs::World& world, vec3 from);

}  // namespace thaum::game::inline match
