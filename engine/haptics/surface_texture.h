// haptics/surface_texture.h: how high a texture rises above its surface.
#pragma once
#include "haptics/surface.h"

namespace thaum::haptics {

/// Greatest height of a texture (m); 0 where there is none.
double top_of(const Texture& texture);

}  // namespace thaum::haptics
