// game/bots/turn.h: one gameplay tick of a bot, which all its plans get: what
// it knows, and what it may change.
#pragma once
#include "game/bots/mind.h"
#include "game/bots/nav.h"

namespace thaum::game::inline bots {

/// A gap that a wizard can swing over.
struct Crossing {
    vec3 from{}, anchor{}, to{};  ///< take-off (feet), anchor, landing (feet) (m, world)
};

/// Working memory for ways, kept for a bot: to its goal, and from its position.
struct BotWays {
    WalkGrid::Ways to_goal, from_here;
};

struct BotTurn {
    // What the bot knows.
    const Simulation& match;
    const Seat& seat;
    const WalkGrid& grid;                    ///< of the arena alone
    const std::vector<Crossing>& crossings;  ///< of the arena alone
    Tick tick;                               ///< ticks of play
    Self self;                               ///< the bot's own wizard in this tick (self_of)

    // What the bot may change: all its state, and caches.
    Eyes& eyes;
    Mind& mind;
    LiftPlan& lift_plan;
    SwingPlan& swing_plan;
    StirPlan& stir_plan;
    CastPlan& cast_plan;
    BotWays& ways;
};

}  // namespace thaum::game::inline bots
