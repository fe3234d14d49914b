// fluid/ghosts.h: values of the three layers of ghost cells beyond the sides of a lattice (lattice.h).
#pragma once
#include "fluid/rows.h"

namespace thaum::fluid {

/// How a quantity continues beyond a wall across one axis, into the ghost cells.
enum class GhostRule : std::uint8_t {
    even,  ///< the quantity is sampled at cell centres along this axis, and mirrored
    /// The quantity is sampled at cell centres along this axis, and mirrored with the opposite sign: zero on
    /// the wall.
    odd,
    /// The quantity is sampled on the faces across this axis: zero on both walls, and mirrored with the
    /// opposite sign beyond them.
    through_wall,
};

inline constexpr std::array all_even{GhostRule::even, GhostRule::even, GhostRule::even};

/// Writes the values of ghost cells (the cells around the lattice). `rule` is used only at walls. The
/// `_across` version fills only the ghosts beyond the two sides across one axis, without the corners.
void fill_ghosts_across(const Lattice& lattice, std::size_t axis, GhostRule rule, Samples& samples);
/// Writes all ghosts of a box, corners included.
void fill_ghosts(const Lattice& lattice, const std::array<GhostRule, 3>& rule, Samples& samples);
/// Fills ghost cells for samples that are used only in `rows`, the parts of a lattice with fluid, `depth`
/// layers deep across one axis. Outside the rows the samples must always have been 0, or are never read.
void fill_ghosts_across(const Rows& rows, std::size_t axis, GhostRule rule, Samples& samples,
                        int depth = ghosts);
/// Writes all ghost cells beside the rows with fluid, `depth` layers deep.
void fill_ghosts(const Rows& rows, const std::array<GhostRule, 3>& rule, Samples& samples,
                 int depth = ghosts);
/// Fills only those ghost cells that copy the given layers. If threads fill different layers at the same
/// time, no ghost is written twice. Before ghosts across z are filled, those across x and y of the same
/// layers must be: `fill_ghosts` does that.
void fill_ghosts_across(const Rows& rows, Layers layers, std::size_t axis, GhostRule rule, Samples& samples,
                        int depth = ghosts);
void fill_ghosts(const Rows& rows, Layers layers, const std::array<GhostRule, 3>& rule, Samples& samples,
                 int depth = ghosts);

/// How component `axis` of a velocity continues beyond the sides of the box across x, y and z.
std::array<GhostRule, 3> ghost_rules_of_velocity(const Lattice& lattice, std::size_t axis);

}  // namespace thaum::fluid
