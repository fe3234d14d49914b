// game/match/bare_probe.h: the wand's tip as a probe: walls, props and the bowl's rim push the hand that holds it.
//
// The device's frame lies in the world at the tip of a wand whose hand rests, turned as the wizard looks; a metre of the hand is
// wand_m_per_m metres there. When he turns or walks, the world moves over that frame: the servo takes that out again
// (haptics::Drift), so that neither kicks nor presses the hand, and only its own motion and that of props is felt. Things are pushed
// away as hard as they are felt: a newton on them is n_per_n at the hand.
#pragma once
#include "game/components/grip.h"
#include "game/match/stage.h"

namespace thaum::game {

/// Writes patch, drift, start and number of the model; an empty patch where nothing is within reach. Writes the Grip's frame.
void feel_about(const Stage& stage, ecs::Entity wizard, Grip& grip, haptics::HapticModel& model);

/// Every tick, before bodies move: what the tip touches gets the opposite of what the hand feels of it, in the world's measure.
/// What the safety stage takes from the hand it does not take from the thing.
void add_probe_system(Stage& stage, ecs::Schedule& schedule);

}  // namespace thaum::game
