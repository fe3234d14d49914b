// game/range/force_trial.h: finds the largest force that a player likes, by trying. On the practice range the
// hand is kicked every half second, each time stronger by 5 % of the device's peak, until the player presses
// fire. A kick is as short as the strongest recoil, so that even the last ones do not reach the thermal limit
// of the motors.
#pragma once
#include <optional>
#include <string>

#include "game/match/simulation.h"

namespace thaum::game::inline range {

/// Removes presses of fire from a player's samples. Returns whether fire was down.
bool take_fire(const std::vector<input::DeviceSpec>& devices, std::uint32_t player, input::InputFrame& frame);

class ForceTrial {
public:
    static constexpr std::uint32_t percent_per_kick = 5;
    static constexpr Tick between_kicks = 500, kick_length = 60;

    /// Starts the search for the largest force, with the weakest kick.
    void begin() { *this = ForceTrial(true); }
    bool runs() const { return runs_; }
    /// Runs the trial; call this before each tick of play of the player's match. Kicks the hand, and removes
    /// fire from the player's samples. Returns, once, the force that the player has chosen (% of the device's
    /// peak). Without a press there is no result.
    std::optional<std::uint32_t> step(Simulation& match, std::uint32_t player, input::InputFrame& frame);
    /// Text for the player about the search for the largest force.
    std::string words() const;

    ForceTrial() = default;

private:
    explicit ForceTrial(bool runs) : runs_(runs) {}

    bool runs_ = false;
    /// Fire was down in the last tick; initially true, so that a press from before the trial does not count.
    bool held_ = true;
    Tick age_{};  ///< ticks since the start of the search
    std::uint32_t percent_{};
};

}  // namespace thaum::game::inline range
