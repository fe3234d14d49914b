// game/match/hand/hand_system.h: forces on a wizard's hand, and the hand's position: the servo step (the
// computation of the force) and the simulated device, every tick.
#pragma once
#include "game/components/hand_state.h"
#include "game/stations/cauldron/cauldron.h"

namespace thaum::game::inline match {

/// Fills and returns the haptic model of this tick, from which the servo computes the force on the wizard's
/// hand.
const haptics::HapticModel& next_model(MatchContext& context, const BrewResource& brew, ecs::Entity wizard,
                                       HandState& hand_state, bool panic);

/// Adds the system that moves the hand every tick: it sets the hand's target, computes the force on the hand
/// (the servo step) and moves the simulated device.
void add_hand_system(MatchContext& context, const BrewResource& brew, ecs::Schedule& schedule);

/// Hash of the forces of this tick, chained to the hash of the ticks before.
std::uint64_t chained_force_hash(const ecs::World& world, std::uint64_t before);

}  // namespace thaum::game::inline match
