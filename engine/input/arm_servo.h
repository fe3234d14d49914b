// input/arm_servo.h: servo of a real arm. It runs in the thread that the arm's driver calls at 1 kHz, and
// exchanges data with the simulation without either waiting for the other:
//
//     simulation:   order (newest model) --> [triple buffer] --> arm's thread: servo step --> force
//     arm's thread: sample (measurement, model used) --> [queue] --> simulation: each tick takes the next one
//
// The simulation repeats the same steps with the same samples and models. Its forces therefore equal the
// arm's to the bit, and so do the forces of a replay. Each step must start from the state of the step before.
// If samples were lost, or the simulation has forgotten the model, both restart from a state that the
// simulation chooses. This begins a new *epoch*. Until then the arm's force is that of an ageing model, so it
// ramps to zero.
//
// In a tick without a new pose, the step uses the last valid pose, whose age grows (input/arm_pose.h).
#pragma once
#include <atomic>
#include <cstdint>

#include "core/spsc_queue.h"
#include "core/triple_buffer.h"
#include "haptics/servo.h"
#include "input/arm_pose.h"
#include "input/frame.h"

namespace thaum::input {

/// Ticks for which the simulation remembers the haptic models that it made (a haptic model is all that the
/// servo knows of the world). An older one gives no force.
inline constexpr std::uint32_t remembered_models = 80;

/// Data from the simulation to the arm's thread, in each tick.
struct ArmOrder {
    haptics::Servo servo{};
    haptics::HapticModel model{.on = false};
    vec3 offset{};  ///< displacement from the arm's tip to the hand that feels the haptic model (m)
    haptics::ServoState start{};  ///< servo state at the start of the epoch (a run of samples without a gap)
    std::uint32_t epoch{};  ///< number of the epoch, a run of samples without a gap; 0: before the first one
    /// Number of the haptic model, counted from 1 in each epoch (a run of samples without a gap).
    std::uint32_t number{};
    /// Number of samples of this epoch (a run of samples without a gap) that the simulation had taken when it
    /// made the haptic model.
    std::uint32_t samples{};
};

/// Data from the arm's thread to the simulation, in each tick.
struct ArmSample {
    ArmReading reading{};  ///< reading of the arm; the last valid one if `pose_age` is not 0
    /// Number of the epoch (a run of samples without a gap), and of the sample in it; both from 1.
    std::uint32_t epoch{}, sample{};
    std::uint32_t model{};     ///< number of the haptic model that the arm's thread used
    std::uint32_t pose_age{};  ///< ticks since the pose was measured
    vec3 force{};              ///< force that the arm got for this sample (N)
};

/// Counts of faults in the exchange with an arm's thread, since the start.
struct ArmFaults {
    PoseFaults poses{};
    std::uint64_t lost{};  ///< samples lost because the queue was full
    /// Number of forces for which the simulation came to another result than the arm's thread. If it is not
    /// 0, this program has a bug.
    std::uint64_t differing{};
};

/// Computes the force of an arm from each measurement (the servo step), in the arm's thread, and passes
/// measurement and force to the simulation as a sample.
class ArmServo {
public:
    /// Returns the function that the arm's driver calls in each tick.
    ArmTick tick();
    /// Runs one tick on the arm's thread. Takes no lock and allocates nothing. Returns the force (N, device
    /// frame).
    vec3 step(const ArmReading& reading);

    /// Starts a new simulation, whose epochs (runs of samples without a gap) are numbered from 1 again;
    /// called by the simulation thread. No tick may run meanwhile.
    void begin_match() { epochs_before_ = epoch_; }
    /// Order (the newest haptic model and what belongs to it) for the arm's thread. The caller fills it with
    /// the values that ArmState describes, then calls `publish`.
    ArmOrder& order() { return orders_.to_fill(); }
    /// Hands the order that the caller has filled (the newest haptic model and what belongs to it) to the
    /// arm's thread.
    void publish();
    /// Takes the next sample, with pose and age of the pose as counts (arm::Count). In the result, model_age
    /// (the age of the haptic model) is 0 if no sample can be used. A positive `skips` means that samples of
    /// this epoch were lost or the simulation has forgotten the model; it must then begin a new epoch.
    DeviceSample take();
    /// Number of samples in the queue.
    std::size_t waiting() const { return samples_.size(); }

    /// Counts of faults so far. Any thread may call it.
    ArmFaults faults() const;

private:
    void follow_orders();

    TripleBuffer<ArmOrder> orders_{ArmOrder{}};
    SpscQueue<ArmSample, 1024> samples_;

    // The next members are used by the arm's thread.
    ArmOrder used_{};
    haptics::ServoState state_{};
    ArmPose pose_{};
    std::uint32_t sample_ = 0;
    std::atomic<std::uint64_t> lost_{0};

    // The next members are used by the simulation thread.
    bool taken_now_ = false;  ///< true: a sample was taken since the last order to the arm's thread
    std::uint32_t epochs_before_ = 0;
    /// Epoch, number of the haptic model and samples taken, as in the last order.
    std::uint32_t epoch_ = 0, number_ = 0, taken_ = 0;
    std::uint32_t without_ = 0;  ///< ticks since the last sample
    std::uint32_t buttons_ = 0;
    vec3 told_{};  ///< force that the arm got with the last sample (N)
    std::atomic<std::uint64_t> differing_{0};
};

/// A haptic model that the simulation remembers for remembered_models ticks.
struct RememberedModel {
    haptics::HapticModel model{};
    vec3 offset{};  ///< displacement from the arm's tip to the hand that feels the haptic model (m)
    /// Number of the haptic model, counted from 1 in each epoch (a run of samples without a gap).
    std::uint32_t number{};
    /// Samples that the simulation had taken in the epoch (a run of samples without a gap) when it made the
    /// model.
    std::uint32_t samples{};
};

/// State of an arm in the simulation; no padding. In each tick the simulation calls take_sample and does all
/// other work of the tick. Then it adds a RememberedModel (a haptic model with which it can repeat the arm's
/// steps) with the next `number` and the current `samples`. The same values form the order for the arm's
/// thread.
struct ArmState {
    haptics::ServoState servo{};
    /// Position of the hand in the servo step: the tip, plus the displacement that has built up while the
    /// clutch was held and the tip moved without the hand (m, device frame).
    vec3 hand{};
    vec3 offset{};  ///< displacement from the arm's tip to the hand for the newest haptic model (m)
    vec3 rest{};    ///< position at which a resting hand stays (m)
    std::array<std::int32_t, 3> position_um{}, rotation_urad{};
    std::uint32_t epoch{1};
    std::uint32_t number{};     ///< number of the newest haptic model
    std::uint32_t samples{};    ///< samples taken in this epoch (a run of samples without a gap)
    std::uint32_t without{};    ///< ticks since the last sample
    std::uint32_t old_poses{};  ///< samples without a new measurement, since the start
    /// Epochs (runs of samples without a gap) that ended because samples were missing or lost.
    std::uint32_t gaps{};
    std::uint32_t rests{};  ///< 1: the hand stays where it is, however the arm moves
    std::uint32_t spare{};
};
static_assert(sizeof(ArmState) ==
              sizeof(haptics::ServoState) + 3 * sizeof(vec3) + 14 * sizeof(std::uint32_t));

/// Begins a new epoch (a run of samples without a gap): the arm's thread and the simulation go on from the
/// same servo state.
void begin_epoch(ArmState& arm);

/// Number of the haptic model with which the arm's thread computed the force of a sample; 0: no sample.
std::uint32_t model_of(const ArmState& arm, const DeviceSample& sample);

/// Repeats the servo step that the arm's thread made for a sample. `used` is the haptic model with the number
/// in the sample; null if the simulation no longer has it. `skipped`: ticks were left out before this one.
void take_sample(ArmState& arm, const haptics::Servo& servo, const DeviceSample& sample,
                 const RememberedModel* used, bool skipped);

/// Applies the clutch, a button with which the arm is moved without the hand; called once a tick before the
/// haptic model is made. While the clutch is held, the hand rests at its position, or at the edge of its
/// reach (m, to both sides of the middle), and the arm's tip moves freely. After the release, the hand
/// follows the tip from there. While the hand rests, the haptic model must be off.
void rest_hand(ArmState& arm, bool held, vec3 reach);

/// Position of the hand: where it rests, or else the arm's tip plus the displacement that has built up while
/// the clutch was held (m, device frame).
vec3 hand_of(const ArmState& arm);
/// Position of the arm's tip (m, device frame).
vec3 position_of(const ArmState& arm);

}  // namespace thaum::input
