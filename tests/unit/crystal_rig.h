// unit/crystal_rig.h: a match with wizards at a crystal, for tests of carving.
#pragma once
#include <gtest/gtest.h>

#include "core/text.h"
#include "game/components/casting.h"
#include "game/components/hand_state.h"
#include "game/components/station.h"
#include "game/stations/crystal/crystal.h"
#include "game/stations/crystal/crystal_shape.h"
#include "tests/scenes/carving_hands.h"
#include "unit/game_duel.h"

namespace thaum::game::test {

using bench::carving;

inline std::unique_ptr<Simulation> at_the_crystal(bool both = true, std::vector<std::string> overrides = {},
                                                  std::uint64_t seed = 3) {
    auto setup = two_hands();
    setup.seed = seed;
    auto match = std::make_unique<Simulation>(duel_data(std::move(overrides)), setup);
    bench::place_at_the_crystal(*match, both);
    return match;
}

inline const Crystal& crystal_in(const Simulation& match, std::uint32_t number = 0) {
    return match.world().get<Crystal>(crystal_entity(match.world(), number));
}
inline Crystal& crystal_to_change(Simulation& match, std::uint32_t number = 0) {
    return match.world_to_change().get<Crystal>(crystal_entity(match.world(), number));
}
inline std::span<float> densities(Simulation& match, std::uint32_t number = 0) {
    return match.world_to_change().blob<CrystalDensity>().subspan(number * crystal_voxels, crystal_voxels);
}
inline void run(Simulation& match, Tick length, const input::InputFrame& frame = {}) {
    for (Tick t = 0; t < length; ++t) match.tick(frame);
}
inline input::InputFrame held(std::initializer_list<input::Button> buttons) {
    input::InputFrame frame;
    for (const auto button : buttons) frame.devices[0].press(button);
    return frame;
}
inline void expect_full_count(const Simulation& match, const Crystal& crystal, Simulation& changed) {
    const auto& body = match.crystals().list.at(crystal.number);
    const auto view = voxels_of(changed.world_to_change(), changed.crystals_to_change(), crystal);
    const auto full = field::overlap_with(view, body.key, crystal_surface);
    EXPECT_EQ(body.overlap.both, full.both);
    EXPECT_EQ(body.overlap.either, full.either);
    EXPECT_EQ(crystal.overlap, full.ratio());
}

}  // namespace thaum::game::test
