// Uses the shaders of a quality once, before a match needs them.
#pragma once
#include "render/renderer.h"

namespace thaum::render::detail {

/// Draws one picture of each kind that this quality has. Drivers compile a shader at its first use, which
/// took a software rasteriser 20 to 260 ms each.
void warm_up(Renderer& renderer, Quality quality);

}  // namespace thaum::render::detail
