// game/scene/decoration.h: decoration of an arena that its file asks for: merlons (the teeth of a
// battlement), pilasters and banners of the four outer walls, lamps, and towers outside. All meshes are in
// the world frame.
#pragma once
#include "game/scene/baked_light.h"

namespace thaum::game::inline scene {

/// Adds merlons on the walls, pilasters and banners to `out`.
void add_decoration(const Shade& shade, const ArenaLook& look, render::Patchwork& out);

/// The towers outside the arena. They are too far away to cast a shadow into it.
render::Patchwork skyline(const ArenaLook& look);
/// The self-lit parts of the lamps and the towers.
render::Patchwork lamps(const Shade& shade, const ArenaLook& look);

}  // namespace thaum::game::inline scene
