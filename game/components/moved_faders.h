// game/components/moved_faders.h: positions of the force faders that players have moved during the match (a
// fader scales one kind of force at the hand). An entity with this component exists from the first move on.
// Faders that were not moved have the settings in the log's header.
#pragma once
#include "ecs/component.h"
#include "game/components/match.h"
#include "game/components/wizard.h"
#include "input/frame.h"

namespace thaum::game::inline components {

struct MovedFaders {
    /// Value for a fader that has not been moved.
    static constexpr std::uint8_t at_rest = 255;

    /// Values of all faders of the first player, then of the second (%). Fader `n` (input::HandFader) is at
    /// index n - 1 of its player's part.
    std::array<std::uint8_t, players * input::hand_faders> percent{};
    /// For each player, ticks left until every system has computed its forces with the fader's newest value.
    /// Until then the servo fades to each new force.
    std::array<std::uint8_t, players> settling{};

    THAUM_COMPONENT(MovedFaders, percent, settling);
};

}  // namespace thaum::game::inline components
