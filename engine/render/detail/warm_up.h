// Uses every shader once, before the first picture is needed.
#pragma once
#include "render/renderer.h"

namespace thaum::render::detail {

/// Uses every shader once, with every kind of framebuffer. Drivers compile a shader at its first use, which
/// took a software rasteriser 20 to 260 ms each.
void warm_up(Renderer& renderer);

}  // namespace thaum::render::detail
