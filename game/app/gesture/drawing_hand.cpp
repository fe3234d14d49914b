#include "game/app/gesture/drawing_hand.h"

#include <algorithm>

#include "core/units.h"
#include "game/app/named_arm.h"
#include "input/arm_pose.h"

namespace thaum::game::inline app {
namespace {

constexpr double metres_per_count = 1e-4;
// Distance from the middle at which the hand of the mouse is stopped, larger than any desk (m)
constexpr double mouse_workspace = 10;
constexpr std::int64_t tick_ns = 1'000'000;
/// Largest number of ticks simulated in one call. After a longer gap, as when the computer was suspended, the
/// simulated time goes on at the present and the rest of the gap is skipped.
constexpr std::int64_t max_ticks = 250;

haptics::DeviceSpec without_edges(haptics::DeviceSpec spec) {
    spec.workspace = vec3(mouse_workspace);
    return spec;
}

}  // namespace

DrawingMouse::DrawingMouse(haptics::DeviceSpec model, std::int64_t now_ns)
    : device_(haptics::simulated_device(without_edges(std::move(model)), {})), now_ns_(now_ns) {}

void DrawingMouse::move(double dx, double dy) { moved_ += metres_per_count * vec3(dx, -dy, 0); }

void DrawingMouse::press(bool down) {
    if (down && !down_) {
        state_ = haptics::resting_at(vec3(0));
        target_ = moved_ = vec3(0);
    }
    down_ = down;
}

void DrawingMouse::advance(std::int64_t now_ns, gesture::StrokeRecorder& recorder) {
    now_ns_ = std::max(now_ns_, now_ns - max_ticks * tick_ns);
    const auto ticks = (now_ns - now_ns_) / tick_ns;
    if (ticks <= 0) return;
    now_ns_ += ticks * tick_ns;
    // The motion of the mouse since the last call is spread evenly over the ticks since then.
    const vec3 step = moved_ / static_cast<double>(ticks);
    moved_ = vec3(0);
    for (std::int64_t i = 0; i < ticks; ++i) {
        target_ += step;
        const vec3 field = -gesture::stroke_viscosity * state_.velocity;
        state_ = haptics::step(device_, state_, target_, field);
        seconds_ += tick_seconds;
        recorder.feed({seconds_, haptics::measured_position(device_, state_), glm::length(field)}, down_);
    }
}

DrawingArm::DrawingArm(std::unique_ptr<input::OpenArm> arm, double share)
    : servo_(haptics::servo_of(arm->facts().spec, share)),
      damping_(std::min(gesture::stroke_viscosity, servo_.max_damping)),
      arm_(std::move(arm)) {}

Expected<std::unique_ptr<DrawingArm>> DrawingArm::open(const std::string& name, double share) {
    auto arm = open_named_arm("--device", name);
    if (!arm) return arm.error();
    std::unique_ptr<DrawingArm> hand(new DrawingArm(std::move(*arm), share));
    const auto step = [](void* context, const input::ArmReading& reading) {
        return static_cast<DrawingArm*>(context)->step(reading);
    };
    if (const auto started = hand->arm_->start({step, hand.get()}); !started) return started.error();
    return hand;
}

vec3 DrawingArm::step(const input::ArmReading& reading) {
    if (!reading.usable || reading.time_ns <= newest_ns_) return vec3(0);
    if (begin_ns_ == 0) begin_ns_ = reading.time_ns;
    newest_ns_ = reading.time_ns;
    const vec3 at = input::position_of(reading), velocity = haptics::tip_velocity(state_);
    const bool down = reading.buttons != 0;
    // The viscous force switches on and off with the stroke. Each switch gets a new number, so that the force
    // fades to its new value instead of jumping.
    model_.steady_force.number += down == (glm::length(model_.steady_force.force) > 0) ? 0 : 1;
    model_.steady_force.force = down ? -damping_ * velocity : vec3(0);
    samples_.push({{static_cast<double>(reading.time_ns - begin_ns_) * 1e-9, at,
                    gesture::stroke_viscosity * glm::length(velocity)},
                   down});
    return haptics::servo_step(servo_, state_, model_, {at, 0});
}

void DrawingArm::advance(std::int64_t, gesture::StrokeRecorder& recorder) {
    for (const auto* sample = samples_.front(); sample != nullptr; sample = samples_.front()) {
        recorder.feed(sample->point, sample->down);
        samples_.pop();
    }
}

}  // namespace thaum::game::inline app
