// game/range/force_trial.h: finds the largest force that a player wants, by feel. On the range the hand is kicked every
// half second, each time by 5 % of the device's peak more, until the player presses fire. A kick is as short as the
// strongest recoil, so that the last ones stay below the limit of the motors' heat.
#pragma once
#include <optional>
#include <string>

#include "game/match/simulation.h"

namespace thaum::app {

/// Takes fire out of a player's samples. Returns whether it was down.
bool take_fire(const std::vector<input::DeviceSpec>& devices, std::uint32_t player, input::InputFrame& frame);

class ForceTrial {
public:
    static constexpr std::uint32_t percent_per_kick = 5;
    static constexpr Tick between_kicks = 500, kick_length = 60;

    /// Begins with the weakest kick.
    void begin() { *this = ForceTrial(true); }
    bool runs() const { return runs_; }
    /// Acts before a tick of play of the player's match: kicks the hand, and takes fire out of the player's samples.
    /// Returns the force on which the player has decided (% of the device's peak), once. Who never presses decides on
    /// none.
    std::optional<std::uint32_t> step(game::Simulation& match, std::uint32_t player,
                                      input::InputFrame& frame);
    /// Words for the player.
    std::string words() const;

    ForceTrial() = default;

private:
    explicit ForceTrial(bool runs) : runs_(runs) {}

    bool runs_ = false;
    bool held_ = true;  ///< fire was down in the last tick: a press that began before does not count
    Tick age_{};        ///< ticks since the beginning
    std::uint32_t percent_{};
};

}  // namespace thaum::app
