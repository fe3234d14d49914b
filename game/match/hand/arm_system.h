// game/match/hand/arm_system.h: real arms in a match. In each tick the match takes one sample of each arm and
// repeats the servo step, the computation of a force, that the arm's own thread made with that sample and the
// same haptic model. So the forces of match, replay and arm are equal bit for bit.
#pragma once
#include <vector>

#include "game/components/arm.h"
#include "game/stations/cauldron/cauldron.h"
#include "input/arm_servo.h"

namespace thaum::game::inline match {

/// Returns a copy of all arms, to be taken before the scene is cleared.
std::vector<Arm> arms_in(const ecs::World& world);
/// Creates an Arm for each player who has an arm among the devices. If `before` has the same device, its
/// state is kept.
void add_arms(MatchContext& context, const std::vector<Arm>& before);
/// Copies the state of arms from a match into the world of the match that continues it.
void carry_arms(const std::vector<Arm>& before, ecs::World& world);

/// Adds the system that takes each arm's sample and repeats its servo step (the computation of the arm's
/// force). It runs every tick, also in a pause. Writes HandState.
void add_arm_system(MatchContext& context, ecs::Schedule& schedule);
/// Creates the haptic models, from which the arms' threads compute forces in the next ticks. Must be called
/// last in a tick. `live`: false switches the forces off, as in a pause.
void publish_models(MatchContext& context, const BrewResource& brew, bool live);

/// Restores the arms' models from the bytes in the World, after the World was restored. This is necessary
/// because unchanged parts of a model are not written again (resource::Models).
void recall_models(MatchContext& context);

/// Passes a player's panic press to the arms, or the press that switches forces on again.
void tell_arms(ecs::World& world, bool panic);

/// Fills in what the thread of the player's arm needs after the last tick (input::ArmOrder). Returns false if
/// the player has no arm or no model exists yet.
bool fill_order(const ecs::World& world, const HapticSetup& setup, std::uint32_t player,
                input::ArmOrder& order);

}  // namespace thaum::game::inline match
