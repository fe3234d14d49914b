// game/bots/senses.h: senses of a bot: the foe, power-ups, loose things and missiles that it sees. A bot sees
// nothing behind its back or behind a wall, and reacts no sooner than its reaction time allows.
#pragma once
#include "game/bots/mind.h"

namespace thaum::game::inline bots {

/// The bot's own wizard. `readiness`: how far the bot wants to charge or draw the wand in hand, 0 to 1.
Self self_of(const Simulation& match, std::uint32_t player, double readiness = 0);

/// Writes position and velocity of the foe, as seen one reaction time ago, to `mind`.
void see_foe(const Simulation& match, const Self& self, const Seat& seat, Eyes& eyes, Mind& mind, Tick tick);

/// Looks at one power-up per call. If it is in view, notes when it is available again; the power-up's ring
/// shows that to players, too.
void see_power_ups(const Simulation& match, const Self& self, const Seat& seat, Eyes& eyes);

/// Looks at one loose thing per call. If it is in view, notes its position.
void see_things(const Simulation& match, const Self& self, const Seat& seat, Eyes& eyes);

/// Whether the bot's crosshair is on this loose thing, and the thing is within `reach` (m).
bool crosshair_on(const Simulation& match, const Self& self, ecs::Entity thing, double reach);

/// Whether the bot sees a shot of the foe coming towards it.
bool sees_a_shot_come(const Simulation& match, const Self& self, const Seat& seat);

/// Direction of a side step that avoids a bolt: -1 left, 1 right, 0 if no bolt comes. A bolt counts only if
/// it has been in flight for the bot's reaction time.
std::int32_t step_aside(const Simulation& match, const Self& self, const Seat& seat, const Mind& mind);

}  // namespace thaum::game::inline bots
