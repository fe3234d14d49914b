// game/casting/free_reading.h: reads the motion of a hand that casts without a button, once the hand rests.
//
// The beginning of the gesture is unknown. So windows of many lengths, all of which end where the hand came
// to rest, are given to a recogniser to which the pace of the hand counts: a gesture is slow at its ends
// and corners, and a way across the desk is not. The window with the best score is taken as the gesture.
// Reading is spread over the gameplay ticks of the rest. All state kept between two ticks is in FreeHand.
#pragma once

#include "game/components/free_hand.h"
#include "game/data/reading.h"

namespace thaum::game::inline casting {

/// Adds the position of the hand in a gameplay tick (m), and counts how long the hand has rested.
void add_place(const CastingRules& rules, vec3 place, Tick tick, FreeHand& hand);

/// Forgets the motion so far.
void forget_motion(FreeHand& hand);

/// Reads the parts of the motion (windows) that are due in this gameplay tick. Returns true in the tick in
/// which the hand has rested for long enough: the best windows, FreeHand::best and FreeHand::odd, are then
/// final.
bool read_windows(const CastingRules& rules, const GestureSet& gestures, ReadingSpace& space, FreeHand& hand);

}  // namespace thaum::game::inline casting
