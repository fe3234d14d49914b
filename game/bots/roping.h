// game/bots/roping.h: how a bot swings over a gap on a rope where that saves it a way round.
#pragma once
#include "game/bots/aim.h"
#include "game/bots/nav.h"

namespace thaum::game {

/// A gap that one can swing over.
struct Crossing {
    vec3 from{}, anchor{}, to{};  ///< m: feet, anchor, feet
};

/// All that the arena has: to both sides of an anchor there is ground of one height, and none between.
std::vector<Crossing> find_crossings(const Simulation& match, const WalkGrid& grid);

/// Is it on its way over a gap, with the feet at least?
inline bool roped(const Climber& climber) { return climber.what != Roping::none; }
/// And with the hands?
inline bool hands_full(const Climber& climber) { return roped(climber) && climber.what != Roping::approach; }

/// Takes a crossing into mind where it is near and shortens the way to mind.goal by what the skill asks for.
void plan_to_swing(const Simulation& match, const Self& self, const Seat& seat, const WalkGrid& grid,
                   const std::vector<Crossing>& crossings, const WalkGrid::Ways& to_goal, const Mind& mind,
                   Climber& climber, Tick tick);

/// While roped: the way to walk, m, and whatever the hands have to do.
vec3 swing_over(const Simulation& match, const Self& self, const Seat& seat, Mind& mind, Climber& climber,
                Tick tick);
/// While hands_full: where the eye wants to be.
Aim aim_on_rope(const Self& self, const Climber& climber);

}  // namespace thaum::game
