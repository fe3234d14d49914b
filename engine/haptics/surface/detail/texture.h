// haptics/surface/detail/texture.h: greatest height of a texture.
#pragma once
#include "haptics/surface/surface.h"

namespace thaum::haptics {

/// Greatest height of a texture (m); 0 without texture.
inline double top_of(const Texture& texture) {
    return texture.kind != TextureKind::none && texture.amplitude > 0 && texture.wavelength > 0
               ? 2 * texture.amplitude
               : 0;
}

}  // namespace thaum::haptics
