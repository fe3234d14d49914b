// game/bots/stirring.h: how a bot stirs the cauldron. It walks to the rim if its wand lacks energy and
// no foe is in sight, or if the foe stirs. There it moves its hand in circles. A bot that can brew also
// goes there for a potion (brewing.h).
#pragma once
#include "game/bots/turn.h"

namespace thaum::game::inline bots {

/// Plans the bot's actions at the cauldron. While the bot walks there, writes mind.errand and mind.goal.
void plan_to_stir(const BotTurn& turn);

/// Whether the bot stirs at present.
inline bool stirs(const StirPlan& stir_plan) { return stir_plan.stage == StirStage::stir; }

/// Writes the motion of a hand that stirs in circles to the sample of this tick.
void stir_hand(Tick tick, input::DeviceSample& sample);
/// Writes the motion of a bot's hand at the cauldron to the sample of this
/// tick: circles, a drop or a gesture.
void brew_hand(const Simulation& match, const Seat& seat, const StirPlan& stir_plan, Tick tick,
               input::DeviceSample& sample);

}  // namespace thaum::game::inline bots
