// The first use of every shader, before anybody waits for a picture.
#pragma once
#include "render/renderer.h"

namespace thaum::render::detail {

/// Uses every shader once, into every kind of framebuffer. Drivers compile a shader at its first use, which took a software rasteriser
/// 20 to 260 ms each.
void warm_up(Renderer& renderer);

}  // namespace thaum::render::detail
