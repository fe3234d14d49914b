// The part of a view that a box may cover. No OpenGL.
#pragma once
#include "render/scene.h"

namespace thaum::render::detail {

/// Pixels of `view` that a box may cover, with one more pixel on each side. `to_clip` maps the frame of the
/// box to clip space. Returns the whole view if part of the box is behind the eye.
Rect screen_part(fvec3 low, fvec3 high, const fmat4& to_clip, const Rect& view);

}  // namespace thaum::render::detail
