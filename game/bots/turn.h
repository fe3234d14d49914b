// game/bots/turn.h: the data of one gameplay tick of a bot, an argument of all its plans: what the bot knows,
// and what the plan may change.
#pragma once
#include "game/bots/mind.h"
#include "game/bots/nav.h"

namespace thaum::game::inline bots {

/// A gap that a wizard can swing over.
struct Crossing {
    /// Take-off (feet), point to which the rope attaches, landing (feet) (m, world)
    vec3 from{}, anchor{}, to{};
};

/// Search results for ways, kept for a bot: ways to its goal, and ways from its position.
struct BotWays {
    WalkGrid::Ways to_goal, from_here;
};

struct BotTurn {
    // The members from here to `self` are what the bot knows.
    const Simulation& match;
    const Seat& seat;
    const WalkGrid& grid;                    ///< walkable ground of the arena
    const std::vector<Crossing>& crossings;  ///< all crossings of the arena
    Tick tick;                               ///< present tick of play
    Self self;                               ///< the bot's own wizard in this tick (self_of)

    // The members from here on are what the bot may change: its whole state, and caches.
    Eyes& eyes;
    Mind& mind;
    LiftPlan& lift_plan;
    SwingPlan& swing_plan;
    StirPlan& stir_plan;
    CastPlan& cast_plan;
    BotWays& ways;
};

}  // namespace thaum::game::inline bots
