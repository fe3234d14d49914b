// game/hud/brew_texels.h: a brew's densities as texels, and its surface as a skin.
#pragma once
#include "game/hud/brew_look.h"

namespace thaum::game {

/// m, brew's frame: where the box of cells begins, which fills the basin's width and stands with its lid on the level.
vec3 corner_of(const BrewPicture& picture, const BrewPlace& place);

/// Numbers of a row of places, by channel or by substance.
using Rows = std::array<std::vector<float>, 3>;

/// The colours of places by what is in them: light of the substances there is added, weighted by density, as bright as the
/// densest of them is alone; what is less than density 1 in all leaves the rest to the base. Red and green in equal
/// parts are yellow. Densities are not below 0; all rows are as long.
void mix(const BrewColours& colours, const Rows& densities, Rows& out);

inline constexpr float brew_brightest = 6;  ///< light of a full texel

/// Resized to the lattice's cells. What stands below the surface moves with it, less the deeper it lies.
void make_texels(const BrewPicture& picture, const BrewPlace& place, std::vector<float>& scratch,
                 std::vector<render::Texel>& out);

/// Rings around the middle; the same triangles whatever the sheet does.
void make_skin_indices(std::vector<std::uint32_t>& out);
/// World frame.
void make_skin(const fluid::Sheet& sheet, const BrewPlace& place, std::vector<render::SkinVertex>& out);

}  // namespace thaum::game
