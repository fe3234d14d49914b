// game/bots/swinging.h: how a bot swings over a gap on a rope if that saves it a detour.
#pragma once
#include "game/bots/aim.h"
#include "game/bots/turn.h"

namespace thaum::game::inline bots {

/// Finds all crossings of the arena: anchors (points to which a rope can attach) above a gap that has ground
/// of equal height on two opposite sides.
std::vector<Crossing> find_crossings(const Simulation& match, const WalkGrid& grid);

/// Whether the bot is crossing a gap; also true while it walks to the edge.
inline bool roped(const SwingPlan& swing_plan) { return swing_plan.stage != SwingStage::none; }
/// Whether the crossing occupies the bot's hands, which it does once the bot aims at the point for its rope.
inline bool hands_full(const SwingPlan& swing_plan) {
    return roped(swing_plan) && swing_plan.stage != SwingStage::approach;
}

/// Plans to swing over a gap nearby if that shortens the way to mind.goal by at least BotSkill::swing_gain.
void plan_to_swing(const BotTurn& turn);

/// Presses the buttons for the crossing while `roped`. Returns the displacement that the bot wants to walk
/// (m).
vec3 swing_over(const BotTurn& turn);
/// The wanted direction of view while `hands_full`.
Aim aim_on_rope(const Self& self, const SwingPlan& swing_plan);

}  // namespace thaum::game::inline bots
