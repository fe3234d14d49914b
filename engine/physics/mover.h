// physics/mover.h: how a wizard walks, jumps and stands, as impulses on an upright capsule without friction.
//
// Each step one short sweep of a sphere, a little thinner than the capsule, finds the ground. On ground that is not too steep the
// capsule's velocity in the ground's plane is driven to the wished one, with gravity along the plane held off; in the air the
// wish steers weakly. The drive is limited twice: in acceleration while the way is free, and in force once something
// resists, so that a heavy prop is hard to push. "Resists" is what the last drive should have given and did not.
//
// Bullet stays the only one who moves the capsule: walls, props, blasts and couplings act on it as on any body.
#pragma once
#include "physics/physics.h"

namespace thaum::physics {

/// A person of 1.8 m and 75 kg.
inline constexpr BodyDesc mover_body{
    .shape = Shape::capsule, .size = {0.35, 0.55, 0}, .mass = 75, .friction = 0, .upright = 1};

struct MoverInput {
    vec3 wish_velocity{};  ///< m/s; its y is ignored; cut to MoverSettings::walk_speed
    bool jump{};           ///< jumps whenever it stands; the caller makes one press one jump
    double
        rope_lift{};  ///< N, upward, by something else (a rope): so much less grip on the ground; its weight and more: none
};

struct MoverSettings {
    double walk_speed{4.5};           ///< m/s, along the ground
    double ground_acceleration{40};   ///< m/s^2
    double air_acceleration{4};       ///< m/s^2
    double push_force{700};           ///< N, against what resists
    double adhesion{60};              ///< m/s^2; keeps the feet on the ground over a crest
    double jump_speed{4.6454278597};  ///< m/s: sqrt(2 * 9.81 * 1.1), an apex of 1.1 m
    double steepest_cos{0.64278761};  ///< cosine of the steepest slope it can stand on: 50 degrees
    double reach{0.03};               ///< m below the capsule in which ground counts as ground
    Layers ground{all_layers};        ///< what can be stood on
};

/// What a mover must remember from step to step; the caller stores it with the body's state.
struct MoverState {
    vec3 expected{};  ///< m/s, along and against the ground, after the last drive if nothing resists
    vec3 ground_normal{0, 1, 0};  ///< of the last ground
    double falling{};             ///< m/s downward, while in the air
    std::uint32_t grounded{};     ///< 1: stood on the ground
    std::uint32_t driven{};       ///< 1: expected holds
};
static_assert(std::is_trivially_copyable_v<MoverState>);
static_assert(sizeof(MoverState) == 7 * sizeof(double) + 2 * sizeof(std::uint32_t));

struct MoverResult {
    bool grounded{};
    bool jumped{};
    vec3 ground_normal{0, 1, 0};  ///< unit; up while in the air
    Key ground{no_key};           ///< the body it stands on
    double landing_speed{};       ///< m/s, against the ground, in the step in which it lands; else 0
};

/// Once before each Physics::step(dt). An idle mover on resting ground falls asleep like any body and then costs nothing;
/// a wish or a jump wakes it.
MoverResult move(Physics&, Key, const MoverInput&, const MoverSettings&, MoverState&, double dt);

}  // namespace thaum::physics
