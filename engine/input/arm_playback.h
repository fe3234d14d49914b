// input/arm_playback.h: recorded forces, played to a real arm: one at each tick of the arm's own thread, so that each acts for as long as
// it did, and through the same servo step as in a match, the safety stage last.
//
//     ArmPlayback hand(haptics::servo_of(facts.spec, share));
//     while (hand.push(force, jumps)) ...          // ahead of time
//     (*arm)->start(hand.tick());
//
// Nobody computes these forces from where the hand is now: to the servo they are an active source, with its budget of energy
// (haptics/energy.h). Where they fail to come, the force ramps to zero as for a model that got old.
#pragma once
#include <array>
#include <atomic>
#include <cstdint>

#include "core/spsc_queue.h"
#include "haptics/servo.h"
#include "input/arm_pose.h"

namespace thaum::input {

/// Since the start.
struct PlaybackReport {
    std::uint64_t played{};   ///< forces
    std::uint64_t starved{};  ///< ticks between the first and the last for which there was none
    double strongest{};       ///< N, that the arm was told
    std::array<std::uint64_t, haptics::safety_cause_names.size()>
        causes{};  ///< ticks, by haptics::SafetyCause
    PoseTroubles poses{};
};

class ArmPlayback {
public:
    /// Forces that may wait: 16 s, so that they outlast whatever else the machine is busy with.
    static constexpr std::size_t most_waiting = 16'384;

    explicit ArmPlayback(const haptics::Servo& servo) : servo_(servo) {}

    /// For the driver.
    ArmTick tick();
    /// The arm's thread: one tick. No lock, no allocation. N, device frame.
    vec3 step(const ArmReading& reading);

    // Whoever feeds it: one thread.
    /// The next tick's force, N, device frame; jumps: it does not follow on the one before. False where there is no room.
    bool push(vec3 force, bool jumps) { return forces_.push({force, jumps}); }
    /// Forces that wait to be played.
    std::size_t waiting() const { return forces_.size(); }
    /// No more will come: after the last the force goes to zero, not faster than a switch may.
    void end() { ended_ = true; }

    // Any thread.
    /// No force from the next tick on, for good.
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

    // The arm's thread.
    haptics::HapticModel model_{};
    haptics::ServoState state_{};
    ArmPose pose_{};
    std::uint32_t age_ = 0;  ///< ticks for which there was no force
    bool at_end_ = false;
    std::atomic<std::uint64_t> played_{0}, starved_{0};
    std::atomic<double> strongest_{0};
    std::array<std::atomic<std::uint64_t>, haptics::safety_cause_names.size()> causes_{};
};

}  // namespace thaum::input
