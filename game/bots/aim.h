// game/bots/aim.h: how bots and dummies turn their view to the foe and decide when to shoot.
#pragma once
#include "game/bots/mind.h"
#include "game/context/aim.h"

namespace thaum::game::inline bots {

inline constexpr double rad_per_count = 0.001;  ///< rotation per count of a bot's mouse

/// Changes the random aiming error slowly. Its standard deviation is given by the skill.
void wander_aim(const Seat& seat, Mind& mind);

/// Position at which to shoot: the foe's expected position when the shot arrives. `lead` is the share of the
/// foe's motion that is taken into account.
vec3 aim_point(const Self& self, const Seat& seat, const Mind& mind, double lead);

/// Aim with which the next shot hits the target. A shot on a parabola takes the lower of the two possible
/// directions.
Aim aim_of_shot(const Self& self, vec3 target);

/// Plans the mouse counts until the next gameplay tick in `mind`, limited by the skill's turning speed.
void turn_towards(const Self& self, const Seat& seat, Aim aim, Mind& mind);

/// Decides about fire while the eye is near `wanted` and the foe is in sight and near enough. A rapid wand
/// fires in bursts. A wand that is readied first keeps fire held until the wand is ready and the eye has
/// reached its aim. Shots on a parabola may go over what hides the foe.
void choose_fire(const Self& self, const Seat& seat, Aim wanted, Mind& mind, Tick tick);

/// Takes the part of the planned turn for this tick. `ticks_left` ticks remain until the next gameplay tick.
void turn_hand(Mind& mind, Tick ticks_left, input::DeviceSample& sample);

}  // namespace thaum::game::inline bots
