// input/arm_servo.h: the servo of a real arm, in the thread that calls at 1 kHz, and what ties it to the simulation without either
// waiting for the other:
//
//     simulation:  order (newest model) --> [latest value] --> arm's thread: servo step --> force
//     arm's thread: sample (what was measured, which model was used) --> [queue] --> simulation: tick t takes the next one
//
// The simulation makes the same steps with the same samples and models, so its forces are the arm's to the bit, and so are those of
// a replay. For that each step must be made from the state of the one before. Where samples got lost, or the simulation does not
// remember the model any more, both begin anew from a state that the simulation names: a new *epoch*. Until then the arm's
// force is that of a model which gets old, so it ramps to zero.
//
// A tick without a new pose is stepped with the last good one, which counts as old (input/arm_pose.h).
#pragma once
#include <atomic>
#include <cstdint>

#include "core/spsc_queue.h"
#include "core/triple_buffer.h"
#include "haptics/servo.h"
#include "input/arm_pose.h"
#include "input/frame.h"

namespace thaum::input {

/// Ticks for which the simulation remembers the models it made. What is older gives no force any more.
inline constexpr std::uint32_t models_kept = 80;

/// What the simulation tells the arm's thread each tick.
struct ArmOrder {
    haptics::Servo servo{};
    haptics::HapticModel model{.on = false};
    vec3 offset{};                ///< m, as KeptModel's
    haptics::ServoState start{};  ///< of the epoch
    std::uint32_t epoch{};        ///< 0: before the first
    std::uint32_t number{};       ///< of the model, from 1 in each epoch
    std::uint32_t samples{};      ///< of the epoch that the simulation had taken when it made the model
};

/// What the arm's thread tells the simulation.
struct ArmSample {
    ArmReading reading{};             ///< the last good one where `pose_age` is not 0
    std::uint32_t epoch{}, sample{};  ///< from 1 in each epoch
    std::uint32_t model{};            ///< number of the model that was used
    std::uint32_t pose_age{};         ///< ticks since the pose was measured
    vec3 force{};                     ///< N, that it was answered with
};

/// What went wrong since the start.
struct ArmTroubles {
    PoseTroubles poses{};
    std::uint64_t lost{};  ///< samples that found no room in the queue
    std::uint64_t
        differing{};  ///< forces that the simulation computed otherwise: our mistake, never the arm's
};

class ArmServo {
public:
    /// For the driver.
    ArmTick tick();
    /// The arm's thread: one tick. No lock, no allocation. N, device frame.
    vec3 step(const ArmReading& reading);

    // The simulation thread.
    /// Another simulation follows, whose epochs begin at 1 again. No tick is taken in between.
    void begin_match() { epochs_before_ = epoch_; }
    /// To be filled as ArmState says, then `publish`ed.
    ArmOrder& order() { return orders_.to_fill(); }
    void publish();
    /// The next sample, as arm::Count says; model_age 0 where there is none. skips > 0: samples of this epoch got lost, or
    /// the model is forgotten, so the simulation must begin a new one.
    DeviceSample take();
    /// Samples that wait to be taken.
    std::size_t waiting() const { return samples_.size(); }

    /// Any thread.
    ArmTroubles troubles() const;

private:
    void follow_orders();

    TripleBuffer<ArmOrder> orders_{ArmOrder{}};
    SpscQueue<ArmSample, 1024> samples_;

    // The arm's thread.
    ArmOrder used_{};
    haptics::ServoState state_{};
    ArmPose pose_{};
    std::uint32_t sample_ = 0;
    std::atomic<std::uint64_t> lost_{0};

    // The simulation thread.
    bool taken_now_ = false;  ///< a sample, since the last order
    std::uint32_t epochs_before_ = 0;
    std::uint32_t epoch_ = 0, number_ = 0, taken_ = 0;  ///< of the last order
    std::uint32_t without_ = 0;                         ///< ticks since there was a sample
    std::uint32_t buttons_ = 0;
    vec3 told_{};  ///< N: what the arm was told with the sample taken last
    std::atomic<std::uint64_t> differing_{0};
};

/// A model that the simulation made, and remembers for models_kept ticks.
struct KeptModel {
    haptics::HapticModel model{};
    vec3 offset{};            ///< m, from the arm's tip to the hand that feels the model
    std::uint32_t number{};   ///< from 1 in each epoch
    std::uint32_t samples{};  ///< as ArmOrder's
};

/// An arm as the simulation knows it; no padding. Its tick: take_sample; whatever else happens; a new KeptModel, with the next
/// `number` and the `samples` so far, which is also the order for the arm's thread.
struct ArmState {
    haptics::ServoState servo{};
    vec3 hand{};    ///< m, device frame: what was felt with, the tip but for what the clutch has moved
    vec3 offset{};  ///< m, from the tip to the hand, by the newest model
    vec3 rest{};    ///< m: where the hand is while it rests
    std::array<std::int32_t, 3> position_um{}, rotation_urad{};
    std::uint32_t epoch{1};
    std::uint32_t number{};     ///< of the newest model
    std::uint32_t samples{};    ///< taken in this epoch
    std::uint32_t without{};    ///< ticks since there was a sample
    std::uint32_t old_poses{};  ///< samples, since the start, that measured nothing new
    std::uint32_t gaps{};       ///< epochs that ended because samples failed to come or were lost
    std::uint32_t rests{};      ///< 1: the hand stays where it is, whatever the arm does
    std::uint32_t spare{};
};
static_assert(sizeof(ArmState) ==
              sizeof(haptics::ServoState) + 3 * sizeof(vec3) + 14 * sizeof(std::uint32_t));

/// Whatever the arm's thread did, both go on from the same state.
void begin_epoch(ArmState& arm);

/// Number of the model that a sample was made with; 0: it is no sample.
std::uint32_t model_of(const ArmState& arm, const DeviceSample& sample);

/// The arm's step with this sample, once more. used: the model of that number, null where it is not remembered. skipped: ticks
/// were left out before this one.
void take_sample(ArmState& arm, const haptics::Servo& servo, const DeviceSample& sample,
                 const KeptModel* used, bool skipped);

/// The clutch: while it is held the hand rests where it is, or at the edge of its reach (m, either way), and the arm's tip moves free of
/// it; let go, the hand follows the tip from there. Once a tick, before the model. A model with which the hand rests must be off.
void rest_hand(ArmState& arm, bool held, vec3 reach);

/// m, device frame: where the hand is, and where the arm's tip.
vec3 hand_of(const ArmState& arm);
vec3 position_of(const ArmState& arm);

}  // namespace thaum::input
