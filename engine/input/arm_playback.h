// input/arm_playback.h: plays recorded forces on a real arm. One force acts at each tick of the arm's own
// thread, for as long as it did when recorded. The forces pass through the same servo step as in a match,
// with the safety stage last.
//
//     ArmPlayback hand(haptics::servo_of(facts.spec, share));
//     while (hand.push(force, jumps)) ...          // ahead of time
//     (*arm)->start(hand.tick());
//
// These forces do not depend on the present position of the hand. To the servo they are an active source: one
// that may give energy to the hand, within a budget (haptics/energy.h). If forces are missing, the force
// ramps to zero, as it does in a match when no new haptic model arrives.
#pragma once
#include <array>
#include <atomic>
#include <cstdint>

#include "core/spsc_queue.h"
#include "haptics/servo.h"
#include "input/arm_pose.h"

namespace thaum::input {

/// Counts of forces, ticks and invalid poses since the start.
struct PlaybackReport {
    std::uint64_t played{};   ///< forces played
    std::uint64_t starved{};  ///< ticks without a force between the first and the last force
    double strongest{};       ///< largest force that was sent to the arm (N)
    /// Number of ticks for each cause (haptics::SafetyCause) for which the arm got less force than was asked
    /// for.
    std::array<std::uint64_t, haptics::safety_cause_names.size()> causes{};
    PoseFaults poses{};
};

/// Plays recorded forces on a real arm.
class ArmPlayback {
public:
    /// Capacity of the queue of forces: 16 s, so that the arm has forces while other programs delay the
    /// thread that fills the queue.
    static constexpr std::size_t max_waiting = 16'384;

    explicit ArmPlayback(const haptics::Servo& servo) : servo_(servo) {}

    /// Returns the function that the arm's driver calls in each tick.
    ArmTick tick();
    /// Runs one tick on the arm's thread. Takes no lock and allocates nothing. Returns the force (N, device
    /// frame).
    vec3 step(const ArmReading& reading);

    /// Queues the force of the next tick (N, device frame); called by the one thread that supplies forces.
    /// `jumps`: the force does not continue the last one, as after a jump in the recording. Returns false if
    /// the queue is full.
    bool push(vec3 force, bool jumps) { return forces_.push({force, jumps}); }
    /// Number of forces in the queue.
    std::size_t waiting() const { return forces_.size(); }
    /// Declares that no more forces follow. After the last one the force falls to zero at a limited rate, as
    /// it does at every jump between two forces (haptics/safety.h).
    void end() { ended_ = true; }

    /// Ends all force from the next tick on, permanently. Any thread may call it.
    void stop() { stopped_ = true; }
    /// Counts of forces and ticks so far. Any thread may call it.
    PlaybackReport report() const;

private:
    struct Force {
        vec3 force{};
        bool jumps{};
    };

    bool next();

    haptics::Servo servo_;
    SpscQueue<Force, max_waiting> forces_;
    std::atomic<bool> ended_{false}, stopped_{false};

    // The next members are used by the arm's thread.
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
