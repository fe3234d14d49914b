// game/match/arm.h: real arms in a match. Each tick takes one sample of each arm and makes the step that the arm's own thread made with
// it, by the model which that thread had then; so the forces of match, replay and arm are the same to the bit.
#pragma once
#include <vector>

#include "game/components/arm.h"
#include "game/match/simulation.h"

namespace thaum::game {

/// How it is with the real arm of a player. While it is gone the simulated hand plays on, by mouse or pad; back, it is felt
/// once it was held still.
enum class ArmCondition : std::uint8_t { none, felt, clutched, gone, back };
ArmCondition arm_condition(const ecs::World& world, std::uint32_t player);

/// How the player's stylus is turned, device frame: axis times angle, rad; zero where no real arm is in the hand. It turns the
/// wand about its tip, and that is all: who aims, aims by the view.
vec3 stylus_turn(const ecs::World& world, std::uint32_t player);

/// Whether the player's hand is a real arm now.
bool plays_by_arm(const ecs::World& world, std::uint32_t player);

/// All arms, before the scene is cleared.
std::vector<Arm> arms_in(const ecs::World& world);
/// One for each player with such a device; what was known of it goes on.
void add_arms(Stage& stage, const std::vector<Arm>& before);
/// Into a world that has them, from another match that it carries on.
void carry_arms(const std::vector<Arm>& before, ecs::World& world);

/// Every tick, in a pause too: the sample and its step. Writes Grip.
void add_arm_system(Stage& stage, ecs::Schedule& schedule);
/// What arms feel next; the last of a tick. Nothing unless the match is live.
void publish_models(Stage& stage, bool live);

/// Somebody's panic key, or a player's wish for forces after one, reaches the arms.
void tell_arms(ecs::World& world, bool panic);

/// What the player's arm is to be told after the last tick; false where there is none.
bool fill_order(const Simulation& match, std::uint32_t player, input::ArmOrder& order);

}  // namespace thaum::game
