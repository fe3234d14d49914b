// fluid/ghosts.h: what stands beyond the sides of a lattice, three cells deep (lattice.h).
#pragma once
#include "fluid/rows.h"

namespace thaum::fluid {

/// How a quantity goes on beyond a wall across one axis.
enum class GhostRule : std::uint8_t {
    even,          ///< cell-centred across this axis, mirrored
    odd,           ///< cell-centred across this axis, mirrored with the other sign: zero on the wall
    through_wall,  ///< stands on the faces across this axis: zero on both walls, which it sets, odd beyond
};

inline constexpr std::array all_even{GhostRule::even, GhostRule::even, GhostRule::even};

/// Writes the ghosts; `beyond` counts at walls only. `across`: those beyond the sides across one axis, rows without corners.
void fill_ghosts_across(const Lattice& lattice, std::size_t axis, GhostRule rule, Samples& samples);
void fill_ghosts(const Lattice& lattice, const std::array<GhostRule, 3>& rule, Samples& samples);
/// The same, `depth` cells deep, of samples that outside the rows are 0, and were from the first on, or not read.
void fill_ghosts_across(const Rows& rows, std::size_t axis, GhostRule rule, Samples& samples,
                        int depth = ghosts);
void fill_ghosts(const Rows& rows, const std::array<GhostRule, 3>& rule, Samples& samples,
                 int depth = ghosts);

/// Of component `axis` of the velocity.
std::array<GhostRule, 3> ghost_rules_of_velocity(const Lattice& lattice, std::size_t axis);

}  // namespace thaum::fluid
