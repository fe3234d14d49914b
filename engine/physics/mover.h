// physics/mover.h: walking, jumping and standing of a wizard, by impulses on an upright capsule without
// friction.
//
// In each step a short sweep of a sphere, slightly thinner than the capsule, finds the ground. If the ground
// is not too steep, the capsule's velocity in the plane of the ground is driven towards the velocity that the
// player wishes. Gravity along that plane is cancelled. In the air the wished velocity steers only weakly.
// Two limits apply to the drive: an acceleration while nothing is in the way, and a force when something
// resists, so that a heavy prop is hard to push. Resistance is detected if the last drive changed the
// velocity by less than expected.
//
// Bullet alone moves the capsule, so walls, props, blasts and couplings act on it as on any body.
#pragma once
#include "physics/physics.h"

namespace thaum::physics {

/// The body of a mover, a walking person of 1.8 m and 75 kg.
inline constexpr BodyDesc mover_body{
    .shape = Shape::capsule, .size = {0.35, 0.55, 0}, .mass = 75, .friction = 0, .upright = 1};

/// What a mover (a walking person) is to do in one step.
struct MoverInput {
    vec3 wish_velocity{};  ///< wished velocity; y is ignored, speed is limited to walk_speed (m/s)
    /// True: jump whenever the mover stands on the ground; the caller sets this in one step for each press.
    bool jump{};
    /// Upward force by a rope or the like (N). It reduces the traction on the ground, to none when it equals
    /// the weight.
    double rope_lift{};
};

/// Abilities of a mover; the defaults are those of a walking person.
struct MoverSettings {
    double walk_speed{4.5};          ///< speed along the ground (m/s)
    double ground_acceleration{40};  ///< largest acceleration on the ground (m/s^2)
    double air_acceleration{4};      ///< largest acceleration in the air (m/s^2)
    double push_force{700};          ///< largest force with which the mover pushes against a resistance (N)
    double adhesion{60};  ///< acceleration towards the ground that keeps the feet down over a crest (m/s^2)
    /// Upward speed of a jump: sqrt(2 * 9.81 * 1.1), for an apex of 1.1 m (m/s).
    double jump_speed{4.6454278597};
    double steepest_cos{0.64278761};  ///< cosine of the steepest slope on which a mover can stand: 50 degrees
    double reach{0.03};               ///< distance below the capsule within which ground is found (m)
    Layers ground{all_layers};        ///< layers of bodies that can be stood on
};

/// State of a mover (a walking person) between steps; the caller stores it with the body's state.
struct MoverState {
    /// Velocity relative to the ground to which the mover was last driven, if nothing resisted (m/s).
    vec3 expected{};
    vec3 ground_normal{0, 1, 0};  ///< normal of the ground on which the mover stood last
    double falling{};             ///< downward speed while in the air (m/s)
    std::uint32_t grounded{};     ///< 1: the mover stood on the ground in the last step
    std::uint32_t driven{};       ///< 1: `expected` is valid, because the last step drove the mover
};
static_assert(std::is_trivially_copyable_v<MoverState>);
static_assert(sizeof(MoverState) == 7 * sizeof(double) + 2 * sizeof(std::uint32_t));

/// Result of one step of a mover (a walking person).
struct MoverResult {
    bool grounded{};
    bool jumped{};
    vec3 ground_normal{0, 1, 0};  ///< normal of the ground (unit); (0, 1, 0) while in the air
    Key ground{no_key};           ///< key of the body on which the mover stands
    double landing_speed{};       ///< speed against the ground in the step in which it lands, else 0 (m/s)
};

/// Moves a wizard; call it once before each Physics::step(dt). Without a wished velocity, a mover on resting
/// ground falls asleep like any body and then costs nothing. A wished velocity or a jump wakes it.
MoverResult move(Physics&, Key, const MoverInput&, const MoverSettings&, MoverState&, double dt);

}  // namespace thaum::physics
