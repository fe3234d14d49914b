// game/casting/free_casting.h: casting without a button, for players who chose this option
// (DeviceSpec::casts_freely).
//
//     each tick          -> mouse and stick, which also turn the view, move the hand's position
//     each gameplay tick -> the hand's position, or that of an arm, is added to the ring buffer of FreeHand
//     the hand rests     -> the motion just before is read (casting/free_reading.h) and may cast a spell
//
// A hand that shoots, stirs, draws with Trace or moves by the clutch casts nothing this way. Nor does a hand
// that moves on after the gesture, because it may be aiming, or drawing a figure that contains the gesture,
// as a star contains a V. Two spells are at least a set time apart. A motion that was almost a gesture is
// recorded in NearMiss, for the picture.
#pragma once
#include "ecs/schedule.h"
#include "game/components/free_hand.h"
#include "game/context/match_context.h"

namespace thaum::game::inline casting {

/// Whether the device of a player has the option to cast without a button.
bool casts_freely(const MatchContext& context, std::uint32_t player);

/// Adds the systems that cast spells without a button. Does nothing if no player has this option.
void add_free_casting_systems(MatchContext& context, ecs::Schedule& schedule);

}  // namespace thaum::game::inline casting
