// input/arm_playback.h: plays recorded forces on a real arm. One force acts at each tick of the arm's own
// thread, for as long as it did when recorded. The forces pass through the same servo step as in a match,
// with the safety stage last.
//
//     ArmPlayback hand(haptics::servo_of(facts.spec, share));
//     while (hand.push(force, jumps)) ...          // ahead of time
//     (*arm)->start(hand.tick());
//
// These forces do not depend on the present position of the hand. To the servo they are an active source,
// with its budget of energy (haptics/energy.h). If forces are missing, the force ramps to zero as for an old
// model.
#pragma once
#include <array>
#include <atomic>
#include <cstdint>

#include "core/spsc_queue.h"
#include "haptics/servo.h"
#include "input/arm_pose.h"

namespace thaum::input {

/// Counts since the start.
struct PlaybackReport {
    std::uint64_t played{};   ///< forces played
    std::uint64_t starved{};  ///< ticks between the first and the last force that had none
    double strongest{};       ///< largest force that the arm was told (N)
    /// Ticks by haptics::SafetyCause.
    std::array<std::uint64_t, haptics::safety_cause_names.size()> causes{};
    PoseFaults poses{};
};

class ArmPlayback {
public:
    /// Capacity of the queue of forces: 16 s, so that the queue outlasts other work of the machine.
    static constexpr std::size_t most_waiting = 16'384;

    explicit ArmPlayback(const haptics::Servo& servo) : servo_(servo) {}

    /// Returns the function for the driver.
    ArmTick tick();
    /// Runs one tick on the arm's thread. No lock, no allocation. Returns the force (N, device frame).
    vec3 step(const ArmReading& reading);

    // For one thread, which supplies the forces.
    /// Queues the force of the next tick (N, device frame). `jumps`: it does not continue the last one.
    /// Returns false if the queue is full.
    bool push(vec3 force, bool jumps) { return forces_.push({force, jumps}); }
    /// Number of forces in the queue.
    std::size_t waiting() const { return forces_.size(); }
    /// Ends the supply. After the last force, the force goes to zero no faster than at a switch.
    void end() { ended_ = true; }

    // For any thread.
    /// Gives no force from the next tick on, for good.
    void stop() { stopped_ = true; }
    PlaybackReport report() const;

private:
    struct Force {
        vec3 force{};
        bool jumps{};
    };

    bool next();

    haptics::Servo servo_;
    SpscQueue<Force, most_waiting> forces_;
    std::atomic<bool> ended_{false}, stopped_{false};

    // Used by the arm's thread.
    haptics::HapticModel model_{};
    haptics::ServoState state_{};
    ArmPose pose_{};
    std::uint32_t age_ = 0;  ///< ticks in a row without a force
    bool at_end_ = false;
    std::atomic<std::uint64_t> played_{0}, starved_{0};
    std::atomic<double> strongest_{0};
    std::array<std::atomic<std::uint64_t>, haptics::safety_cause_names.size()> causes_{};
};

}  // namespace thaum::input
