// game/hud/wand_icon.h: flat pictures of wands, drawn from the same parts as their meshes.
#pragma once
#include "game/data/presentation.h"
#include "render/scene.h"

namespace thaum::game {

/// Adds the outline of a wand, from its handle at the lower left to its tip at the upper right. `size` is the
/// edge of the square that holds it (px).
void add_wand_icon(render::Overlay& out, const WandLook& look, fvec2 middle, float size, fvec4 paint);

/// Adds a row of the icons of all wands in the order of their slots, with the numbers of their keys. The row
/// ends at its lower right corner.
void add_wand_strip(render::Overlay& out, const std::vector<WandPresentation>& wands, std::uint32_t in_hand,
                    fvec2 lower_right, float unit);

}  // namespace thaum::game
