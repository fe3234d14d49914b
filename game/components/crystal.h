// game/components/crystal.h: crystals, the wizards who carve them, and the rewards for carving the key. A
// match without a crystal has none of these components.
#pragma once
#include <array>

#include "core/units.h"
#include "ecs/component.h"
#include "game/components/match.h"
#include "game/components/wizard.h"

namespace thaum::game::inline components {

/// A crystal of crystal_side^3 voxels. Its frame has its origin at `middle` and is turned about the vertical
/// axis by `yaw`, which its carvers change.
struct Crystal {
    vec3 middle{};         ///< middle of the crystal (m, world)
    double yaw{};          ///< angle by which the crystal is turned about the vertical axis (rad)
    double turned{};       ///< angle by which carvers have turned the crystal in this tick (rad)
    double size{};         ///< length of the crystal's edges (m)
    std::uint64_t seed{};  ///< seed of the initial rough body and of the key, the shape to be carved
    /// Overlap of the body and the key (the shape to be carved), 0 to 1 (intersection over union); 0 while
    /// untouched.
    double overlap{};
    std::uint32_t number{};  ///< index of the crystal's voxels in the arrays (blobs) CrystalDensity and
                             ///< CrystalColour
    /// 1: the crystal's voxels are stored in the arrays CrystalDensity and CrystalColour; 0: they are not,
    /// because the crystal is still the rough body of its seed.
    std::uint32_t touched{};
    Tick chipped{};                   ///< when a hit last chipped the crystal (ticks of play); 0: never
    std::uint32_t carver{no_player};  ///< player who last used a tool on the crystal; no_player: nobody yet
    std::uint32_t edits{};            ///< number of changes of the crystal's voxels so far
    THAUM_COMPONENT(Crystal, middle, yaw, turned, size, seed, overlap, number, touched, chipped, carver,
                    edits);
};

inline constexpr int crystal_side = 48;  ///< number of voxels along each edge of a crystal
inline constexpr std::size_t crystal_voxels = std::size_t{crystal_side} * crystal_side * crystal_side;

/// Array in the World (blob) with the densities of all crystals, one after another (0: nothing, 1: solid). It
/// is empty until a crystal is first touched or hit.
struct CrystalDensity {
    using Element = float;
    static constexpr std::string_view name = "CrystalDensity";
};

/// Array in the World (blob) with the colours of all crystals, in the order of CrystalDensity: red, green,
/// blue of each voxel, one after another (field::Rgb8).
struct CrystalColour {
    using Element = std::uint8_t;
    static constexpr std::string_view name = "CrystalColour";
};

/// State of a wizard who carves by holding the Stir button at a crystal. AtStation::number is the crystal's
/// number.
struct Chisel {
    vec3 place{};             ///< position of the tool (m, world)
    vec3 force{};             ///< force of the crystal on the hand (N, device frame turned to the world)
    vec3 last{};              ///< place of the tool when it last acted (m, crystal's frame)
    std::uint32_t cutting{};  ///< 1: the tool acts on the crystal
    std::uint32_t blunt{};    ///< 1: the player holds fire without focus (what tools cost), and was told so
    THAUM_COMPONENT(Chisel, place, force, last, cutting, blunt);
};

/// A hit on a crystal in this tick, an entity of its own.
struct CrystalStrike {
    ecs::Entity crystal{};
    vec3 place{};  ///< position of the hit (m, world)
    vec3 way{};    ///< direction of flight (world); zero: unknown, so the nearest voxel is hit
    std::uint32_t player{no_player};  ///< player who fired the shot or threw the thing that hit
    std::uint32_t spare{};
    THAUM_COMPONENT(CrystalStrike, crystal, place, way, player, spare);
};

/// A wizard's tool for crystals, and the Lens that a carved key gives.
struct Lens {
    std::uint32_t held{};  ///< 1: the wizard holds the Lens, the reward for carving the key, until death
    std::uint32_t tool{};  ///< number of the tool that the wizard carves with
    THAUM_COMPONENT(Lens, held, tool);
};

/// The Great Work, which wins a round: to hold both its halves, the potion Azoth and the Lens, for some time.
/// `since` is, for each player, when that player began to hold both (ticks of play); 0: does not hold both.
struct GreatWork {
    std::array<Tick, players> since{};
    THAUM_COMPONENT(GreatWork, since);
};

}  // namespace thaum::game::inline components
