// game/stations/crystal/crystal.h: the crystals in the match, bodies of voxels that wizards carve and hits
// chip.
//
//     World      Crystal, CrystalDensity, CrystalColour     the state
//     outside    CrystalBodies                              changed bricks (blocks of voxels), ghost keys,
//                                                           voxel counts: made again from the state after a
//                                                           restore
//
// Wizards carve a key from a crystal; the ghost key is its finished shape. A crystal that no one has touched
// has no voxels and costs nothing: its shape is the rough body of its seed (crystal_shape.h). An edit reads
// and writes only the voxels near it, and updates the overlap with the key from those.
#pragma once
#include <optional>
#include <vector>

#include "field/carving.h"
#include "field/placement.h"
#include "field/voxel_overlap.h"
#include "game/components/crystal.h"
#include "game/context/match_context.h"

namespace thaum::game::inline stations {

/// Density at or above which a voxel is solid: the surface that is felt and drawn.
inline constexpr float crystal_surface = 0.5F;

/// Data on a crystal that follows from its state and is cached to save time.
struct CrystalBody {
    field::Bricks bricks = field::make_bricks({crystal_side, crystal_side, crystal_side});
    field::VoxelOverlap overlap{};
    /// density of the key that is to be carved (the ghost key); empty for an untouched crystal
    std::vector<float> key{};
    std::vector<float> old{};  ///< scratch memory for the densities that an edit is about to change
};

/// Cached data of all crystals, indexed by Crystal::number. The simulation owns it.
struct CrystalBodies {
    std::vector<CrystalBody> list{};
};

}  // namespace thaum::game::inline stations

namespace thaum::game::resource {

struct Crystals {
    using Value = CrystalBodies;
    static constexpr std::string_view name = "crystal bodies";
};

}  // namespace thaum::game::resource

namespace thaum::game::inline stations {

using CrystalResource = ecs::Resource<resource::Crystals>;

/// Seeds of the crystals, indexed by their numbers.
using CrystalSeeds = std::vector<std::uint64_t>;

/// Seeds for a new round, which follow those of the present crystals. Empty without crystals.
CrystalSeeds next_seeds(const ecs::World& world);
/// Turns those solids (fixed bodies) of a new round's arena that have the surface "crystal" into untouched
/// crystals. Missing seeds are 0.
void spawn_crystals(MatchContext& context, CrystalBodies& bodies, const CrystalSeeds& seeds);
/// Derives the seeds of the first round's crystals from the match's seed.
void draw_crystals(MatchContext& context, std::uint64_t seed);
/// Rebuilds the cached data of crystals from the World after a restore.
void rebuild_crystals(MatchContext& context, CrystalBodies& bodies);

/// Puts the voxels of an untouched crystal into the World. Writes Crystal, CrystalDensity, CrystalColour and
/// resource::Crystals.
void touch_crystal(MatchContext& context, CrystalBodies& bodies, Crystal& crystal);
/// Replaces a carved crystal by an uncarved one (a rough body) with another key. Writes the same components
/// and resource as touch_crystal.
void renew_crystal(MatchContext& context, CrystalBodies& bodies, Crystal& crystal);
/// Applies a tool to a touched crystal and updates the crystal's overlap with the key. `dab`: one use of the
/// tool, in the crystal frame. Writes the same components and resource as touch_crystal.
field::Edit cut_crystal(MatchContext& context, CrystalBodies& bodies, Crystal& crystal,
                        const field::Tool& tool, const field::Dab& dab);

/// Updates the crystal's overlap with its key after an edit of the voxels in the box `changed`.
void count_again(CrystalBodies& bodies, Crystal& crystal, const field::VoxelView& view,
                 const field::VoxelBox& changed);

/// Placement of the crystal frame in the world.
field::Placement placement_of(const Crystal& crystal);
/// Distance between neighbouring voxels (m).
inline double spacing_of(const Crystal& crystal) { return crystal.size / crystal_side; }
/// Densities of a touched crystal in the crystal frame. The grid points into the World's memory for large
/// data (blob), so it is valid until that is resized.
field::Grid density_grid(const ecs::World& world, const Crystal& crystal, field::Kernel kernel);
/// Voxels of a touched crystal.
field::VoxelView voxels_of(ecs::World& world, CrystalBodies& bodies, const Crystal& crystal);

/// Point (crystal frame) where a ray enters the surface that the picture shows, interpolated between voxels
/// like the picture (trilinear). `way` need not be a unit vector. std::nullopt if the ray misses. The crystal
/// must be touched.
std::optional<vec3> surface_along(const ecs::World& world, const Crystal& crystal, vec3 from, vec3 way);

/// The crystal with this number; an invalid entity if there is none.
ecs::Entity crystal_entity(const ecs::World& world, std::uint32_t number);

}  // namespace thaum::game::inline stations
