#include "tactile/body.h"

#include <algorithm>

#include "core/assert.h"

namespace thaum::tactile {
namespace {

/// Joints of the shoulders of a wizard of 1.8 m (m, body frame).
constexpr vec3 left_joint{-0.19, 1.38, 0}, right_joint{0.19, 1.38, 0};

/// Rotation that raises a hanging arm to the front. In this frame, a positive angle about x takes -y to -z.
quat raised(double angle) { return rotation({1, 0, 0}, -angle); }

}  // namespace

const std::vector<std::string_view>& part_names() {
    static const std::vector<std::string_view> names{
        "front", "back", "shoulder_left", "shoulder_right", "arm_left", "arm_right", "whole"};
    return names;
}

Region region_of(Part part) {
    switch (part) {
        case Part::front:
        case Part::back: return Region::torso;
        case Part::shoulder_left: return Region::shoulder_left;
        case Part::shoulder_right: return Region::shoulder_right;
        case Part::arm_left: return Region::arm_left;
        case Part::arm_right: return Region::arm_right;
        case Part::whole: break;
    }
    return Region::whole;
}

Transform turned_about(vec3 joint, quat turn) { return {turn, joint - turn * joint}; }

Pose pose_with_arms(double left, double right) {
    Pose pose;
    const auto set = [&pose](Part part, vec3 joint, double angle) {
        pose.parts[static_cast<std::size_t>(part)] = turned_about(joint, raised(angle));
    };
    set(Part::arm_left, left_joint, left);
    set(Part::arm_right, right_joint, right);
    set(Part::shoulder_left, left_joint, left / 2);
    set(Part::shoulder_right, right_joint, right / 2);
    return pose;
}

vec3 posed(const Pose& pose, Part part, vec3 at_rest) {
    const auto& t = pose.parts[static_cast<std::size_t>(part)];
    return t.turn * at_rest + t.shift;
}

vec3 at_rest(const Pose& pose, Part part, vec3 posed) {
    const auto& t = pose.parts[static_cast<std::size_t>(part)];
    return glm::conjugate(t.turn) * (posed - t.shift);
}

vec3 to_body_frame(vec3 world, double yaw) {
    const vec3 local = rotation({0, 1, 0}, -yaw) * world;
    return {local.x, local.y, -local.z};
}

Torso::Torso(double half_width, double half_depth) : half_width_(half_width), half_depth_(half_depth) {
    THAUM_ASSERT(half_width > 0 && half_depth > 0, "a torso needs a width and a depth");
    const double step = pi / 2 / static_cast<double>(quarter_.size() - 1);
    const auto speed = [&](double angle) {
        const double across = half_width_ * det::cos(angle), deep = half_depth_ * det::sin(angle);
        return std::sqrt(across * across + deep * deep);
    };
    // Adds the lengths of pieces of the torso's ellipse by Simpson's rule.
    for (std::size_t i = 1; i < quarter_.size(); ++i) {
        const double from = step * static_cast<double>(i - 1);
        quarter_[i] =
            quarter_[i - 1] + step / 6 * (speed(from) + 4 * speed(from + step / 2) + speed(from + step));
    }
}

vec2 Torso::chart(vec3 at) const {
    const double angle = det::atan2(at.x / half_width_, at.z / half_depth_);
    const double turn = std::abs(angle);
    const bool behind = turn > pi / 2;
    const double place = (behind ? pi - turn : turn) / (pi / 2) * static_cast<double>(quarter_.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(std::max(place, 0.0)), quarter_.size() - 2);
    const double part = quarter_[i] + (place - static_cast<double>(i)) * (quarter_[i + 1] - quarter_[i]);
    const double way = behind ? 2 * quarter_.back() - part : part;
    return {angle < 0 ? -way : way, at.y};
}

vec3 Torso::point(vec2 chart) const {
    const double whole = round();
    // Way round the body from the middle of the front, at most half way round to either side (m).
    const double way = chart.x - whole * std::floor(chart.x / whole + 0.5);
    const double on_front = std::abs(way);
    const bool behind = on_front > quarter_.back();
    const double part = behind ? 2 * quarter_.back() - on_front : on_front;
    const auto next = std::clamp<std::ptrdiff_t>(
        std::upper_bound(quarter_.begin(), quarter_.end(), part) - quarter_.begin(), 1,
        static_cast<std::ptrdiff_t>(quarter_.size()) - 1);
    const auto i = static_cast<std::size_t>(next - 1);
    const double place = static_cast<double>(i) + (part - quarter_[i]) / (quarter_[i + 1] - quarter_[i]);
    const double turn = place / static_cast<double>(quarter_.size() - 1) * pi / 2;
    const double x = half_width_ * det::sin(turn), z = half_depth_ * det::cos(turn);
    return {way < 0 ? -x : x, chart.y, behind ? -z : z};
}

vec3 Torso::facing(vec3 direction, double height) const {
    const double x = direction.x / half_width_, z = direction.z / half_depth_;
    const double length = std::sqrt(x * x + z * z);
    if (!(length > 0) || !std::isfinite(length)) return {0, height, half_depth_};
    return {direction.x / length, height, direction.z / length};
}

}  // namespace thaum::tactile
