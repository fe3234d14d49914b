// game/match/bodies.h: between the World and the physics: bodies come and go with their component, one step of Bullet,
// blows of loose things against wizards, and the bodies' new places back into the World.
#pragma once
#include "game/match/stage.h"

namespace thaum::game {

/// Adding Body (to an entity with Motion) puts it into the physics, removing it takes it out.
void add_body_hooks(Stage& stage);

/// physics step, blows, places.
void add_body_systems(Stage& stage, ecs::Schedule& schedule);

/// HP, of a blow of so many N s.
double harm_of_blow(const WizardRules& rules, double impulse);

/// Motion of every body as the physics has it now.
void copy_places(Stage& stage);

/// A physics that holds exactly the bodies of the World, in canonical order.
void rebuild_physics(Stage& stage);

}  // namespace thaum::game
