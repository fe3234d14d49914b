// game/picture/station_picture.h: one moment of the orb and the crystals of a match as plain data, for
// drawing (game/scene/orb_look.h, game/scene/crystal_look.h) and for the card, a panel for a wizard who works
// there (station_card.h).
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "ecs/world.h"
#include "field/voxels.h"
#include "game/components/match.h"
#include "game/components/orb.h"
#include "game/components/wizard.h"
#include "game/stations/crystal/grain.h"

namespace thaum::game::inline match {
class Simulation;
}

namespace thaum::game::inline picture {

/// A probe in the orb or a tool in a crystal, which the hand of a wizard moves.
struct TipPicture {
    vec3 place{};          ///< middle of the tip (m, world)
    vec3 force{};          ///< force on the hand, rotated to world axes (N)
    double force_share{};  ///< force on the hand as a share of the player's limit, 0 to 1
    double radius{};       ///< radius of a carving tool's effect (m); 0: a probe
    bool works{};          ///< true: the tool is in use
    DabWorth worth{};      ///< whether a carving tool, used at this place, would help or spoil the key
};

/// The orb of a match: a ball with a flow inside.
struct OrbPicture {
    bool there{};
    vec3 middle{};  ///< middle of the orb (m, world)
    double radius{};
    std::uint64_t seed{};  ///< seed from which the orb's flow is made (field::make_vortex_flow)
    std::array<std::optional<TipPicture>, players> probes{};
    /// for each player, true if that player was shown the hidden core, the axis of the strongest vortex
    std::array<bool, players> found{};
};

/// Number of points at which a strength curve is plotted: the strength of a haptic mode, a way to feel the
/// flow, as a function of the property of the flow that the mode reads.
inline constexpr std::size_t curve_points = 33;

/// State of a wizard at the orb, for the panel with help that the view shows there (the card).
struct ScryingPicture {
    bool near{};    ///< true: the wizard is near enough to the orb to begin to scry
    bool misses{};  ///< true: the player presses the button Stir a few steps too far away from the orb
    bool faces{};   ///< true: the wizard looks towards the orb, or scries
    bool scries{};  ///< true: the wizard holds the probe, the tip in the orb that the hand moves
    /// Names of all haptic modes (ways in which the flow can be felt), by the key that chooses them; empty:
    /// none.
    std::array<std::string_view, max_orb_modes> modes{};
    std::array<bool, max_orb_modes> worn{};  ///< for each haptic mode, true if it is switched on
    std::uint32_t newest{no_mode};  ///< haptic mode switched on last, whose strength the player can draw;
                                    ///< no_mode: none
    bool draws{};  ///< true: the player draws the strength of the newest haptic mode with the button Trace
    /// Curve that the player draws: upwards the strength of the haptic mode `newest`, from 0 to 1; to the
    /// right, at equal distances, the property of the flow that the mode reads, such as speed.
    std::array<float, curve_points> curve{};
    /// time that the probe has been held at the hidden core so far, and required time (s)
    double held_s{}, wanted_s{};
    /// true: the probe is near enough to the hidden core, the axis of the strongest vortex
    bool core_near{};
    bool told{};  ///< true: the orb has already given its reward in this life
    /// Ingredients in the secret order of this player's recipe; empty: the order is not revealed.
    std::array<std::string_view, 3> order{};
    std::string_view potion{};  ///< name of the potion whose recipe has the order in `order`
};

/// Voxels of a touched crystal at one moment. They never change, so pictures share them.
struct CrystalVoxels {
    std::vector<float> density{};
    std::vector<field::Rgb8> colour{};
};

/// A crystal, from which wizards carve the shape of a key.
struct CrystalPicture {
    vec3 middle{};         ///< middle of the crystal (m, world)
    double yaw{};          ///< rotation of its frame about the vertical axis (rad)
    double edge{};         ///< length of the crystal's edges (m)
    std::uint64_t seed{};  ///< seed of the crystal's uncarved shape and of the key's shape
    /// Voxels of the crystal; null until a wizard or a shot has touched it.
    std::shared_ptr<const CrystalVoxels> voxels{};
};

/// State of a wizard at a crystal, for the panel with help that the view shows there (the card).
struct CarvingPicture {
    bool near{};    ///< true: the wizard is near enough to a crystal to begin to carve
    bool misses{};  ///< true: the player presses the button Stir a few steps too far away from a crystal
    bool faces{};   ///< true: the wizard looks towards the crystal nearby, or carves
    bool carves{};  ///< true: the wizard holds a tool
    std::uint32_t crystal{};  ///< index in Picture::crystals of the crystal that the wizard carves
    TipPicture tip{};         ///< tip of the tool that the wizard holds
    /// Names of all tools, by the key that chooses them; empty: none.
    std::array<std::string_view, wand_slots> tools{};
    std::uint32_t tool{};  ///< index of the chosen tool
    /// share of matter that the crystal and the key to be carved have in common, 0 to 1; 0: the crystal is
    /// untouched
    double overlap{};
    double wanted{};  ///< value of `overlap` at which the wizard gains the Lens, one half of the Great Work
};

/// Progress of a wizard's Great Work, whose two halves are Azoth (a potion) and the Lens (from a crystal).
struct WorkPicture {
    bool lens{};  ///< true: the wizard holds the Lens
    /// Time until the Great Work is completed (s); 0: the wizard does not hold both Azoth and the Lens.
    double left_s{};
    double whole_s{};  ///< time for which the wizard must hold both Azoth and the Lens (s)
};

/// Maximum distance from the area where work at a station (cauldron, orb or crystal) can begin, at which a
/// press of the button Stir still counts as a failed attempt (m).
inline constexpr double missed_station_m = 4;

bool presses_stir(const ecs::World& world, ecs::Entity wizard);

void take_orb(const Simulation& match, OrbPicture& out);
/// Copies the crystals in the order of the arena's solids. Voxels are copied only for a crystal that has
/// changed.
void take_crystals(const Simulation& match, std::vector<CrystalPicture>& out);
/// The next three functions copy a living wizard's state at the orb, that at a crystal, and the held parts of
/// the Great Work.
void take_scrying(const Simulation& match, ecs::Entity wizard, std::uint32_t player, ScryingPicture& out);
void take_carving(const Simulation& match, ecs::Entity wizard, std::uint32_t player, CarvingPicture& out);
void take_work(const Simulation& match, ecs::Entity wizard, std::uint32_t player, WorkPicture& out);

}  // namespace thaum::game::inline picture
