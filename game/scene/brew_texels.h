// game/scene/brew_texels.h: converts the densities of a brew to texels, and its surface to a mesh (the skin).
#pragma once
#include "game/scene/brew_look.h"

namespace thaum::game::inline scene {

/// Origin of the box of cells (m, brew's frame). The box fills the basin's width, and its top is at the level
/// of the brew.
vec3 corner_of(const BrewPicture& picture, const BrewPlace& place);

/// One row of numbers for each channel or substance.
using Rows = std::array<std::vector<float>, 3>;

/// Computes colours from densities. The light of the substances is added, weighted by density, and scaled to
/// the brightness of the densest substance alone. If the densities add up to less than 1, the base colour has
/// the remaining weight. Red and green in equal parts give yellow. Densities must not be negative, and all
/// rows must be equally long.
void mix(const BrewColours& colours, const Rows& densities, Rows& out);

inline constexpr float brew_brightest = 6;  ///< linear light of a texel with the largest value

/// Fills the texels that show the brew, one for each cell of the fluid's lattice. Where the surface stands
/// higher or lower, the contents below it are displaced, too, but less at greater depth.
void make_texels(const BrewPicture& picture, const BrewPlace& place, std::vector<float>& scratch,
                 std::vector<render::Texel>& out);

/// Triangles of the skin, the mesh of the brew's surface, in rings around the middle. They are the same for
/// every state of the surface.
void make_skin_indices(std::vector<std::uint32_t>& out);
/// Vertices of the skin, the mesh of the brew's surface (m, world).
void make_skin(const fluid::SpringSurface& surface, const BrewPlace& place,
               std::vector<render::SkinVertex>& out);

}  // namespace thaum::game::inline scene
