// game/bots/stirring.h: how a bot stirs: it walks to the cauldron's rim when its wands want filling and nobody is in sight, or when its foe
// stirs, and then goes round in circles with its hand.
#pragma once
#include "game/bots/mind.h"

namespace thaum::game {

/// Chooses what the bot does at the cauldron, and with it mind.errand and mind.goal while it walks there.
void plan_to_stir(const Simulation& match, const Self& self, const Seat& seat, Mind& mind, Stirrer& stirrer,
                  Tick tick);

/// Whether its hand is at the ladle.
inline bool stirs(const Stirrer& stirrer) { return stirrer.what == AtCauldron::stir; }

/// What the hand does in this tick.
void stir_hand(Tick tick, input::DeviceSample& sample);

}  // namespace thaum::game
