#include "input/arm_playback.h"

#include <algorithm>

#include "core/counter.h"

namespace thaum::input {

ArmTick ArmPlayback::tick() {
    const auto step = [](void* context, const ArmReading& reading) {
        return static_cast<ArmPlayback*>(context)->step(reading);
    };
    return {step, this};
}

/// Takes the force of this tick from the queue and puts it into the haptic model, from which the servo
/// computes what the arm gets. Returns false before the first force.
bool ArmPlayback::next() {
    if (const auto* force = forces_.front(); force != nullptr) {
        model_.steady_force = {.force = force->force,
                               .number = model_.steady_force.number + (force->jumps ? 1 : 0)};
        forces_.pop();
        age_ = 0;
        count(played_);
        return true;
    }
    if (played_.load(std::memory_order_relaxed) == 0) return false;
    if (ended_) {
        if (!at_end_) model_.steady_force = {.force = vec3(0), .number = model_.steady_force.number + 1};
        at_end_ = true;
        age_ = 0;
        return true;
    }
    ++age_;
    count(starved_);
    return true;
}

vec3 ArmPlayback::step(const ArmReading& reading) {
    pose_.note(reading);
    if (!pose_.known() || !next()) return vec3(0);
    model_.panic = stopped_;
    const auto age = std::max(age_, pose_.age());
    const vec3 force = haptics::servo_step(servo_, state_, model_, {position_of(pose_.last()), age});
    count(causes_[state_.safety.cause]);
    const double size = glm::length(force);
    if (size > strongest_.load(std::memory_order_relaxed)) strongest_.store(size, std::memory_order_relaxed);
    return force;
}

PlaybackReport ArmPlayback::report() const {
    PlaybackReport report{.played = played_.load(std::memory_order_relaxed),
                          .starved = starved_.load(std::memory_order_relaxed),
                          .strongest = strongest_.load(std::memory_order_relaxed),
                          .poses = pose_.faults()};
    std::transform(causes_.begin(), causes_.end(), report.causes.begin(),
                   [](const auto& ticks) { return ticks.load(std::memory_order_relaxed); });
    return report;
}

}  // namespace thaum::input
