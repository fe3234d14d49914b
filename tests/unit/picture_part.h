// tests/unit/picture_part.h: cuts one view out of a picture that shows several.
#pragma once
#include "render/image.h"
#include "render/scene.h"

namespace thaum::render {

/// Pixels of `view`, which must lie within the picture.
inline Image part_of(const Image& image, const Rect& view) {
    Image part{view.width, view.height, {}};
    for (int y = 0; y < view.height; ++y) {
        const auto from = image.rgb.begin() + 3 * ((view.y + y) * image.width + view.x);
        part.rgb.insert(part.rgb.end(), from, from + 3 * view.width);
    }
    return part;
}

}  // namespace thaum::render
