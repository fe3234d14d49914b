// game/match/haptic_setup.h: the haptic setup of a match (game/context/match_context.h) from its data and devices, and
// its changes by faders that players move during the match.
#pragma once
#include <string>

#include "game/components/moved_faders.h"
#include "game/context/match_context.h"

namespace thaum::game {

/// Setup at the beginning of a match.
HapticSetup haptic_setup_of(const MatchData& data, const std::vector<input::DeviceSpec>& devices);

/// Takes the faders that were moved in this tick into the World and into the setup. Only devices whose settings say so
/// move faders. Each move is a switch of the hand's forces, so none jumps.
void move_faders(const MatchData& data, const std::vector<input::DeviceSpec>& devices,
                 const input::InputFrame& frame, ecs::World& world, HapticSetup& setup);

/// Names of all faders, input::HandFader `n` at n - 1: "force", "weight", ..., "brew viscosity", ...
const std::vector<std::string>& fader_names();

/// The World's record of moved faders, which a new round takes over; std::nullopt: none was moved.
std::optional<MovedFaders> moved_faders_in(const ecs::World& world);

/// Applies all faders that the World says were moved, after it was restored.
void apply_moved_faders(const MatchData& data, const ecs::World& world, HapticSetup& setup);

}  // namespace thaum::game
