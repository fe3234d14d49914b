#include "game/range/dummy.h"

#include <algorithm>

#include "game/bots/aim.h"
#include "game/bots/senses.h"

namespace thaum::game::inline range {
namespace {

constexpr double step_ahead = 1.2;  ///< distance ahead of the feet that must be safe to walk on (m)
/// Speed below which a walking dummy counts as blocked by an obstacle (m/s)
constexpr double held_up_below = 0.3;
constexpr Tick held_up_for = ticks(0.25);
/// Minimum time between two reversals, so that the dummy does not tremble at an obstacle (ticks).
constexpr Tick turns_not_before = ticks(0.4);
constexpr std::int32_t full = 127;

}  // namespace

Dummy::Dummy(const Simulation& match, std::uint32_t player, DummyKind kind, const DummyRules& rules,
             std::uint64_t seed)
    : kind_(kind),
      rules_(rules),
      seat_{.device = player, .player = player, .skill = rules.skill},
      grid_(match.physics(), ground_bounds(match.data().arena)) {
    mind_.random = random_stream(seed, 100 + player);
}

void Dummy::become(DummyKind kind) {
    if (kind == kind_) return;
    kind_ = kind;
    begins_ = true;
}

void Dummy::adopt(const Simulation& match, const DummyRules& rules) {
    rules_ = rules;
    seat_.skill = rules.skill;
    grid_ = WalkGrid(match.physics(), ground_bounds(match.data().arena));
}

/// Walks sideways, and reverses at the end of the stride, at an edge and at an obstacle.
void Dummy::walk_to_and_fro(const Self& self, Tick tick) {
    const vec3 right = look_rotation(self.yaw, 0) * vec3(1, 0, 0);
    const auto safe = [&] { return grid_.straight(self.centre, self.centre + right * (way_ * step_ahead)); };
    if (glm::dot(self.velocity, right) * way_ > held_up_below) walked_at_ = tick;
    const bool at_end = glm::dot(self.centre - *home_, right) * way_ >= rules_.stride;
    const bool held_up = tick >= std::max(walked_at_, turned_at_) + held_up_for;
    if (at_end || (tick >= turned_at_ + turns_not_before && (held_up || !safe()))) {
        way_ = -way_;
        turned_at_ = tick;
    }
    mind_.move_strafe = safe() ? way_ * full : 0;
}

void Dummy::shoot(const Simulation& match, const Self& self, Tick tick) {
    see_foe(match, self, seat_, eyes_, mind_, tick);
    wander_aim(seat_, mind_);
    const bool watches = mind_.foe_seen_at != 0 && tick - mind_.foe_seen_at < ticks(1.5);
    if (!watches) {
        mind_.buttons = mind_.wand_key = 0;
        return;
    }
    const auto wanted = aim_of_shot(self, aim_point(self, seat_, mind_, seat_.skill.lead));
    turn_towards(self, seat_, {wanted.yaw + mind_.error_right, wanted.pitch + mind_.error_up}, mind_);
    choose_fire(self, seat_, wanted, mind_, tick);
}

void Dummy::begin(Tick tick) {
    eyes_ = {};
    mind_ = {.random = mind_.random};
    way_ = 1;
    walked_at_ = turned_at_ = tick;
}

void Dummy::think(const Simulation& match) {
    const Tick tick = match.match().played;
    const auto self = self_of(match, seat_.player);
    begins_ = begins_ || !self.alive;
    if (begins_) begin(tick);
    if (!self.alive) {
        home_.reset();
        return;
    }
    if (!home_) home_ = self.centre;
    begins_ = false;
    if (kind_ == DummyKind::strafing) walk_to_and_fro(self, tick);
    if (kind_ == DummyKind::shooting) shoot(match, self, tick);
}

input::DeviceSample Dummy::sample(const Simulation& match) {
    input::DeviceSample sample;
    if (match.match().paused != 0 || match.match().phase != Phase::playing) return sample;
    const Tick phase = match.match().played % gameplay_period;
    if (phase == 0) think(match);
    turn_hand(mind_, gameplay_period - phase, sample);
    sample.counts[input::hand::strafe] = mind_.move_strafe;
    sample.buttons = mind_.buttons;
    sample.wand = static_cast<std::uint8_t>(mind_.wand_key);
    if (sample.down(input::Button::fire)) sample.counts[input::hand::trigger] = mind_.trigger;
    return sample;
}

}  // namespace thaum::game::inline range
