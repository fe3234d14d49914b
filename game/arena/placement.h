// game/arena/placement.h: checks that the positions in an arena's file are free: those of props, and those
// where wizards appear.
#pragma once
#include "game/arena/arena.h"

namespace thaum::game::inline arena {

/// Reports every prop, pad and practice place that lies inside of a solid, and every place of a wizard
/// without ground below. `root`: the root table of the arena's file.
void check_placement(const ConfigTable& root, const Arena& arena);

}  // namespace thaum::game::inline arena
