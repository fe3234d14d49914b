// game/bots/aim.h: how bots and practice dummies turn their view to the foe and decide when to shoot.
#pragma once
#include "game/bots/mind.h"
#include "game/context/aim.h"

namespace thaum::game::inline bots {

inline constexpr double rad_per_count = 0.001;  ///< angle by which one count of a bot's mouse turns the view
                                                ///< (rad)

/// Changes the random aiming error slowly. `seat.skill` gives its standard deviation.
void wander_aim(const Seat& seat, Mind& mind);

/// Position at which to shoot: the foe's expected position when the shot arrives. `lead` is the share of the
/// foe's motion that is taken into account.
vec3 aim_point(const Self& self, const Seat& seat, const Mind& mind, double lead);

/// Direction of view in which the next shot hits the target. A shot that flies on a parabola takes the lower
/// of the two possible directions.
Aim aim_of_shot(const Self& self, vec3 target);

/// Plans how many mouse counts the bot gives until its next gameplay tick, 8 ms later, to turn its view to
/// the aim. The skill's turning speed limits them. Writes the plan to `mind`.
void turn_towards(const Self& self, const Seat& seat, Aim aim, Mind& mind);

/// Decides about fire while the view is near `wanted` and the foe is in sight and near enough. A rapid wand
/// fires in bursts. For a wand that must be charged or drawn, the bot holds fire until the wand is ready and
/// the view has reached its aim. Shots on a parabola may also go over what hides the foe.
void choose_fire(const Self& self, const Seat& seat, Aim wanted, Mind& mind, Tick tick);

/// Gives this tick's part of the planned turn to the sample. `ticks_left` ticks remain until the next
/// gameplay tick.
void turn_hand(Mind& mind, Tick ticks_left, input::DeviceSample& sample);

}  // namespace thaum::game::inline bots
