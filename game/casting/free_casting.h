// game/casting/free_casting.h: casting without a button, for players who chose it (DeviceSpec::casts_freely).
//
//     each tick          -> counts of mouse and stick, which also turn the view, move the place of a hand
//     each gameplay tick -> that place, or that of an arm's hand, goes into the ring of FreeHand
//     the hand rests     -> what it drew just before is read (casting/free_reading.h) and casts its spell, as a stroke does
//
// A hand that shoots, stirs, traces or moves by the clutch casts nothing this way. Nor does a hand that goes on after the
// gesture, as in aiming, or as in a star, of which a part is a V. Two spells are a while apart. What was almost a gesture
// is kept in NearMiss, for the picture.
#pragma once
#include "ecs/schedule.h"
#include "game/components/free_hand.h"
#include "game/context/match_context.h"

namespace thaum::game {

/// Whether a player's device lets the player cast without a button.
bool casts_freely(const MatchContext& context, std::uint32_t player);

/// Adds the systems. Does nothing if no player casts freely.
void add_free_casting_systems(MatchContext& context, ecs::Schedule& schedule);

}  // namespace thaum::game
