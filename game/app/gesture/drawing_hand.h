// game/app/gesture/drawing_hand.h: a hand that draws strokes outside of a match, by mouse or with a force feedback arm. As in
// a match it draws against a viscous field, and the force of a point is what that field asks for, before any cap.
#pragma once
#include <memory>

#include "core/spsc_queue.h"
#include "gesture/generated_users.h"
#include "gesture/stroke_recorder.h"
#include "haptics/servo.h"
#include "haptics/simulated.h"
#include "input/open_arm.h"

namespace thaum::app {

class DrawingHand {
public:
    virtual ~DrawingHand() = default;

    /// Counts of the mouse; positive y is downwards. Other devices ignore it.
    virtual void move(double, double) {}
    /// A button of the mouse that draws. Other devices ignore it.
    virtual void press(bool) {}
    /// Gives the recorder every millisecond up to the time `now_ns` (ns, monotonic clock).
    virtual void advance(std::int64_t now_ns, gesture::StrokeRecorder& recorder) = 0;
    /// One line if the hand cannot go on: what is wrong, then what to do. Empty otherwise.
    virtual std::string fault() const { return {}; }
};

/// A mouse that moves a simulated hand, 0.1 mm a count. Each stroke begins in the middle of a large workspace.
class DrawingMouse : public DrawingHand {
public:
    /// `model` is the device whose mechanism the hand holds; its edges are left out.
    DrawingMouse(haptics::DeviceSpec model, std::int64_t now_ns);

    void move(double dx, double dy) override;
    void press(bool down) override;
    void advance(std::int64_t now_ns, gesture::StrokeRecorder& recorder) override;

private:
    haptics::SimulatedDevice device_;
    haptics::SimulatedState state_ = haptics::resting_at(vec3(0));
    vec3 target_{}, moved_{};  ///< target of the hand, and motion that it has not got yet (m)
    std::int64_t now_ns_;
    double seconds_ = 0;
    bool down_ = false;
};

/// An open arm, with any of its buttons as Trace. Must not move in memory: the arm's thread uses it.
class DrawingArm : public DrawingHand {
public:
    /// Opens the arm `name`, as `--hands` and `--feel` name arms. Its force is at most `share` of the arm's peak.
    static Expected<std::unique_ptr<DrawingArm>> open(const std::string& name, double share);

    void advance(std::int64_t now_ns, gesture::StrokeRecorder& recorder) override;
    std::string fault() const override { return arm_->status().text; }

    /// One tick on the arm's thread. No lock, no allocation. Returns the force (N, device frame).
    vec3 step(const input::ArmReading& reading);

private:
    struct Sample {
        gesture::StrokePoint point{};
        bool down{};
    };

    DrawingArm(std::unique_ptr<input::OpenArm> arm, double share);

    haptics::Servo servo_;
    double damping_{};  ///< viscosity that the arm can render (N s/m)
    SpscQueue<Sample, 4096> samples_;
    // Used by the arm's thread.
    haptics::HapticModel model_{};
    haptics::ServoState state_{};
    std::int64_t begin_ns_ = 0, newest_ns_ = 0;
    std::unique_ptr<input::OpenArm> arm_;  ///< last, so that its thread ends before the other members
};

}  // namespace thaum::app
