// game/stations/crystal/chips.h: hits melt a small ball of a crystal away (MANUAL.md, "The crystal"). A shot melts where its way meets
// the surface that everybody sees, and nothing if it flies past. A burst or a thing melts at the nearest voxel.
#pragma once
#include "game/stations/crystal/crystal.h"

namespace thaum::game {

/// Adds the system that chips crystals for the strikes of this tick (context/strikes.h). It runs only if there are any.
void add_chip_system(MatchContext& context, CrystalResource& crystals, ecs::Schedule& schedule);

}  // namespace thaum::game
