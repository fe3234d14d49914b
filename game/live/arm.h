// game/live/arm.h: the real force-feedback arms of a live session. Each arm has a thread that watches it and
// opens it again after a loss, because the vendor's library may block for long. Neither the match nor the
// window waits for these threads: the match finds samples of the arm, or none.
#pragma once
#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "game/live/seats.h"
#include "input/arm_servo.h"
#include "input/open_arm.h"

namespace thaum::game::inline live {

class ArmKeeper {
public:
    /// Opens the arm, starts its servo thread, which computes its force every millisecond, and the thread
    /// that watches it. The match computes forces for the device `wanted`. An arm that can give less force is
    /// rejected, because its player would feel other forces than those of the log.
    static Expected<std::unique_ptr<ArmKeeper>> open(const input::ArmPlace& place, input::ArmServo& servo,
                                                     const haptics::DeviceSpec& wanted);
    /// Leaves the arm without force. Does not wait for a library that hangs.
    ~ArmKeeper();
    ArmKeeper(const ArmKeeper&) = delete;
    ArmKeeper& operator=(const ArmKeeper&) = delete;

    /// Model, serial number and limits of the arm as it was first opened, even if it was lost and opened
    /// again since.
    const input::ArmFacts& facts() const { return facts_; }
    input::ArmStatus status() const;
    /// How well the arm's servo thread, which computes its force, kept time; for a lost arm, until it was
    /// lost.
    input::TickReport times() const;
    /// Number of times the arm was lost.
    int losses() const;
    /// True while the arm is lost. Never waits, so the simulation thread may ask in every tick.
    bool is_lost() const { return lost_; }

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
    std::atomic<bool> stop_{false};  ///< true: the thread must end; also read without the mutex
    /// true: `status_` says that the arm is lost; also read without the mutex
    std::atomic<bool> lost_{false};
    input::ArmStatus status_{};
    input::TickReport times_{};
    int losses_ = 0;
    /// Watches the arm; declared last, so that it ends while the other members still live.
    std::jthread thread_;
};

/// An arm's state as the session shows it.
struct ArmNotice {
    std::string label{};  ///< name and state on the start screen; empty: its state is not known yet
    std::string fault{};  ///< fault of the arm in words, for its player's view; empty: none
};

/// Updates the notice of the arm called `name`. Returns a line for the
/// terminal if the arm was lost or is back.
std::optional<std::string> update(ArmNotice& notice, const std::string& name, const input::ArmStatus& status);

/// One real arm of the session, and the player who holds it.
struct LiveArm {
    /// number of the player's place, counted from 0, for which --hands asked for the arm
    std::uint32_t seat{};
    std::uint32_t player = no_player;  ///< player who holds the arm in this match; no_player: nobody
    /// computes the forces in the arm's thread, and passes its samples to the simulation
    input::ArmServo servo{};
    std::unique_ptr<ArmKeeper> keeper{};  ///< opens the arm and watches it; owned by the main thread
    ArmNotice notice{};  ///< the arm's state as the session shows it; used by the main thread only
};
using LiveArms = std::vector<std::unique_ptr<LiveArm>>;

/// Opens the arms that the players' seats ask for (Seat::arm), in the order of the seats.
Expected<LiveArms> open_arms(std::span<const Seat> seats, const haptics::DeviceSpec& wanted);

/// Gives each arm to its player for the next match. If the start screen chose the seats, the first arm goes
/// to the player with the mouse, and the second one to the other person. Otherwise each arm goes to the
/// player of LiveArm::seat.
void bind_arms(LiveArms& arms, const TakenSeats& seats, bool start_screen);

/// Updates the notices of all arms, and prints which arms were lost or are back. While an arm is lost, mouse
/// or pad move its player's hand, and the ArmKeeper tries to open the arm again.
void follow_arms(LiveArms& arms);

/// Calls f(arm, device) for each real arm that a player holds. `device` is its index among the match's
/// devices, which begin with the hands of both players.
template <class F>
void each_held_arm(const LiveArms& arms, F&& f) {
    std::size_t device = players;
    for (const auto& arm : arms) {
        if (arm->player < players) f(*arm, device++);
    }
}

/// Devices beyond the hands of both players: the real arms that players hold.
std::vector<input::DeviceSpec> arms_of(const LiveArms& arms);
/// All devices of a match: the hands of both players, then the arms.
std::vector<input::DeviceSpec> devices_of(const TakenSeats& seats, const LiveArms& arms);

}  // namespace thaum::game::inline live
