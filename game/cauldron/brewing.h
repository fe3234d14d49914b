// game/cauldron/brewing.h: what the brew means in the match (game.md, "Cauldron"): whose it is, what it does to who is near, and when it
// spoils; where ingredients are found, and who carries one.
#pragma once
#include "game/cauldron/cauldron.h"

namespace thaum::game {

/// Where the arena has them.
void spawn_niches(Stage& stage);

/// The part of his walking speed that a wizard there has: less beside a thick brew.
double pace_at(const MatchData& data, const ecs::World& world, vec3 place);

/// Every gameplay tick: ingredients picked up and dropped in, the owner, the wands of who stirs with the flow, spoiling; every tick: what is
/// light beside a light brew.
void add_brewing_systems(Stage& stage, ecs::Schedule& schedule);

/// J, that a ladle did in the last second and a half.
double recent_work(const Ladle& ladle);

}  // namespace thaum::game
