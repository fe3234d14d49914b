#include "game/bots/aim.h"

#include <algorithm>
#include <cmath>

namespace thaum::game {
namespace {

constexpr double bolt_speed = 40;   ///< m/s; what bots take a bolt's speed to be
constexpr double near_share = 0.7;  ///< of the distance it likes: there it spares no energy

/// A number with mean 0 and standard deviation 1 (the sum of twelve uniform ones).
double normal(Random& random) {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += random.uniform();
    return sum;
}

double angle_between(double from, double to) {
    double d = std::fmod(to - from, 2 * pi);
    if (d > pi) d -= 2 * pi;
    if (d < -pi) d += 2 * pi;
    return d;
}

bool worth_a_shot(const Self& self, const Seat& seat, const Mind& mind) {
    const double distance = glm::distance(self.eye, mind.foe);
    const bool near = distance < near_share * seat.skill.keep;
    return self.can_shoot && distance < seat.skill.range && (near || self.energy_share > seat.skill.reserve);
}

/// A fair share of what is left to turn.
std::int32_t take_share(std::int32_t& left, Tick ticks_left) {
    const auto part = left / static_cast<std::int32_t>(ticks_left);
    left -= part;
    return part;
}

}  // namespace

Aim aim_at(vec3 eye, vec3 target) {
    const vec3 d = target - eye;
    return {det::atan2(-d.x, -d.z), det::atan2(d.y, std::sqrt(d.x * d.x + d.z * d.z))};
}

void wander_aim(const Seat& seat, Mind& mind) {
    constexpr double keep = 0.98;
    const double fresh = std::sqrt(1 - keep * keep);
    mind.error_right = keep * mind.error_right + fresh * seat.skill.aim_error * normal(mind.random);
    mind.error_up = keep * mind.error_up + fresh * 0.5 * seat.skill.aim_error * normal(mind.random);
}

vec3 aim_point(const Self& self, const Seat& seat, const Mind& mind) {
    const double flight = glm::distance(self.eye, mind.foe) / bolt_speed;
    vec3 moved = mind.foe_velocity * (seat.skill.lead * (seconds(seat.skill.reaction) + flight));
    moved.y = 0;  // jumps end soon
    return mind.foe + moved;
}

void turn_towards(const Self& self, const Seat& seat, Aim aim, Mind& mind) {
    const double limit = seat.skill.turn_speed * gameplay_dt;
    const double left = std::clamp(0.25 * angle_between(self.yaw, aim.yaw), -limit, limit);
    const double up = std::clamp(0.25 * (aim.pitch - self.pitch), -limit, limit);
    mind.right_left = static_cast<std::int32_t>(std::lround(-left / rad_per_count));
    mind.up_left = static_cast<std::int32_t>(std::lround(up / rad_per_count));
}

void choose_fire(const Self& self, const Seat& seat, Aim wanted, Mind& mind, Tick tick) {
    mind.buttons &= ~static_cast<std::uint32_t>(input::Button::fire);
    const bool fresh = mind.foe_seen_at != 0 && tick - mind.foe_seen_at <= ticks(0.3);
    if (!fresh || !worth_a_shot(self, seat, mind)) return;
    const bool aimed = std::abs(angle_between(self.yaw, wanted.yaw)) < 0.15;
    if (aimed && tick >= mind.fire_until + seat.skill.rest) {
        mind.fire_from = tick;
        mind.fire_until = tick + seat.skill.burst;
    }
    if (tick >= mind.fire_from && tick < mind.fire_until)
        mind.buttons |= static_cast<std::uint32_t>(input::Button::fire);
}

void turn_hand(Mind& mind, Tick ticks_left, input::DeviceSample& sample) {
    sample.counts[input::hand::look_right] = take_share(mind.right_left, ticks_left);
    sample.counts[input::hand::look_up] = take_share(mind.up_left, ticks_left);
}

}  // namespace thaum::game
