#include "game/app/live_arm.h"

#include <chrono>

#include "core/text.h"
#include "core/threads.h"
#include "game/app/end_watch.h"

namespace thaum::app {
namespace {

constexpr int look_ms = 50, try_again_ms = 1000;

Expected<std::unique_ptr<input::OpenHaptics>> opened(input::ArmServo& servo,
                                                     const haptics::DeviceSpec& wanted,
                                                     const std::atomic<bool>& enough) {
    auto arm = input::OpenHaptics::open({}, {.enough = &enough});
    if (!arm) return arm;
    const auto& spec = (*arm)->facts().spec;
    if (spec.peak_force < wanted.peak_force) {
        return fail(text("this arm gives ", fixed(spec.peak_force, 1), " N, hands hold a ", wanted.name,
                         " of ", fixed(wanted.peak_force, 1),
                         " N: choose another with --set haptics.device=..."));
    }
    if (const auto started = (*arm)->start(servo.tick()); !started) return tl::unexpected(started.error());
    return arm;
}

}  // namespace

Expected<std::unique_ptr<ArmKeeper>> ArmKeeper::open(input::ArmServo& servo,
                                                     const haptics::DeviceSpec& wanted) {
    auto arm = opened(servo, wanted, EndWatch::asked());
    if (!arm) return tl::unexpected(arm.error());
    std::unique_ptr<ArmKeeper> keeper(new ArmKeeper(std::move(*arm), servo, wanted));
    auto watching = start_thread([&keeper = *keeper] { keeper.watch(); });
    if (!watching) return tl::unexpected(watching.error());
    keeper->thread_ = std::move(*watching);
    return keeper;
}

ArmKeeper::ArmKeeper(Arm arm, input::ArmServo& servo, const haptics::DeviceSpec& wanted)
    : servo_(servo), wanted_(wanted), facts_(arm->facts()), arm_(std::move(arm)) {}

ArmKeeper::~ArmKeeper() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    stopped_.notify_one();
}

input::ArmStatus ArmKeeper::status() const {
    const std::lock_guard lock(mutex_);
    return status_;
}

input::TickReport ArmKeeper::times() const {
    const std::lock_guard lock(mutex_);
    return times_;
}

int ArmKeeper::losses() const {
    const std::lock_guard lock(mutex_);
    return losses_;
}

/// Waits for `ms`. Returns false if the session ends.
bool ArmKeeper::wait_for(int ms) {
    std::unique_lock lock(mutex_);
    return !stopped_.wait_for(lock, std::chrono::milliseconds(ms), [this] { return stop_.load(); });
}

/// Stores the arm's status. A lost arm counts as present again from its first tick on, not before.
void ArmKeeper::note(const input::ArmStatus& status, const input::TickReport& times) {
    const bool lost = status.state != input::ArmPresence::present;
    const std::lock_guard lock(mutex_);
    times_ = times;
    if (lost && status_.state == input::ArmPresence::present) ++losses_;
    if (lost || status.newest_ns != 0) status_ = status;
}

/// Watches the arm until the session ends. A lost arm is closed first, so that its thread has ended before
/// another arm uses the servo.
void ArmKeeper::watch() {
    while (wait_for(arm_ ? look_ms : try_again_ms)) {
        if (!arm_) {
            auto again = opened(servo_, wanted_, stop_);
            if (!again) {
                const std::lock_guard lock(mutex_);
                status_.text = again.error().message;  // the reason why the arm cannot be opened now
                continue;
            }
            arm_ = std::move(*again);
        }
        const auto status = arm_->status();
        const auto times = arm_->times();
        const bool lost = status.state != input::ArmPresence::present;
        note(status, times);
        if (lost) arm_.reset();
    }
    if (!arm_) return;
    const auto times = arm_->times();
    const std::lock_guard lock(mutex_);
    times_ = times;
}

}  // namespace thaum::app
