// game/match/hand/arm_system.h: real arms in a match. Each tick takes one sample of each arm and repeats the servo step
// that the arm's own thread made with that sample. The step uses the haptic model which that thread had at
// the time. So the forces of match, replay and arm are equal bit for bit.
#pragma once
#include <vector>

#include "game/components/arm.h"
#include "game/stations/cauldron/cauldron.h"
#include "input/arm_servo.h"

namespace thaum::game {

/// Returns all arms; called before the scene is cleared.
std::vector<Arm> arms_in(const ecs::World& world);
/// Creates an arm for each player who has such a device. State of the same device in `before` is kept.
void add_arms(MatchContext& context, const std::vector<Arm>& before);
/// Copies the state of arms from a match into the world of the match that continues it.
void carry_arms(const std::vector<Arm>& before, ecs::World& world);

/// Adds the system that takes each arm's sample and repeats its servo step, every tick and also in a pause.
/// Writes HandState.
void add_arm_system(MatchContext& context, ecs::Schedule& schedule);
/// Creates the haptic models that arms use next. It must be the last call of a tick. Forces are off unless
/// the match is live.
void publish_models(MatchContext& context, const BrewResource& brew, bool live);

/// Restores the models of the arms from the World, after it was restored: parts that did not change are not written
/// again (resource::Models), and the World holds the bytes of past models.
void recall_models(MatchContext& context);

/// Passes a player's panic press, or a press that switches forces on again, to the arms.
void tell_arms(ecs::World& world, bool panic);

/// Fills the order for the player's arm after the last tick. Returns false if the player has no arm or no
/// model was made yet.
bool fill_order(const ecs::World& world, const HapticSetup& setup, std::uint32_t player,
                input::ArmOrder& order);

}  // namespace thaum::game
