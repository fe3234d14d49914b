// Reads the drawn picture.
#pragma once
#include "render/image.h"

namespace thaum::render::detail {

/// Pixels of the context's framebuffer, from its lower left corner on. An empty picture if the size is not
/// positive.
Image read_back(int width, int height);

}  // namespace thaum::render::detail
