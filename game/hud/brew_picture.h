// game/hud/brew_picture.h: one moment of a cauldron and its brew, as plain data: what pictures are made of (game/hud/brew_look.h).
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "game/cauldron/brew.h"
#include "game/components/match.h"
#include "game/components/wizard.h"

namespace thaum::game {

class Simulation;

/// Linear light.
struct BrewColours {
    fvec3 base{};
    std::array<fvec3, fluid::substances_most> substances{};
};

/// One moment of a brew, as plain data. Taking one into the same again allocates nothing.
struct BrewPicture {
    std::uint64_t state{};  ///< another number: something has changed; 0: nothing was taken yet
    fluid::Lattice lattice{};
    std::array<fluid::Samples, 3> velocity{};  ///< m/s
    std::array<vec3, 3> velocity_places{};     ///< where each component of cell (0, 0, 0) stands, in cells
    std::array<fluid::Samples, fluid::substances_most>
        densities{};  ///< empty: nothing stands in that substance
    BrewColours colours{};
    fluid::Sheet sheet{};
};
/// `state` above 0; another one for each state of the brew.
void take_brew(const Brew& brew, const CauldronRules& rules, std::uint64_t state, BrewPicture& out);

/// A rod with a bowl at its lower end.
struct LadlePicture {
    vec3 bowl{}, grip{};   ///< m: the middle of the bowl, and the upper end
    double force_share{};  ///< of the device's peak, 0 to 1
};

/// A match's cauldron.
struct CauldronPicture {
    bool there = false;
    BrewPicture brew;
    std::array<std::optional<LadlePicture>, players> ladles{};
    std::array<std::string_view, fluid::substances_most> contents{};  ///< names; empty: nothing
    std::uint32_t owner{no_player};
    double mixing{};       ///< of what was dropped in last, 0 to 1
    double heat{};         ///< 0: as heavy as a pure brew, to 1: so light that it lifts who is near
    double spoils_in_s{};  ///< 0: nothing was begun
};
void take_cauldron(const Simulation& match, CauldronPicture& out);

}  // namespace thaum::game
