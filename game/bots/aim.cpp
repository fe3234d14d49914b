#include "game/bots/aim.h"

#include <algorithm>
#include <cmath>

namespace thaum::game::inline bots {
namespace {

constexpr double close_to = 0.15;  ///< angle between view and aim below which the bot has reached its aim
                                   ///< (rad)
/// At a foe nearer than this share of its preferred distance, a bot shoots even with the energy that it
/// otherwise keeps in reserve.
constexpr double near_share = 0.7;

/// Random number with mean 0 and standard deviation 1 (the sum of twelve uniform ones).
double normal(Random& random) {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += random.uniform();
    return sum;
}

bool worth_a_shot(const Self& self, const Seat& seat, const Mind& mind) {
    const double distance = glm::distance(self.eye, mind.foe);
    const bool near = distance < near_share * seat.skill.keep;
    return self.can_shoot && distance < seat.skill.range && (near || self.energy_share > seat.skill.reserve);
}

/// Returns this tick's equal share of `left`, and subtracts it from `left`. `left`: mouse counts that the bot
/// has still to give before its next gameplay tick.
std::int32_t take_share(std::int32_t& left, Tick ticks_left) {
    const auto part = left / static_cast<std::int32_t>(ticks_left);
    left -= part;
    return part;
}

}  // namespace

void wander_aim(const Seat& seat, Mind& mind) {
    constexpr double keep = 0.98;
    const double fresh = std::sqrt(1 - keep * keep);
    mind.error_right = keep * mind.error_right + fresh * seat.skill.aim_error * normal(mind.random);
    mind.error_up = keep * mind.error_up + fresh * 0.5 * seat.skill.aim_error * normal(mind.random);
}

vec3 aim_point(const Self& self, const Seat& seat, const Mind& mind, double lead) {
    const double flight = self.shot.speed > 0 ? glm::distance(self.eye, mind.foe) / self.shot.speed : 0;
    vec3 moved = mind.foe_velocity * (lead * (seconds(seat.skill.reaction) + flight));
    moved.y = 0;  // a foe's jump ends soon, so its vertical motion is not extrapolated
    return mind.foe + moved;
}

Aim aim_of_shot(const Self& self, vec3 target) {
    if (!(self.shot.fall > 0)) return aim_at(self.eye, target);
    const vec3 to = target - self.tip;
    const double flat = std::sqrt(to.x * to.x + to.z * to.z);
    const double v2 = self.shot.speed * self.shot.speed, g = self.shot.fall;
    const double root = v2 * v2 - g * (g * flat * flat + 2 * to.y * v2);
    Aim aim = aim_at(self.eye, target);
    // A target out of reach has no solution, so the bot throws at 45 degrees, as far as possible.
    aim.pitch = root > 0 ? det::atan2(v2 - std::sqrt(root), g * flat) : pi / 4;
    return aim;
}

void turn_towards(const Self& self, const Seat& seat, Aim aim, Mind& mind) {
    const double limit = seat.skill.turn_speed * gameplay_dt;
    const double left = std::clamp(0.25 * angle_between(self.yaw, aim.yaw), -limit, limit);
    const double up = std::clamp(0.25 * (aim.pitch - self.pitch), -limit, limit);
    mind.right_left = static_cast<std::int32_t>(std::lround(-left / rad_per_count));
    mind.up_left = static_cast<std::int32_t>(std::lround(up / rad_per_count));
}

namespace {

constexpr auto fire = static_cast<std::uint32_t>(input::Button::fire);

bool seen_within(const Mind& mind, double duration, Tick tick) {
    return mind.foe_seen_at != 0 && tick - mind.foe_seen_at <= ticks(duration);
}

/// Holds fire until the wand is charged, or drawn like a bow, as far as wanted and the view has reached its
/// aim. Then releases fire.
void ready_and_let_go(const Self& self, const Seat& seat, Aim wanted, Mind& mind, Tick tick) {
    // The bot lets go when the charge, or the draw of a wand like a bow, is at most this much below the
    // wanted value (both 0 to 1).
    constexpr double enough = 0.04;
    const bool arc = self.shot.fall > 0;
    const bool knows = seen_within(mind, arc ? 1.4 : 0.3, tick);
    const bool aimed = std::abs(angle_between(self.yaw, wanted.yaw)) < close_to &&
                       std::abs(self.pitch - wanted.pitch) < close_to;
    if ((mind.buttons & fire) == 0) {
        const bool rested = tick >= mind.fire_until + seat.skill.rest;
        if (!rested || !knows || !worth_a_shot(self, seat, mind)) return;
        mind.trigger = arc ? static_cast<std::int32_t>(std::lround(255 * mind.readiness)) : 255;
        mind.fire_from = tick;
        mind.buttons |= fire;
        return;
    }
    const bool ready = self.readiness >= mind.readiness - enough;
    const bool given_up = tick >= mind.fire_from + ticks(5.0);
    if (!given_up && !(ready && knows && aimed)) return;
    mind.buttons &= ~fire;
    mind.fire_until = tick;
}

}  // namespace

void choose_fire(const Self& self, const Seat& seat, Aim wanted, Mind& mind, Tick tick) {
    if (self.shot.held) return ready_and_let_go(self, seat, wanted, mind, tick);
    mind.trigger = 255;
    mind.buttons &= ~fire;
    if (!seen_within(mind, 0.3, tick) || !worth_a_shot(self, seat, mind)) return;
    const bool aimed = std::abs(angle_between(self.yaw, wanted.yaw)) < close_to;
    if (aimed && tick >= mind.fire_until + seat.skill.rest) {
        mind.fire_from = tick;
        mind.fire_until = tick + seat.skill.burst;
    }
    if (tick >= mind.fire_from && tick < mind.fire_until) mind.buttons |= fire;
}

void turn_hand(Mind& mind, Tick ticks_left, input::DeviceSample& sample) {
    sample.counts[input::hand::look_right] = take_share(mind.right_left, ticks_left);
    sample.counts[input::hand::look_up] = take_share(mind.up_left, ticks_left);
}

}  // namespace thaum::game::inline bots
