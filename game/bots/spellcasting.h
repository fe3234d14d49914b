// game/bots/spellcasting.h: how a bot casts spells. It draws a stroke with its mouse while it holds the
// button Trace, as a person does: its view stands still meanwhile, it does not shoot, and a clumsy stroke
// casts no spell. It chooses a spell only by what the spell is worth to it (SpellRules::worth).
#pragma once
#include "game/bots/turn.h"

namespace thaum::game::inline bots {

/// A random style of drawing for a new bot.
DrawingStyle random_drawing_style(Random& random);

/// Whether the bot draws a stroke at present.
inline bool draws(const CastPlan& cast_plan) { return cast_plan.lasts != 0; }

/// From time to time considers whether to cast a spell, and begins its stroke. If the spell brings a thing,
/// also plans to catch that thing (LiftPlan).
void plan_to_cast(const BotTurn& turn);

/// Writes the hand's motion of this tick to the sample, in place of the turn of the view. Ends the stroke
/// when it is complete.
void draw_stroke(const Simulation& match, const Seat& seat, Tick tick, CastPlan& cast_plan,
                 input::DeviceSample& sample);

}  // namespace thaum::game::inline bots
