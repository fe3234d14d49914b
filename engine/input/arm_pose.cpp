#include "input/arm_pose.h"

#include "core/counter.h"

namespace thaum::input {
namespace {

// Shortest interval between two poses; poses with less time between them count as the same pose (ns).
constexpr std::int64_t shortest_tick_ns = 250'000;
// Ticks without a newer pose after which a pose with an earlier time is accepted. The device's clock was then
// probably set back.
constexpr std::uint32_t set_back_after = 20;
constexpr double metres_per_um = 1e-6;

}  // namespace

bool ArmPose::is_new(const ArmReading& reading) {
    if (!reading.usable) return count(unusable_), false;
    if (!known_) return true;
    const auto later = reading.time_ns - last_.time_ns;
    if (later < 0) return count(backwards_), age_ >= set_back_after;
    if (later < shortest_tick_ns) return count(repeated_), false;
    return true;
}

void ArmPose::note(const ArmReading& reading) {
    if (!is_new(reading)) {
        ++age_;
        return;
    }
    last_ = reading;
    age_ = 0;
    known_ = true;
}

PoseFaults ArmPose::faults() const {
    return {.repeated = repeated_.load(std::memory_order_relaxed),
            .backwards = backwards_.load(std::memory_order_relaxed),
            .unusable = unusable_.load(std::memory_order_relaxed)};
}

vec3 position_of(const ArmReading& reading) {
    const auto& um = reading.position_um;
    return vec3(um[0], um[1], um[2]) * metres_per_um;
}

}  // namespace thaum::input
