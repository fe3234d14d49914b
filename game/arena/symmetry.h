// game/arena/symmetry.h: entries of an arena's file that are placed twice, so that the arena is fair to both
// players.
#pragma once
#include "core/config.h"

namespace thaum::game::inline arena {

/// How an entry of an arena's file is placed a second time. none: not at all; mirror: as its mirror image at
/// -z; turned: turned by 180 degrees about the vertical axis through the origin.
enum class Symmetry : std::uint8_t { none, mirror, turned };

/// Reads the keys `mirror` and `turned` of an entry in an arena's file. Both true is an error.
Symmetry read_symmetry(const ConfigTable& table);

/// Position of the second copy of a thing at `place` (m, world).
vec3 twin_place(Symmetry symmetry, vec3 place);

}  // namespace thaum::game::inline arena
