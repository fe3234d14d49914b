// tests/scenes/searching_hands.h: two players who search the flow in the orb (a station of the game), for
// benchmarks and tests of a match.
#pragma once
#include "game/match/simulation.h"
#include "game/stations/orb/orb.h"
#include "tests/scenes/standing.h"

namespace thaum::bench {

/// Places the players on two sides of the orb.
inline void place_at_the_orb(game::Simulation& match) {
    const vec3 middle = match.world().single<game::Orb>().middle;
    stand(match, 0, {middle.x + 1.5, match.data().wizard.height / 2, middle.z});
    stand(match, 1, {middle.x, match.data().wizard.height / 2, middle.z + 1.4});
}

/// Input with which both players hold the button Stir, switch two haptic modes on and move their hands to and
/// fro.
inline input::InputFrame searching(Tick tick) {
    input::InputFrame frame;
    for (std::size_t player = 0; player < game::players; ++player) {
        auto& sample = frame.devices[player];
        sample.press(input::Button::stir);
        sample.counts[input::hand::look_right] = tick % 1000 < 500 ? 1 : -1;
        sample.wand = tick == 40 ? 4 : tick == 80 ? 6 : 0;
    }
    return frame;
}

}  // namespace thaum::bench
