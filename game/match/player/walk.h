// game/match/player/walk.h: moves wizards: walking, jumping and harm by falls.
#pragma once
#include "game/context/match_context.h"

namespace thaum::game {

/// Adds the system that runs before each physics step. Controls and Gaze become impulses on the wizard's
/// body. A hard landing takes health.
void add_walk_system(MatchContext& context, ecs::Schedule& schedule);

/// Description of a wizard's body.
Body wizard_body(const WizardRules& rules);
/// Motion of a wizard who stands still with the feet at that position (m, world).
Motion standing_at(const WizardRules& rules, vec3 feet);

}  // namespace thaum::game
