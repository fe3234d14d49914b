// game/stations/orb/worn_modes.h: the haptic modes that a wizard has switched on at the orb ("worn" modes),
// and the curves of their strength.
#pragma once
#include "game/components/hand_state.h"
#include "game/components/orb.h"
#include "game/context/match_context.h"

namespace thaum::game::inline stations {

/// Whether a haptic mode (a way in which the flow is felt) is switched on.
bool wears(const WornModes& modes, std::uint32_t mode);

/// Switches a haptic mode on, or off if it is on. If there are too many, the new one replaces the oldest.
/// Returns whether the mode is on now.
bool put_on_or_off(WornModes& modes, std::uint32_t mode);

/// The haptic mode that was switched on last; no_mode: none is on.
std::uint32_t last_worn(const WornModes& modes);

/// The mode that replaces the newest one when the player asks for the next (step 1) or the previous one (step
/// -1). `count`: number of all modes. It is a mode that is off; no_mode if every mode is on.
std::uint32_t neighbour_of_last(const WornModes& modes, std::size_t count, int step);

/// Point on the plane on which a wizard draws a mode's curve. Its coordinates are the value of the flow's
/// property that the mode reads, and the strength of the mode's force (N). `hand`: position of the tip;
/// `reach`: half of the workspace (m, device frame).
vec2 on_sheet(const OrbRules& rules, const OrbMode& mode, vec3 hand, vec3 reach);

/// Draws the part of a strength curve that lies between two points of the plane on which a wizard draws it.
void draw_curve(const OrbRules& rules, const OrbMode& mode, vec2 from, vec2 to,
                field::TransferFunction& strength);

/// Adapts modes to edited rules: a curve that the wizard has not drawn becomes that of the new rules. If the
/// list of modes has changed, all modes start anew.
void refit_modes(const OrbRules& before, const OrbRules& current, WornModes& modes);

/// Fills in the haptic primitives (simple forces) of a hand that scries, for one tick of play. They belong to
/// the active modes at the place that the proxy (the hand's point in the orb) had in the last tick. The
/// wizard must scry. A hand that draws a curve gets none. Reads Scrying, AtStation, WornModes and Orb.
void feel_orb(const MatchContext& context, ecs::Entity wizard, const HandState& hand_state,
              haptics::HapticModel& model);

}  // namespace thaum::game::inline stations
