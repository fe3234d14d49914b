// game/bots/swinging.h: how a bot swings over a gap on a rope if that saves it a detour.
#pragma once
#include "game/bots/aim.h"
#include "game/bots/nav.h"

namespace thaum::game {

/// A gap that a wizard can swing over.
struct Crossing {
    vec3 from{}, anchor{}, to{};  ///< take-off (feet), anchor, landing (feet) (m, world)
};

/// Finds all crossings of the arena: anchors with ground of equal height on two opposite sides and a gap
/// between.
std::vector<Crossing> find_crossings(const Simulation& match, const WalkGrid& grid);

/// Whether the bot is on its way over a gap, walking to the edge included.
inline bool roped(const SwingPlan& swing_plan) { return swing_plan.stage != SwingStage::none; }
/// Whether the crossing also occupies the bot's hands, from aiming at the anchor on.
inline bool hands_full(const SwingPlan& swing_plan) {
    return roped(swing_plan) && swing_plan.stage != SwingStage::approach;
}

/// Plans a crossing that is near and shortens the way to mind.goal by at least the length in the skill.
void plan_to_swing(const Simulation& match, const Self& self, const Seat& seat, const WalkGrid& grid,
                   const std::vector<Crossing>& crossings, const WalkGrid::Ways& to_goal, const Mind& mind,
                   SwingPlan& swing_plan, Tick tick);

/// Presses the buttons for the crossing while roped. Returns the displacement to walk (m).
vec3 swing_over(const Simulation& match, const Self& self, const Seat& seat, Mind& mind,
                SwingPlan& swing_plan, Tick tick);
/// The wanted direction of view while hands_full.
Aim aim_on_rope(const Self& self, const SwingPlan& swing_plan);

}  // namespace thaum::game
