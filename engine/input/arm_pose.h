// input/arm_pose.h: newest valid pose of an arm, for the arm's thread. If a pose is missing, or is not newer
// than the last one, the last valid pose stays and its age grows. No force may come from a pose older than 20
// ticks (haptics/safety.h).
#pragma once
#include <atomic>
#include <cstdint>

#include "input/arm.h"

namespace thaum::input {

/// Counts of invalid poses since the start.
struct PoseFaults {
    std::uint64_t repeated{};   ///< poses that were reported a second time
    std::uint64_t backwards{};  ///< poses with an earlier time than the one before
    std::uint64_t unusable{};   ///< poses that are not finite numbers
};

/// The last valid pose of an arm, which stands in while measurements are missing.
class ArmPose {
public:
    /// Takes the reading of a tick: it becomes the last valid pose, or that pose ages. Called by the arm's
    /// thread.
    void note(const ArmReading& reading);
    /// Whether there is a valid pose.
    bool known() const { return known_; }
    /// The last valid measurement.
    const ArmReading& last() const { return last_; }
    /// Ticks since the pose was measured.
    std::uint32_t age() const { return age_; }

    /// Counts of invalid poses so far. Any thread may call it.
    PoseFaults faults() const;

private:
    bool is_new(const ArmReading& reading);

    ArmReading last_{};
    std::uint32_t age_ = 0;
    bool known_ = false;
    std::atomic<std::uint64_t> repeated_{0}, backwards_{0}, unusable_{0};
};

/// Position of the tip (m, device frame).
vec3 position_of(const ArmReading& reading);

}  // namespace thaum::input
