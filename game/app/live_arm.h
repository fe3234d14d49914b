// game/app/live_arm.h: the real arms of a live session. A thread for each watches its arm and opens a lost arm
// again, because the vendor's library may block for long. Neither the match nor the window waits for these
// threads: the match sees samples or none.
#pragma once
#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "game/app/live.h"
#include "input/arm_servo.h"
#include "input/open_arm.h"

namespace thaum::app {

class ArmKeeper {
public:
    /// Opens the arm, starts its servo ticks and the thread that watches it. The match computes forces for the
    /// device `wanted`. An arm that can give less force is rejected, because its player would feel another
    /// match than the log records.
    static Expected<std::unique_ptr<ArmKeeper>> open(const input::ArmPlace& place, input::ArmServo& servo,
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
    using Arm = std::unique_ptr<input::OpenArm>;
    ArmKeeper(const input::ArmPlace& place, Arm arm, input::ArmServo& servo,
              const haptics::DeviceSpec& wanted);
    void watch();
    bool wait_for(int ms);

    void note(const input::ArmStatus& status, const input::TickReport& times);

    input::ArmPlace place_;
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

/// One real arm of the session, and the player who holds it.
struct LiveArm {
    std::uint32_t seat{};                    ///< seat of the plan that asked for the arm
    std::uint32_t player = game::no_player;  ///< player who holds it in this match; no_player: nobody
    input::ArmServo servo{};                 ///< servo between the arm's thread and the simulation thread
    std::unique_ptr<ArmKeeper> keeper{};     ///< owned by the main thread
    std::string shown{};                     ///< name and state on the start screen
    std::string says{};                      ///< fault of the arm in words; empty: none
};
using LiveArms = std::vector<std::unique_ptr<LiveArm>>;

/// Opens the arms that the seats ask for, in the order of the seats.
Expected<LiveArms> open_arms(std::span<const Seat> seats, const haptics::DeviceSpec& wanted);

}  // namespace thaum::app
