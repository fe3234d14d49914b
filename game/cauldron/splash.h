// game/cauldron/splash.h: loose things that fall into the brew, and lobs that burst over it. What the brew takes from a thing it has.
#pragma once
#include "game/cauldron/cauldron.h"

namespace thaum::game {

/// Every 4 ticks: drag and lift on what is in the brew, the opposite to it; the surface's own push on the first two.
void add_splash_system(Stage& stage, ecs::Schedule& schedule);

}  // namespace thaum::game
