// input/arm_pose.h: the newest good pose of an arm, for its thread. A pose that did not come, or that was made no later than the
// one before, leaves the last good one, which gets older: a force must not stem from a pose of more than 20 ticks
// (haptics/safety.h).
#pragma once
#include <atomic>
#include <cstdint>

#include "input/arm.h"

namespace thaum::input {

/// Poses that were none, since the start.
struct PoseTroubles {
    std::uint64_t repeated{};   ///< came again at once
    std::uint64_t backwards{};  ///< were made before the one before
    std::uint64_t unusable{};   ///< were no numbers
};

class ArmPose {
public:
    // The arm's thread.
    void note(const ArmReading& reading);
    /// Whether there was one.
    bool known() const { return known_; }
    const ArmReading& last() const { return last_; }
    /// Ticks since it was measured.
    std::uint32_t age() const { return age_; }

    /// Any thread.
    PoseTroubles troubles() const;

private:
    bool is_new(const ArmReading& reading);

    ArmReading last_{};
    std::uint32_t age_ = 0;
    bool known_ = false;
    std::atomic<std::uint64_t> repeated_{0}, backwards_{0}, unusable_{0};
};

/// m, device frame.
vec3 position_of(const ArmReading& reading);

}  // namespace thaum::input
