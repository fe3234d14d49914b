// game/app/live_arm.h: the real arm of a session: watched, and opened anew where it is lost, by a thread of its own, since the
// vendor's library takes its time. Neither the match nor the window waits for it: the match sees samples or none.
#pragma once
#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

#include "input/arm_servo.h"
#include "input/drivers/openhaptics.h"

namespace thaum::app {

class ArmKeeper {
public:
    /// Opens the arm and starts its ticks. wanted: what the match's forces are made for: an arm that can give less is refused, since it
    /// would feel another match than the log's.
    static Expected<std::unique_ptr<ArmKeeper>> open(input::ArmServo& servo,
                                                     const haptics::DeviceSpec& wanted);
    /// Leaves the arm without force. It does not wait for a library that hangs.
    ~ArmKeeper();
    ArmKeeper(const ArmKeeper&) = delete;
    ArmKeeper& operator=(const ArmKeeper&) = delete;

    /// Of the arm that was opened first.
    const input::ArmFacts& facts() const { return facts_; }
    input::ArmStatus status() const;
    /// Of the arm that is there, or of the last one.
    input::TickReport times() const;
    /// Times it was lost.
    int losses() const;

private:
    using Arm = std::unique_ptr<input::OpenHaptics>;
    ArmKeeper(Arm arm, input::ArmServo& servo, const haptics::DeviceSpec& wanted);
    void watch();
    bool wait_for(int ms);

    void note(const input::ArmStatus& status, const input::TickReport& times);

    input::ArmServo& servo_;
    haptics::DeviceSpec wanted_;
    input::ArmFacts facts_;
    Arm arm_;  ///< the watching thread's, once that runs

    mutable std::mutex mutex_;  // of what follows
    std::condition_variable stopped_;
    std::atomic<bool> stop_{false};  ///< also without the mutex
    input::ArmStatus status_{};
    input::TickReport times_{};
    int losses_ = 0;
    std::thread thread_;  ///< last: begins when the rest is there
};

}  // namespace thaum::app
