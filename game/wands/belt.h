// game/wands/belt.h: the systems that all wands share.
#pragma once
#include "game/match/stage.h"

namespace thaum::game {

/// Chooses the wand in hand, regains energy and uses the wand.
void add_belt_system(Stage& stage, ecs::Schedule& schedule);

/// The systems by which wands push bodies; before the bodies move.
void add_wand_forces(Stage& stage, ecs::Schedule& schedule);

/// The systems of what wands have sent off; after the bodies' places are known.
void add_missile_systems(Stage& stage, ecs::Schedule& schedule);

/// The wand in hand; null where the slot is empty.
const LoadedWand* wand_in_hand(const MatchData& data, const WandBelt& belt);

/// What the wand in hand still has; 0 where the slot is empty.
double energy_in_hand(const MatchData& data, const WandBelt& belt);

/// A full belt with the first wand in hand.
WandBelt full_belt(const MatchData& data);

}  // namespace thaum::game
