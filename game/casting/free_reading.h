// game/casting/free_reading.h: reads the motion of a hand that casts without a button, once the hand rests.
//
// Nobody tells where the gesture begins. So windows of many lengths, all of which end where the hand came to rest, are
// read by the recogniser that also reads strokes with Trace held. The best of them is what was drawn. The windows are
// spread over the gameplay ticks of the rest. All that is kept between two ticks is in FreeHand.
#pragma once

#include "game/components/free_hand.h"
#include "game/data/reading.h"

namespace thaum::game {

/// Adds the place of the hand in a gameplay tick (m), and counts how long it has rested.
void add_place(const CastingRules& rules, vec3 place, Tick tick, FreeHand& hand);

/// Forgets the motion so far.
void forget_motion(FreeHand& hand);

/// Reads the windows of this gameplay tick. Returns true if the hand has rested for so long that `best` and `odd`
/// are what it drew.
bool read_windows(const CastingRules& rules, const GestureSet& gestures, ReadingSpace& space, FreeHand& hand);

}  // namespace thaum::game
