// game/stations/crystal/chips.h: hits melt a small ball of a crystal away (MANUAL.md, "The crystal"). A shot
// melts voxels where its path meets the visible surface, and none if it flies past. A burst or a thing melts
// the voxels around the voxel that is nearest to it.
#pragma once
#include "game/stations/crystal/crystal.h"

namespace thaum::game::inline stations {

/// Adds the system that chips crystals for the hits of this tick (context/strikes.h). It runs only if there
/// are any.
void add_chip_system(MatchContext& context, CrystalResource& crystals, ecs::Schedule& schedule);

}  // namespace thaum::game::inline stations
