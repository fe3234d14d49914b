// game/app/live_arm.h: the real arm of a live session. A thread of its own watches the arm and opens a lost
// arm again, because the vendor's library may block for long. Neither the match nor the window waits for this
// thread: the match sees samples or none.
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
    /// Opens the arm, starts its servo ticks and the thread that watches it. The match computes forces for the
    /// device `wanted`. An arm that can give less force is rejected, because its player would feel another
    /// match than the log records.
    static Expected<std::unique_ptr<ArmKeeper>> open(input::ArmServo& servo,
                                                     const haptics::DeviceSpec& wanted);
    /// Leaves the arm without force. Does not wait for a library that hangs.
    ~ArmKeeper();
    ArmKeeper(const ArmKeeper&) = delete;
    ArmKeeper& operator=(const ArmKeeper&) = delete;

    /// Facts about the arm that was opened first.
    const input::ArmFacts& facts() const { return facts_; }
    input::ArmStatus status() const;
    /// Timing of the present arm, or of the last one if the arm is lost.
    input::TickReport times() const;
    /// Number of times the arm was lost.
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
    Arm arm_;  ///< owned by the watching thread once that thread runs

    mutable std::mutex mutex_;  // guards the members below
    std::condition_variable stopped_;
    std::atomic<bool> stop_{false};  ///< also read without the mutex
    input::ArmStatus status_{};
    input::TickReport times_{};
    int losses_ = 0;
    std::jthread thread_;  ///< watches the arm; last, so that it ends while the other members still live
};

}  // namespace thaum::app
