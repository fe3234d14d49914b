// game/picture/brew_picture.h: one moment of a cauldron and its brew as plain data, for drawing
// (game/scene/brew_look.h).
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "game/brew/brew.h"
#include "game/components/match.h"
#include "game/components/wizard.h"

namespace thaum::game::inline match {
class Simulation;
}

namespace thaum::game::inline picture {

/// Colours of the base fluid and the substances (linear light).
struct BrewColours {
    fvec3 base{};
    std::array<fvec3, fluid::max_substances> substances{};
};

/// One moment of a brew as plain data. Copying a brew into the same object again allocates nothing.
struct BrewPicture {
    std::uint64_t state{};  ///< number of the brew's state: any change of the contents changes it; 0: empty
    fluid::Lattice lattice{};
    std::array<fluid::Samples, 3> velocity{};  ///< components of the flow's velocity (m/s)
    /// Place at which each velocity component of cell (0, 0, 0) is sampled, in cells. The places differ,
    /// because each component is sampled on another face of the cell.
    std::array<vec3, 3> velocity_places{};
    /// Density of each substance in each cell; empty if the substance holds no ingredient.
    std::array<fluid::Samples, fluid::max_substances> densities{};
    BrewColours colours{};
    fluid::SpringSurface surface{};
};
/// Copies a brew. `state` must be above 0 and differ between different states of the brew.
void take_brew(const Brew& brew, const CauldronRules& rules, std::uint64_t state, BrewPicture& out);

/// A ladle, with which a wizard stirs: a rod with a bowl at its lower end.
struct LadlePicture {
    vec3 bowl{}, top{};    ///< middle of the bowl, and upper end of the rod (m)
    double force_share{};  ///< force on the hand as a share of the device's peak force, 0 to 1
};

/// The cauldron of a match.
struct CauldronPicture {
    bool there = false;
    BrewPicture brew;
    std::array<std::optional<LadlePicture>, players> ladles{};
    /// Names of the ingredients; an empty name is an unused substance.
    std::array<std::string_view, fluid::max_substances> contents{};
    std::string_view potion{};  ///< name of the potion that has changed the brew; empty: none
    std::uint32_t owner{no_player};
    /// Share of the brew that the newest ingredient fills, 0 to 1 (fluid::filled_share). It is 1 only if the
    /// ingredient is spread evenly, whereas Cauldron::reached counts all cells with at least a quarter of the
    /// mean density.
    double mixed{};
    /// Lightness: 0 for the density of a pure brew, 1 for a brew light enough to lift wizards.
    double heat{};
    double spoils_in_s{};  ///< time until the brew boils over (s); 0: no ingredient yet
    /// Time from the first ingredient to boiling over (s); 0: the brew never boils over.
    double whole_time_s{};
    double fresh{};       ///< time left until the brew boils over, as a share of the whole time, 0 to 1
    double well_mixed{};  ///< value of `mixed` from which the owner is rewarded by healing
    /// Time until the owner gains the boon, a healing for a brew that stays well mixed (s); 0: the brew is
    /// not well mixed, or has already given its boon.
    double boon_in_s{};
    bool boon_open{};  ///< true: the brew has not healed its owner yet, and still can
    /// player whom a well-mixed brew heals now (the boon); no_player: none
    std::uint32_t boon_for{no_player};
    Tick mixed_at{};        ///< time of the fluid state from which `mixed` was computed (ticks of play)
    bool slows{}, lifts{};  ///< whether the brew slows wizards near it, and whether it lifts them
};
void take_cauldron(const Simulation& match, CauldronPicture& out);

}  // namespace thaum::game::inline picture
