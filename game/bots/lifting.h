// game/bots/lifting.h: how a bot takes loose things up, holds them between itself and shots, and throws them at its foe.
#pragma once
#include "game/bots/aim.h"
#include "game/bots/nav.h"

namespace thaum::game {

/// Is the wand that lifts in use?
inline bool hands_full(const Porter& porter) {
    return porter.what == Porting::take || porter.what == Porting::hold;
}

/// Now and then takes a thing into mind that is worth a throw, and walks to it as an errand; ends that where something else has
/// become more urgent.
void plan_to_lift(const Simulation& match, const Self& self, const Seat& seat, const Eyes& eyes,
                  const WalkGrid& grid, Mind& mind, Porter& porter, Tick tick);

/// While hands_full: works the wand by its buttons. Returns where the eye wants to be.
Aim handle_thing(const Simulation& match, const Self& self, const Seat& seat, Mind& mind, Porter& porter,
                 Tick tick);

}  // namespace thaum::game
