// game/bots/senses.h: what a bot can see: the foe, things to pick up, bolts that come at it. Nothing behind its back, nothing
// behind a wall, and nothing sooner than its reaction allows.
#pragma once
#include "game/bots/mind.h"

namespace thaum::game {

/// `readiness`: to which it wants to ready the wand in hand.
Self self_of(const Simulation& match, std::uint32_t player, double readiness = 0);

/// Notes where the foe is, as it was a reaction time ago, and how it moves.
void see_foe(const Simulation& match, const Self& self, const Seat& seat, Eyes& eyes, Mind& mind, Tick tick);

/// Looks at one power-up a time, if it is in view: whether it is there, or how far its ring has filled.
void see_power_ups(const Simulation& match, const Self& self, const Seat& seat, Eyes& eyes);

/// Looks at one loose thing a time: where it lies.
void see_things(const Simulation& match, const Self& self, const Seat& seat, Eyes& eyes);

/// Is the crosshair on it, and is it no farther than that, m?
bool crosshair_on(const Simulation& match, const Self& self, ecs::Entity thing, double reach);

/// Does a shot of the foe come that it can see?
bool sees_a_shot_come(const Simulation& match, const Self& self, const Seat& seat);

/// Which way to step, -1 or 1 as seen by the bot, so that a bolt that it has seen for long enough passes; 0: none comes.
std::int32_t step_aside(const Simulation& match, const Self& self, const Seat& seat, const Mind& mind);

}  // namespace thaum::game
