// game/bots/senses.h: senses of a bot: the foe, power-ups, loose things and missiles that it sees. A bot sees
// nothing behind its back or behind a wall, and reacts no sooner than its reaction time allows.
#pragma once
#include "game/bots/mind.h"

namespace thaum::game::inline bots {

/// The bot's own wizard. `readiness` is the readiness to which the bot wants to ready the wand in hand.
Self self_of(const Simulation& match, std::uint32_t player, double readiness = 0);

/// Writes position and velocity of the foe, as seen one reaction time ago, to `mind`.
void see_foe(const Simulation& match, const Self& self, const Seat& seat, Eyes& eyes, Mind& mind, Tick tick);

/// Looks at one power-up per call. If it is in view, notes when it is available again (its ring shows that).
void see_power_ups(const Simulation& match, const Self& self, const Seat& seat, Eyes& eyes);

/// Looks at one loose thing per call. If it is in view, notes its position.
void see_things(const Simulation& match, const Self& self, const Seat& seat, Eyes& eyes);

/// Whether the crosshair is on the thing within `reach` (m).
bool crosshair_on(const Simulation& match, const Self& self, ecs::Entity thing, double reach);

/// Whether the bot sees a shot of the foe coming.
bool sees_a_shot_come(const Simulation& match, const Self& self, const Seat& seat);

/// Direction of a step that avoids a bolt: -1 left, 1 right, 0 if no bolt comes. Only bolts seen for long
/// enough count.
std::int32_t step_aside(const Simulation& match, const Self& self, const Seat& seat, const Mind& mind);

}  // namespace thaum::game::inline bots
