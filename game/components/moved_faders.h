// game/components/moved_faders.h: faders for the forces at the hands that players moved during the match. An entity
// with this component exists from the first move on. For all other faders the settings in the log's header hold.
#pragma once
#include "ecs/component.h"
#include "game/components/match.h"
#include "game/components/wizard.h"
#include "input/frame.h"

namespace thaum::game {

struct MovedFaders {
    /// Value of a fader that was not moved.
    static constexpr std::uint8_t at_rest = 255;

    /// Values of all faders of the first player, then of the second (%). input::HandFader `n` is at n - 1.
    std::array<std::uint8_t, players * input::hand_faders> percent{};
    /// Ticks in which the forces of each player still change because of the last move.
    std::array<std::uint8_t, players> settling{};

    THAUM_COMPONENT(MovedFaders, percent, settling);
};

}  // namespace thaum::game
