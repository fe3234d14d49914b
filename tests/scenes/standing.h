// tests/scenes/standing.h: moves a wizard to a position, for benchmarks and tests of a match.
#pragma once
#include "game/match/simulation.h"

namespace thaum::bench {

/// Moves a wizard so that the body's middle is at a position (m, world).
inline void stand(game::Simulation& match, std::uint32_t player, vec3 place) {
    auto& world = match.world_to_change();
    const auto wizard = game::wizard_of(world, player);
    auto& motion = world.get<game::Motion>(wizard);
    motion.position = place;
    match.physics().set_state(wizard.index, motion);
}

}  // namespace thaum::bench
