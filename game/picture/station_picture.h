// game/picture/station_picture.h: one moment of the orb and the crystals of a match as plain data, for drawing
// (game/scene/orb_look.h, game/scene/crystal_look.h) and for the card of a wizard who works there (station_card.h).
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

namespace thaum::game {

class Simulation;

/// A probe in the orb or a tool in a crystal, which the hand of a wizard moves.
struct TipPicture {
    vec3 place{};          ///< middle of the tip (m, world)
    vec3 force{};          ///< force on the hand, turned to the world (N)
    double force_share{};  ///< that force as a share of the player's limit, 0 to 1
    double radius{};       ///< reach of a carving tool (m); 0: a probe
    bool works{};          ///< the tool is applied
    DabWorth worth{};      ///< effect of a carving tool at this place
};

/// The orb of a match: a ball with a flow inside.
struct OrbPicture {
    bool there{};
    vec3 middle{};  ///< (m, world)
    double radius{};
    std::uint64_t seed{};  ///< seed of the flow (field::make_vortex_flow)
    std::array<std::optional<TipPicture>, players> probes{};
    std::array<bool, players> found{};  ///< players to whom the core was shown
};

/// Points at which a strength is plotted.
inline constexpr std::size_t curve_points = 33;

/// Search of a wizard at the orb, for the card.
struct ScryingPicture {
    bool near{};                                           ///< the wizard can begin
    bool misses{};                                         ///< presses Stir a few steps away from it
    bool faces{};                                          ///< looks towards it, or scries
    bool scries{};                                         ///< the wizard holds the probe
    std::array<std::string_view, most_orb_modes> modes{};  ///< names of all modes, by key; empty: none
    std::array<bool, most_orb_modes> worn{};               ///< modes that are worn
    std::uint32_t newest{no_mode};                         ///< mode whose strength Trace draws; no_mode: none
    bool draws{};                                          ///< Trace draws that strength
    /// Strength of the newest mode as a share of the sheet's height, at even distances over the sheet.
    std::array<float, curve_points> curve{};
    double held_s{}, wanted_s{};              ///< time at the core so far, and the time that is wanted
    bool core_near{};                         ///< the probe is within reach of the core
    bool told{};                              ///< the orb has told all that it tells in this life
    std::array<std::string_view, 3> order{};  ///< ingredients in the player's own order; empty: not told
    std::string_view potion{};                ///< potion with that order
};

/// Voxels of a crystal that has been touched, as they were at one moment. They never change, so pictures share them.
struct CrystalVoxels {
    std::vector<float> density{};
    std::vector<field::Rgb8> colour{};
};

/// A crystal and the key that its wizards carve.
struct CrystalPicture {
    vec3 middle{};         ///< (m, world)
    double yaw{};          ///< turn of its frame about the vertical axis (rad)
    double edge{};         ///< length of the cube's edge (m)
    std::uint64_t seed{};  ///< seed of the rough body and of the key
    /// Null until a wizard or a shot has touched the crystal.
    std::shared_ptr<const CrystalVoxels> voxels{};
};

/// Work of a wizard at a crystal, for the card.
struct CarvingPicture {
    bool near{};              ///< the wizard can begin
    bool misses{};            ///< presses Stir a few steps away from a crystal
    bool faces{};             ///< looks towards the near one, or carves
    bool carves{};            ///< the wizard holds a tool
    std::uint32_t crystal{};  ///< index in Picture::crystals of the crystal at which the wizard carves
    TipPicture tip{};         ///< that tool
    /// Names of all tools, by key; empty: none.
    std::array<std::string_view, wand_slots> tools{};
    std::uint32_t tool{};  ///< index of the tool in hand
    double overlap{};      ///< overlap of crystal and key, 0 to 1; 0: nobody has touched the crystal
    double wanted{};       ///< overlap that gives the Lens
};

/// The Lens and the Great Work of a wizard.
struct WorkPicture {
    bool lens{};       ///< the wizard holds the Lens
    double left_s{};   ///< time until the Great Work is done; 0: the wizard does not hold it
    double whole_s{};  ///< time for which it must be held
};

/// Distance from the place where work at a station begins, up to which a press of Stir is meant for it (m).
inline constexpr double missed_station_m = 4;

bool presses_stir(const ecs::World& world, ecs::Entity wizard);

void take_orb(const Simulation& match, OrbPicture& out);
/// Takes the crystals in the order of the arena's solids. Copies voxels only of a crystal that has changed.
void take_crystals(const Simulation& match, std::vector<CrystalPicture>& out);
/// Take what a living wizard does at the orb and at a crystal, and what the wizard holds of the Great Work.
void take_scrying(const Simulation& match, ecs::Entity wizard, std::uint32_t player, ScryingPicture& out);
void take_carving(const Simulation& match, ecs::Entity wizard, std::uint32_t player, CarvingPicture& out);
void take_work(const Simulation& match, ecs::Entity wizard, std::uint32_t player, WorkPicture& out);

}  // namespace thaum::game
