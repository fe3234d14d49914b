// game/bots/lifting.h: how a bot takes up loose things, holds them as shields and throws them at the foe.
#pragma once
#include "game/bots/aim.h"
#include "game/bots/turn.h"

namespace thaum::game::inline bots {

/// Whether the bot takes up or holds a thing, so that its wand is in use.
inline bool hands_full(const LiftPlan& lift_plan) {
    return lift_plan.stage == LiftStage::take || lift_plan.stage == LiftStage::hold;
}

/// Chooses from time to time a thing that is worth a throw, and walks to it as an errand. Gives up if
/// something else becomes more urgent.
void plan_to_lift(const BotTurn& turn);

/// Uses the wand for a thing that the bot takes up or holds (hands_full). Returns the wanted direction of
/// view.
Aim handle_thing(const BotTurn& turn);

}  // namespace thaum::game::inline bots
