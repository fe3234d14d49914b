// game/context/arms.h: which player holds a real arm (a force-feedback device with a stylus), and the arm's
// condition.
#pragma once
#include "ecs/world.h"
#include "game/components/arm.h"

namespace thaum::game::inline context {

/// Condition of a player's real arm, a force-feedback device. none: the player has no arm. felt: the arm
/// moves the hand, which feels forces. clutched: the hand rests while the arm moves freely. gone: no samples
/// come from the arm, so mouse or gamepad move a simulated hand. back: samples come again, but the arm gives
/// forces only after it was held still.
enum class ArmCondition : std::uint8_t { none, felt, clutched, gone, back };
ArmCondition arm_condition(const ecs::World& world, std::uint32_t player);

/// Rotation of the player's stylus as axis times angle (rad, device frame); zero if the player holds no real
/// arm. It only turns the wand about the tip. Aiming uses the direction of view.
vec3 stylus_turn(const ecs::World& world, std::uint32_t player);

/// Whether a real arm (force-feedback device) moves the player's hand in this tick.
bool plays_by_arm(const ecs::World& world, std::uint32_t player);

/// The real arm (force-feedback device) of a player; null if there is none.
const Arm* arm_of(const ecs::World& world, std::uint32_t player);
/// Whether a real arm (force-feedback device) has sent no sample for so long that the simulated hand has
/// taken over.
bool is_gone(const Arm& arm);

}  // namespace thaum::game::inline context
