// Reads the drawn picture, and its depths.
#pragma once
#include <vector>

#include "render/detail/gl.h"
#include "render/image.h"

namespace thaum::render::detail {

/// Pixels of the context's framebuffer, from its lower left corner on. An empty picture if the size is not
/// positive.
Image read_back(int width, int height);

/// Depths (0 to 1) of a framebuffer of this size, row by row from below.
std::vector<float> read_depths_of(const Framebuffer& from, int width, int height);

}  // namespace thaum::render::detail
