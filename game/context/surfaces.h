// game/context/surfaces.h: collects the surfaces near a hand from the physics and transforms them to the
// device frame.
#pragma once
#include "haptics/servo.h"
#include "physics/physics.h"

namespace thaum::game::inline context {

/// Pose and scale of the device frame in the world: world position = origin + turn * (scale * device
/// position).
struct HandFrame {
    vec3 origin{};               ///< origin of the device frame (m, world)
    quat turn{1, 0, 0, 0};       ///< rotation from device frame to world (unit)
    double metres_per_metre{1};  ///< world distance per distance of the device, > 0 (m/m)

    vec3 to_device(vec3 world) const { return way_to_device(world - origin); }
    /// Transforms a displacement from the world to the device frame; also a velocity, if the device frame
    /// does not move.
    vec3 way_to_device(vec3 way) const { return glm::conjugate(turn) * way / metres_per_metre; }
    vec3 to_world(vec3 device) const { return origin + turn * (metres_per_metre * device); }
    bool operator==(const HandFrame&) const = default;
};

/// How the surfaces of bodies feel at the hand. Friction is the body's own friction times these factors.
struct Feel {
    double stiffness{300};      ///< stiffness of the surfaces, as felt at the device (N/m)
    double damping{};           ///< damping of the surfaces, as felt at the device (N s/m)
    double static_friction{};   ///< static friction as a multiple of BodyDesc::friction
    double dynamic_friction{};  ///< dynamic friction as a multiple of BodyDesc::friction
};

/// The sphere in which surfaces are collected.
struct Around {
    vec3 point{};     ///< centre of the sphere (m, world)
    double radius{};  ///< radius of the sphere (m, world)
    physics::Layers mask{physics::all_layers};
    physics::Key ignore{physics::no_key};
};

/// Empties a patch, the surfaces near a hand. Its entries beyond the counts must already be clear. Unused
/// entries get fixed bytes, so that a match restored from a saved state publishes the same haptic models.
void clear_patch(haptics::SurfacePatch& patch);

/// Writes the nearest surfaces around a point into the patch (the surfaces near a hand), as many as fit.
/// `before` is the device frame one tick earlier. Velocities of bodies are relative to the moving frame.
/// Allocates nothing.
void fill_patch(haptics::SurfacePatch& patch, const physics::Physics& physics, const Around& around,
                const HandFrame& frame, const HandFrame& before, const Feel& feel);

/// Motion of the resting world as seen from the device frame, which moves with the wizard.
haptics::FrameMotion frame_motion_of(const HandFrame& frame, const HandFrame& before);

}  // namespace thaum::game::inline context
