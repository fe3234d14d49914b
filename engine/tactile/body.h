// tactile/body.h: the articulated body on which effects are felt, and its skin as flat charts.
//
// Body frame: +x right, +y up, +z front, origin on the floor between the feet. This is the frame of jacket
// makers and of MPEG haptics. It is left-handed; `to_body_frame` converts a direction of the world. Places
// are stated for a body at rest: upright, arms down. A Pose moves the parts from there.
//
// The torso is an upright elliptic cylinder. Its skin is unrolled into a chart: the way round
// the body from the middle of the front, positive to the right, and the height. Distances on
// the chart are distances on the skin.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/maths.h"

namespace thaum::tactile {

/// Part of the body. `whole` is the body as a whole, for actuators such as the motors of a pad, of which only
/// left and right are told apart.
enum class Part : std::uint8_t { front, back, shoulder_left, shoulder_right, arm_left, arm_right, whole };
inline constexpr std::size_t part_count = 7;

/// Names of the parts of the body as in data files, in the order of Part.
const std::vector<std::string_view>& part_names();

/// Regions of the body. Each has one chart (flat map of its skin) for all of its parts: the torso has the
/// front and the back.
enum class Region : std::uint8_t { torso, shoulder_left, shoulder_right, arm_left, arm_right, whole };
inline constexpr std::size_t region_count = 6;

/// Region to which a part belongs.
Region region_of(Part part);

/// One place on the skin.
struct BodyPoint {
    Part part{};
    vec3 at{};  ///< position of the point on the body at rest (m, body frame)
};

/// Motion of one part from its rest position: first a rotation about the origin, then a translation.
struct Transform {
    quat turn{1, 0, 0, 0};
    vec3 shift{};  ///< translation (m, body frame)
};

/// Pose of a body: the motion of each part from its rest position.
struct Pose {
    std::array<Transform, part_count> parts{};
};

/// Makes the transform of a rotation about a joint. It needs a translation, since a Transform rotates about
/// the origin.
Transform turned_about(vec3 joint, quat turn);

/// Pose of a wizard whose hanging arms are raised forwards by these angles (rad). Each shoulder turns by half
/// the angle.
Pose pose_with_arms(double left, double right);

/// Position of a point of one part in a pose (m, body frame).
vec3 posed(const Pose& pose, Part part, vec3 at_rest);
/// Position on the body at rest of a point of one part in a pose: the inverse of `posed` (m, body frame).
vec3 at_rest(const Pose& pose, Part part, vec3 posed);

/// Converts a direction of the world (right-handed, +y up) for a wizard turned left
/// by `yaw` (rad; 0 looks along -z).
vec3 to_body_frame(vec3 world, double yaw);

/// The skin of the torso as a chart, a flat map on which distances are those along the skin.
class Torso {
public:
    Torso() : Torso(0.16, 0.115) {}
    /// Half the width and half the depth of the torso, both > 0 (m).
    Torso(double half_width, double half_depth);

    /// Place on the chart (distance round the body, height) of the skin point that lies in the direction of
    /// `at` from the torso's axis (m).
    vec2 chart(vec3 at) const;
    /// Point of the skin at a place on the chart, as `chart` gives it (m, body frame).
    vec3 point(vec2 chart) const;
    /// Point of the skin that faces a direction, at a height (m). A direction without a horizontal
    /// part gives the middle of the front.
    vec3 facing(vec3 direction, double height) const;
    /// Length of the way once round the body (m).
    double round() const { return 4 * quarter_.back(); }

private:
    double half_width_{};
    double half_depth_{};
    /// Distance along the skin from the middle of the front, at equal steps of the ellipse's angle, up to a
    /// quarter turn (m).
    std::array<double, 33> quarter_{};
};

}  // namespace thaum::tactile
