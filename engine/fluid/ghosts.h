// fluid/ghosts.h: values of the three layers of ghost cells beyond the sides of a lattice (lattice.h).
#pragma once
#include "fluid/rows.h"

namespace thaum::fluid {

/// Continuation of a quantity beyond a wall across one axis.
enum class GhostRule : std::uint8_t {
    even,  ///< the quantity is sampled at cell centres along this axis, and mirrored
    /// The quantity is sampled at cell centres along this axis, and mirrored with the opposite sign: zero on
    /// the wall.
    odd,
    /// The quantity is sampled on the faces across this axis: zero on both walls, and odd beyond them.
    through_wall,
};

inline constexpr std::array all_even{GhostRule::even, GhostRule::even, GhostRule::even};

/// Writes the values of ghost cells; `rule` is used only at walls. The `_across` version fills only the
/// ghosts beyond the two sides across one axis, without the corners.
void fill_ghosts_across(const Lattice& lattice, std::size_t axis, GhostRule rule, Samples& samples);
/// Writes all ghosts of a box, corners included.
void fill_ghosts(const Lattice& lattice, const std::array<GhostRule, 3>& rule, Samples& samples);
/// Like the functions above, for samples that exist only in `rows`, `depth` layers deep. Outside the rows the
/// samples must always have been 0, or are never read.
void fill_ghosts_across(const Rows& rows, std::size_t axis, GhostRule rule, Samples& samples,
                        int depth = ghosts);
/// Writes all ghosts of the rows, `depth` layers deep.
void fill_ghosts(const Rows& rows, const std::array<GhostRule, 3>& rule, Samples& samples,
                 int depth = ghosts);

/// The rules for component `axis` of a velocity.
std::array<GhostRule, 3> ghost_rules_of_velocity(const Lattice& lattice, std::size_t axis);

}  // namespace thaum::fluid
