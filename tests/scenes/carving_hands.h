// tests/scenes/carving_hands.h: two players who carve one crystal, for benchmarks and tests of a match.
#pragma once
#include <cmath>

#include "core/maths.h"
#include "game/match/simulation.h"
#include "tests/scenes/standing.h"

namespace thaum::bench {

/// Places the first player in front of a crystal. The second stands behind it if `both`, else far away.
inline void place_at_the_crystal(game::Simulation& match, bool both = true, std::uint32_t number = 0) {
    const vec3 middle = match.world().get<game::Crystal>(game::crystal_entity(match.world(), number)).middle;
    for (std::uint32_t player = 0; player < game::players; ++player) {
        const double off = player == 0 ? -1.5 : both ? 1.5 : -20;
        stand(match, player, {middle.x, match.data().wizard.height / 2, middle.z + off});
    }
}

/// Input with which both players hold the button Stir, push their hands into the crystal and pull them out,
/// and walk around it. Fire is held except in the last quarter of each second, and the tool changes each
/// second.
inline input::InputFrame carving(Tick tick) {
    input::InputFrame frame;
    for (std::size_t player = 0; player < game::players; ++player) {
        const double turn = 2 * pi * static_cast<double>(tick) / (player == 0 ? 700 : 1100);
        auto& sample = frame.devices[player];
        sample.press(input::Button::stir);
        if (tick % 1000 < 750) sample.press(input::Button::fire);
        if (tick % 1000 > 980) sample.wand = static_cast<std::uint8_t>(1 + (tick / 1000 + player) % 4);
        sample.counts[input::hand::look_right] = static_cast<std::int32_t>(std::lround(2 * det::cos(turn)));
        sample.counts[input::hand::look_up] = static_cast<std::int32_t>(std::lround(2 * det::sin(turn)));
        sample.counts[input::hand::forward] = tick % 600 < 350 ? 127 : -127;
    }
    return frame;
}

}  // namespace thaum::bench
