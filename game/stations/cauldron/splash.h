// game/stations/cauldron/splash.h: loose things that fall into the brew, and lobs that burst over it.
// Whatever momentum the brew gives a thing, the brew loses.
#pragma once
#include "game/stations/cauldron/cauldron.h"

namespace thaum::game::inline stations {

/// Adds the system that applies drag and buoyancy to things in the brew, and the opposite momentum to the
/// brew, every 4 ticks.
void add_splash_system(MatchContext& context, BrewResource& brew, ecs::Schedule& schedule);

}  // namespace thaum::game::inline stations
