// game/arena/placement.h: whether the places of an arena's file are free: for its props, and for wizards who appear.
#pragma once
#include "game/arena/arena.h"

namespace thaum::game {

/// Reports a prop, a pad and a place of practice that lie inside of a solid, and those of wizards that have no ground below
/// them. `root` is that of the arena's file.
void check_placement(const ConfigTable& root, const Arena& arena);

}  // namespace thaum::game
