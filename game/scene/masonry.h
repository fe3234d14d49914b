// game/scene/masonry.h: walls of slate and worn brick with baked light. Bevelled blocks in running bond cover
// each face of a large box, each block in its own shade.
#pragma once
#include "game/scene/baked_light.h"

namespace thaum::game::inline scene {

// The functions below make fixed stone in the world frame and append it to `out`. A render::Patch is one
// block or one piece of decoration.

/// Adds a box of masonry, with the light baked at its position. Faces that no player can see are left out.
void add_masonry_box(const Shade& shade, const Thing& thing, render::Patchwork& out);

/// Adds the slope of a ramp, and its three vertical faces.
void add_masonry_ramp(const Shade& shade, const Thing& thing, const physics::TriangleMesh& solid,
                      render::Patchwork& out);

/// Bakes the light of a patch (one block or piece of decoration) at its position and adds the patch.
void add_lit_patch(const Shade& shade, vec3 position, render::Patch patch, render::Patchwork& out);

}  // namespace thaum::game::inline scene
