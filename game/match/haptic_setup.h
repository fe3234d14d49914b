// game/match/haptic_setup.h: the haptic setup of a match (game/context/match_context.h) from its data and
// devices, and its changes by faders (for the strengths of forces) that players move during the match.
#pragma once
#include <string>

#include "game/components/moved_faders.h"
#include "game/context/match_context.h"

namespace thaum::game::inline match {

/// Haptic setup at the beginning of a match.
HapticSetup haptic_setup_of(const MatchData& data, const std::vector<input::DeviceSpec>& devices);

/// Applies the faders that were moved in this tick to the World and the setup. Samples of devices without
/// faders move none. After each move the hand's force fades to its new value and does not jump.
void move_faders(const MatchData& data, const std::vector<input::DeviceSpec>& devices,
                 const input::InputFrame& frame, ecs::World& world, HapticSetup& setup);

/// Names of all faders: "force", "weight", ..., "brew viscosity", ... The name of fader `n`
/// (input::HandFader) is at index n - 1.
const std::vector<std::string>& fader_names();

/// The World's record of moved faders, with which the next round goes on; std::nullopt: none was moved.
std::optional<MovedFaders> moved_faders_in(const ecs::World& world);

/// After a restore, applies all moved faders recorded in the World to the setup.
void apply_moved_faders(const MatchData& data, const ecs::World& world, HapticSetup& setup);

}  // namespace thaum::game::inline match
