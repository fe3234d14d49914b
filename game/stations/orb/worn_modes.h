// game/stations/orb/worn_modes.h: the haptic modes that a wizard wears at the orb, and the curves of their strength.
#pragma once
#include "game/components/hand_state.h"
#include "game/components/orb.h"
#include "game/context/match_context.h"

namespace thaum::game {

/// Whether a wizard wears a mode.
bool wears(const WornModes& modes, std::uint32_t mode);

/// Puts a mode on, or takes it off if it is worn. One too many takes the place of the oldest. Returns true if it is worn
/// now.
bool put_on_or_off(WornModes& modes, std::uint32_t mode);

/// The mode that was put on last; no_mode: none is worn.
std::uint32_t last_worn(const WornModes& modes);

/// The mode that takes the place of the last worn one when the player asks for the next (step 1) or the one before (step
/// -1), out of `count`. It is not worn yet. no_mode: every mode is worn.
std::uint32_t neighbour_of_last(const WornModes& modes, std::size_t count, int step);

/// Place on the sheet on which a wizard draws a mode's curve: the property, and the strength (N). `hand` is the tip's
/// position and `reach` half of the workspace (m, device frame).
vec2 on_sheet(const OrbRules& rules, const OrbMode& mode, vec3 hand, vec3 reach);

/// Draws a curve's columns between two places of the sheet.
void draw_curve(const OrbRules& rules, const OrbMode& mode, vec2 from, vec2 to,
                field::TransferFunction& strength);

/// Goes on with edited rules: a curve that the wizard has not drawn becomes that of the new rules. Other modes than before
/// begin anew.
void refit_modes(const OrbRules& before, const OrbRules& now, WornModes& modes);

/// Prepares the primitives of a scrying hand's model, for one tick of play: the worn modes at the proxy of the last tick.
/// The wizard must scry. A hand that draws a curve has none. Reads Scrying, AtStation, WornModes and Orb.
void feel_orb(const MatchContext& context, ecs::Entity wizard, const HandState& hand_state,
              haptics::HapticModel& model);

}  // namespace thaum::game
