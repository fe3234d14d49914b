// game/player/walk.h: wizards walk, jump and fall.
#pragma once
#include "game/match/stage.h"

namespace thaum::game {

/// Before each physics step: Controls and Gaze become impulses on the wizard's body; hard landings hurt.
void add_walk_system(Stage& stage, ecs::Schedule& schedule);

/// A wizard's body, standing with its feet there.
Body wizard_body(const WizardRules& rules);
Motion standing_at(const WizardRules& rules, vec3 feet);

}  // namespace thaum::game
