// game/stations/cauldron/splash.h: loose things that fall into the brew, and lobs (thrown stones that
// explode) that burst over it. The brew loses whatever momentum it gives to a thing.
#pragma once
#include "game/stations/cauldron/cauldron.h"

namespace thaum::game::inline stations {

/// Adds the system that applies drag and buoyancy to things in the brew, and the opposite impulses to the
/// brew, every 4 ticks.
void add_splash_system(MatchContext& context, BrewResource& brew, ecs::Schedule& schedule);

}  // namespace thaum::game::inline stations
