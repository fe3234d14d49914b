// game/arena/placement.h: checks that nothing in an arena's file is placed inside of a solid: neither props
// nor the places where wizards appear.
#pragma once
#include "game/arena/arena.h"

namespace thaum::game::inline arena {

/// Reports every prop (loose thing), pad (place where a wizard starts) and place of the practice range that
/// lies inside of a solid. Also reports every place where a wizard appears without ground below. `root`: the
/// root table of the arena's file.
void check_placement(const ConfigTable& root, const Arena& arena);

}  // namespace thaum::game::inline arena
