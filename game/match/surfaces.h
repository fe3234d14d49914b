// game/match/surfaces.h: what lies near a hand, from the physics' world into the frame of the device that shall feel it.
#pragma once
#include "haptics/servo.h"
#include "physics/physics.h"

namespace thaum::game {

/// Where a device's frame lies in the world: place = origin + turn * (scale * device).
struct HandFrame {
    vec3 origin{};               ///< m, world
    quat turn{1, 0, 0, 0};       ///< unit
    double metres_per_metre{1};  ///< world per device, > 0

    vec3 to_device(vec3 world) const { return way_to_device(world - origin); }
    /// A way, or a velocity in a frame that rests.
    vec3 way_to_device(vec3 way) const { return glm::conjugate(turn) * way / metres_per_metre; }
    vec3 to_world(vec3 device) const { return origin + turn * (metres_per_metre * device); }
    bool operator==(const HandFrame&) const = default;
};

/// How bodies feel. Friction is the body's own times these.
struct Feel {
    double stiffness{300};      ///< N/m, at the device
    double damping{};           ///< N s/m, at the device
    double static_friction{};   ///< per unit of BodyDesc::friction
    double dynamic_friction{};  ///< likewise
};

struct Around {
    vec3 point{};     ///< m, world
    double radius{};  ///< m, world
    physics::Layers mask{physics::all_layers};
    physics::Key ignore{physics::no_key};
};

/// Writes the surfaces around a point into the patch: those that fit, the nearest. `before` is where the device's frame was a tick
/// ago: the bodies' velocities are those over the frame. Allocates nothing.
void fill_patch(haptics::SurfacePatch& patch, const physics::Physics& physics, const Around& around,
                const HandFrame& frame, const HandFrame& before, const Feel& feel);

/// Of what rests in the world, over the frame.
haptics::Drift drift_of(const HandFrame& frame, const HandFrame& before);

}  // namespace thaum::game
