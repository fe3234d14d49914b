// game/match/touch.h: what a wizard's hand feels, and where it is: the servo step and the simulated device, each tick.
#pragma once
#include "game/components/grip.h"
#include "game/match/stage.h"

namespace thaum::game {

/// A device at rest.
Grip empty_grip();

/// What the player feels who holds it so.
const haptics::HapticModel& next_model(Stage& stage, ecs::Entity wizard, Grip& grip, bool panic);

/// Every tick: the hand's target, the servo step, the device.
void add_touch_system(Stage& stage, ecs::Schedule& schedule);

/// A kick against the hand, half a sine wave: `newtons` at the peak for a device that gives 3.3 N and a player who wants
/// all of it, in proportion for any other (game.md). Towards the user, or where it points in the device frame. Writes Grip.
void kick(Stage& stage, ecs::Entity wizard, double newtons, Tick length);
void kick(Stage& stage, ecs::Entity wizard, vec3 newtons, Tick length);

/// A steady force on the hand, device frame, in the same measure as a kick; it may change smoothly from call to call. Writes Grip.
void lean(Stage& stage, ecs::Entity wizard, vec3 newtons);

/// What the hand's tip hangs on; again each tick for one that moves. Writes Grip.
void tether(Stage& stage, ecs::Entity wizard, const haptics::Tether& to);

/// Nothing leans on the hand, nothing holds it or takes it along. Writes Grip.
void let_go(Stage& stage, ecs::Entity wizard);

/// Where the wand's tip is in the frame of the eye, m: it goes with the hand, and stays outside of what it touches.
vec3 wand_tip_of(double wand_per_hand, const Grip& grip);

/// Hash of the forces of this tick, chained to that of the ticks before.
std::uint64_t chained_force_hash(const ecs::World& world, std::uint64_t before);

}  // namespace thaum::game
