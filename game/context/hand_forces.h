// game/context/hand_forces.h: forces that the game sets on a wizard's hand, and the position of the wand's
// tip. The servo step of game/match/hand/hand_system.h applies the forces.
#pragma once
#include "game/components/hand_state.h"
#include "game/context/match_context.h"

namespace thaum::game::inline context {

/// State of a hand at the beginning of a match, with the device at rest.
HandState empty_hand_state();

/// Kicks the hand with half a sine wave, as for the recoil of a shot. `newtons` (device frame) is the peak
/// for a device with a peak force of 3.3 N and a player who chose full force. For others it scales in
/// proportion. Writes HandState.
void kick(MatchContext& context, ecs::Entity wizard, vec3 newtons, Tick length);

/// Kicks the hand towards the user. `share` is the peak as a share of the largest force that the player
/// chose.
void kick_at_peak(MatchContext& context, ecs::Entity wizard, double share, Tick length);

/// Kicks the hand of a wizard's player for a shot of that wizard's own wand. The player's setting for the
/// strength of recoil scales the kick.
void recoil(MatchContext& context, ecs::Entity wizard, double newtons, Tick length);

/// Sets a steady force on the hand (N, device frame), scaled like a kick. The force may vary smoothly over
/// successive calls. Writes HandState.
void set_steady_force(MatchContext& context, ecs::Entity wizard, vec3 newtons);

/// Ties the hand to a point by a spring. A caller whose point moves must call this in every tick. Writes
/// HandState.
void tether(MatchContext& context, ecs::Entity wizard, const haptics::Tether& to);

/// Removes what a wand has set on the hand: the steady force, the tether (a spring to a point) and the
/// displacement. Writes HandState.
void let_go(MatchContext& context, ecs::Entity wizard);

/// Position of the wand's tip (m, eye frame: origin at the wizard's eye, turned with the view). The tip
/// follows the hand, but does not enter surfaces that it touches.
vec3 wand_tip_of(double wand_per_hand, const HandState& hand_state);

}  // namespace thaum::game::inline context
