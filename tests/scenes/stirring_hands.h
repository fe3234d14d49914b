// tests/scenes/stirring_hands.h: two players who stir the cauldron, for benchmarks and tests of a match.
#pragma once
#include <cmath>

#include "core/maths.h"
#include "game/match/simulation.h"
#include "tests/scenes/standing.h"

namespace thaum::bench {

/// Places the players on opposite sides of the rim.
inline void place_at_the_rim(game::Simulation& match) {
    for (std::uint32_t player = 0; player < game::players; ++player)
        stand(match, player, {player == 0 ? -2.2 : 2.2, match.data().wizard.height / 2, 0});
}

/// Input with which both players hold the button Stir and move in circles, one faster than the other.
inline input::InputFrame stirring(Tick tick) {
    input::InputFrame frame;
    for (std::size_t player = 0; player < game::players; ++player) {
        const double angle = 2 * pi * static_cast<double>(tick) / (player == 0 ? 800 : 1300);
        auto& sample = frame.devices[player];
        sample.press(input::Button::stir);
        sample.counts[input::hand::look_right] = static_cast<std::int32_t>(std::lround(3 * det::cos(angle)));
        sample.counts[input::hand::look_up] = static_cast<std::int32_t>(std::lround(3 * det::sin(angle)));
    }
    return frame;
}

}  // namespace thaum::bench
