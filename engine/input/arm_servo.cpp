#include "input/arm_servo.h"

#include <algorithm>

#include "core/counter.h"

namespace thaum::input {
namespace {

// Largest age at which the arm's thread still takes over a new haptic model (all that the servo knows of the
// world) from the simulation (samples).
constexpr std::uint32_t newest_samples = 40;
// Number of ticks without a sample from the arm's thread after which the arm's buttons count as released, and
// the run of samples as interrupted.
constexpr std::uint32_t patience = 20;

/// Buttons of the arm as buttons of the game. A stylus has one or two, the first at the finger. Other handles
/// have more.
std::uint32_t buttons_of(std::uint32_t arm) {
    constexpr std::array meanings{Button::fire, Button::next_wand, Button::clutch};
    std::uint32_t buttons = 0;
    for (std::size_t i = 0; i < meanings.size(); ++i) {
        if ((arm >> i & 1U) != 0) buttons |= bit(meanings[i]);
    }
    return buttons;
}

/// The servo step, which computes the force from the pose and the haptic model. The arm's thread and the
/// simulation use the same function. `age` is that of the model or of the pose, whichever is older (samples).
vec3 arm_step(const haptics::Servo& servo, haptics::ServoState& state, const haptics::HapticModel& model,
              vec3 position, std::uint32_t age) {
    return haptics::servo_step(servo, state, model, {position, age});
}

}  // namespace

// ---- functions of the arm's thread ------------------------------------------------------------------------

ArmTick ArmServo::tick() {
    const auto step = [](void* context, const ArmReading& reading) {
        return static_cast<ArmServo*>(context)->step(reading);
    };
    return {step, this};
}

void ArmServo::follow_orders() {
    if (!orders_.take()) return;
    const auto& newest = orders_.newest();
    if (newest.epoch != used_.epoch) {
        used_ = newest;
        state_ = newest.start;
        sample_ = 0;
    } else if (sample_ + 1 - newest.samples <= newest_samples) {
        used_ = newest;
    }
}

vec3 ArmServo::step(const ArmReading& reading) {
    follow_orders();
    pose_.note(reading);
    if (!pose_.known() || used_.epoch == 0) return vec3(0);
    ++sample_;
    const auto age = std::max(sample_ - used_.samples, pose_.age());
    const vec3 force =
        arm_step(used_.servo, state_, used_.model, position_of(pose_.last()) + used_.offset, age);
    if (!samples_.push({pose_.last(), used_.epoch, sample_, used_.number, pose_.age(), force})) count(lost_);
    return force;
}

// ---- functions of the simulation --------------------------------------------------------------------------

void ArmServo::publish() {
    auto& order = orders_.to_fill();
    const bool compare = taken_now_ && order.epoch + epochs_before_ == epoch_ && order.samples == taken_ + 1;
    if (compare && order.start.safety.output != told_) count(differing_);
    taken_now_ = false;
    epoch_ = order.epoch += epochs_before_;
    number_ = order.number;
    taken_ = order.samples;
    orders_.publish();
}

DeviceSample ArmServo::take() {
    constexpr std::uint32_t most = 0xffff;
    DeviceSample out;
    const ArmSample* sample = samples_.front();
    for (; sample != nullptr && sample->epoch != epoch_; sample = samples_.front()) samples_.pop();
    if (sample == nullptr) {
        out.buttons = ++without_ <= patience ? buttons_ : 0;
        return out;
    }
    without_ = 0;
    const auto& pose = sample->reading;
    for (std::size_t i = 0; i < 3; ++i) {
        out.counts[arm::position_x + i] = pose.position_um[i];
        out.counts[arm::rotation_x + i] = pose.rotation_urad[i];
    }
    out.counts[arm::pose_age] = static_cast<std::int32_t>(std::min(sample->pose_age, most));
    out.buttons = buttons_ = buttons_of(pose.buttons);
    const auto before = sample->sample - taken_ - 1;
    const auto age = number_ + 1 - sample->model;
    const bool usable = before == 0 && age <= remembered_models;
    if (usable) {
        out.model_age = static_cast<std::uint16_t>(age);
        taken_now_ = true;
        told_ = sample->force;
    } else {
        out.skips = static_cast<std::uint16_t>(std::clamp(before, 1U, most));
    }
    samples_.pop();
    return out;
}

ArmFaults ArmServo::faults() const {
    return {.poses = pose_.faults(),
            .lost = lost_.load(std::memory_order_relaxed),
            .differing = differing_.load(std::memory_order_relaxed)};
}

void begin_epoch(ArmState& arm) {
    ++arm.epoch;
    arm.number = arm.samples = 0;
    arm.servo = haptics::resumed(arm.servo);
}

std::uint32_t model_of(const ArmState& arm, const DeviceSample& sample) {
    return sample.model_age == 0 || sample.model_age > arm.number ? 0 : arm.number + 1 - sample.model_age;
}

void take_sample(ArmState& arm, const haptics::Servo& servo, const DeviceSample& sample,
                 const RememberedModel* used, bool skipped) {
    const bool none = sample.model_age == 0 && sample.skips == 0;
    arm.without = none ? arm.without + 1 : 0;
    const bool gap = skipped || sample.skips != 0 || (none ? arm.without == patience : used == nullptr);
    if (gap) {
        begin_epoch(arm);
        ++arm.gaps;
    }
    if (none || gap) return;
    for (std::size_t i = 0; i < 3; ++i) {
        arm.position_um[i] = sample.counts[arm::position_x + i];
        arm.rotation_urad[i] = sample.counts[arm::rotation_x + i];
    }
    const auto pose_age = static_cast<std::uint32_t>(sample.counts[arm::pose_age]);
    arm.old_poses += pose_age != 0 ? 1 : 0;
    ++arm.samples;
    arm.hand = position_of(arm) + used->offset;
    arm_step(servo, arm.servo, used->model, arm.hand, std::max(arm.samples - used->samples, pose_age));
}

void rest_hand(ArmState& arm, bool held, vec3 reach) {
    if (held && arm.rests == 0) arm.rest = glm::clamp(arm.hand, -reach, reach);
    arm.rests = held ? 1 : 0;
    if (held) arm.offset = arm.rest - position_of(arm);
}

vec3 hand_of(const ArmState& arm) { return arm.rests != 0 ? arm.rest : arm.hand; }

vec3 position_of(const ArmState& arm) { return position_of(ArmReading{.position_um = arm.position_um}); }

}  // namespace thaum::input
