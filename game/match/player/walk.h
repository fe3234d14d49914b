// game/match/player/walk.h: moves wizards: walking, jumping and harm by falls.
#pragma once
#include "game/context/match_context.h"

namespace thaum::game::inline match {

/// Adds the system that turns Controls and Gaze into impulses on the wizard's body, before each physics step.
/// A hard landing takes health.
void add_walk_system(MatchContext& context, ecs::Schedule& schedule);

/// Description of a wizard's body.
Body wizard_body(const WizardRules& rules);
/// Motion of a wizard who stands still with the feet at a position (m, world).
Motion standing_at(const WizardRules& rules, vec3 feet);

}  // namespace thaum::game::inline match
