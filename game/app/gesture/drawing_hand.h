// game/app/gesture/drawing_hand.h: a hand that draws strokes outside of a match, by mouse or with a force
// feedback arm. As in a match, a viscous force resists the hand, and each point stores that force as it is
// before any cap.
#pragma once
#include <memory>

#include "core/spsc_queue.h"
#include "gesture/generated_users.h"
#include "gesture/stroke_recorder.h"
#include "haptics/servo.h"
#include "haptics/simulated.h"
#include "input/open_arm.h"

namespace thaum::game::inline app {

class DrawingHand {
public:
    virtual ~DrawingHand() = default;

    /// Moves the hand by counts of the mouse; positive y is downwards. Other devices ignore the call.
    virtual void move(double, double) {}
    /// Presses or releases the mouse button that draws. Other devices ignore the call.
    virtual void press(bool) {}
    /// Gives the recorder one sample for each millisecond up to the time `now_ns` of the monotonic clock.
    virtual void advance(std::int64_t now_ns, gesture::StrokeRecorder& recorder) = 0;
    /// Message if the hand cannot go on: what is wrong, then what to do. Empty: no fault.
    virtual std::string fault() const { return {}; }
};

/// A mouse that moves a simulated hand, by 0.1 mm for each count. Each stroke begins in the middle of a large
/// workspace.
class DrawingMouse : public DrawingHand {
public:
    /// `model`: the device that the simulated hand holds. Only its mechanics are used; its workspace limits
    /// are not.
    DrawingMouse(haptics::DeviceSpec model, std::int64_t now_ns);

    void move(double dx, double dy) override;
    void press(bool down) override;
    void advance(std::int64_t now_ns, gesture::StrokeRecorder& recorder) override;

private:
    haptics::SimulatedDevice device_;
    haptics::SimulatedState state_ = haptics::resting_at(vec3(0));
    /// Target of the hand, and motion of the mouse that the hand has not followed yet (m).
    vec3 target_{}, moved_{};
    std::int64_t now_ns_;
    double seconds_ = 0;
    bool down_ = false;
};

/// An open force feedback arm as a drawing hand. While any of its buttons is held, the hand draws a stroke.
/// The object must not move in memory, because the arm's thread uses it.
class DrawingArm : public DrawingHand {
public:
    /// Opens the arm `name`, with names as for the options --hands and --feel. Its force is at most `share`
    /// of the arm's peak force.
    static Expected<std::unique_ptr<DrawingArm>> open(const std::string& name, double share);

    void advance(std::int64_t now_ns, gesture::StrokeRecorder& recorder) override;
    std::string fault() const override { return arm_->status().text; }

    /// One tick on the arm's thread: records the hand and returns the force (N, device frame). Takes no lock
    /// and allocates nothing.
    vec3 step(const input::ArmReading& reading);

private:
    struct Sample {
        gesture::StrokePoint point{};
        bool down{};
    };

    DrawingArm(std::unique_ptr<input::OpenArm> arm, double share);

    haptics::Servo servo_;
    double damping_{};  ///< viscosity felt while drawing, limited to what the arm can render (N s/m)
    SpscQueue<Sample, 4096> samples_;
    // used only by the arm's thread
    haptics::HapticModel model_{};
    haptics::ServoState state_{};
    std::int64_t begin_ns_ = 0, newest_ns_ = 0;
    /// Declared last, so that its thread ends before the other members are destroyed.
    std::unique_ptr<input::OpenArm> arm_;
};

}  // namespace thaum::game::inline app
