// game/bots/aim.h: how whatever plays by itself turns its eye on the foe and decides to shoot. Bots and dummies share it.
#pragma once
#include "game/bots/mind.h"

namespace thaum::game {

inline constexpr double rad_per_count = 0.001;  ///< of a bot's mouse

struct Aim {
    double yaw{}, pitch{};  ///< rad
};

Aim aim_at(vec3 eye, vec3 target);

/// rad, the shorter way round.
double angle_between(double from, double to);

/// The aim wanders slowly, with the skill's standard deviation.
void wander_aim(const Seat& seat, Mind& mind);

/// Where the foe will be when the shot is there, as far as `lead` of the foe's motion is allowed for.
vec3 aim_point(const Self& self, const Seat& seat, const Mind& mind, double lead);

/// So that the next shot comes down there; what flies in an arc takes the lower of its two ways.
Aim aim_of_shot(const Self& self, vec3 target);

/// Counts for the ticks until the next look, into the mind; at most what the wrist can do.
void turn_towards(const Self& self, const Seat& seat, Aim aim, Mind& mind);

/// Bursts of fire at a foe who is in sight and near enough, while the eye is `wanted` or close to it; what is readied first is held
/// until it is ready and the eye is there. What flies in an arc may go over what hides the foe.
void choose_fire(const Self& self, const Seat& seat, Aim wanted, Mind& mind, Tick tick);

/// The part of the planned turn that belongs to this tick, of `ticks_left` until the next look.
void turn_hand(Mind& mind, Tick ticks_left, input::DeviceSample& sample);

}  // namespace thaum::game
