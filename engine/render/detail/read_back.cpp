#include "render/detail/read_back.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "render/detail/gl.h"

namespace thaum::render::detail {
namespace {

// Number of rows that are read at once. They are few, so that packing finds them in the cache.
constexpr int rows_at_once = 32;

/// Converts blue, green, red and an unused byte to red, green, blue. Four pixels at a time are written as 16
/// bytes, of which the last four are none of the picture's. This is done only where later pixels overwrite
/// those four.
void pack_rgb(std::span<const std::uint32_t> pixels, std::uint8_t* to) {
    using Four [[gnu::vector_size(16)]] = std::uint8_t;
    std::size_t i = 0;
    for (; i + 6 <= pixels.size(); i += 4, to += 12) {
        Four four{};
        std::memcpy(&four, &pixels[i], 16);
        four = __builtin_shufflevector(four, four, 2, 1, 0, 6, 5, 4, 10, 9, 8, 14, 13, 12, 3, 7, 11, 15);
        std::memcpy(to, &four, 16);
    }
    for (; i < pixels.size(); ++i) {
        for (const unsigned shift : {16U, 8U, 0U}) *to++ = static_cast<std::uint8_t>(pixels[i] >> shift);
    }
}

}  // namespace

Image read_back(int picture_width, int picture_height) {
    Image image{std::max(picture_width, 0), std::max(picture_height, 0), {}};
    const auto width = static_cast<std::size_t>(image.width), row = 3 * width;
    if (width == 0 || image.height == 0) return image;
    image.rgb.reserve(row * static_cast<std::size_t>(image.height));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    // Pixels are read in the rasteriser's own format, which it only has to copy. Reading three bytes for each
    // pixel took four times as long.
    std::vector<std::uint32_t> band(width * rows_at_once);
    std::vector<std::uint8_t> packed(row);
    // OpenGL counts rows from the bottom, an Image from the top.
    for (int above = image.height; above > 0; above -= rows_at_once) {
        const int rows = std::min(rows_at_once, above);
        glReadPixels(0, above - rows, image.width, rows, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, band.data());
        for (int i = rows; i-- > 0;) {
            pack_rgb({&band[static_cast<std::size_t>(i) * width], width}, packed.data());
            image.rgb.insert(image.rgb.end(), packed.begin(), packed.end());
        }
    }
    return image;
}

std::vector<float> read_depths_of(const Framebuffer& from, int width, int height) {
    std::vector<float> depths(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from.get());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    return depths;
}

}  // namespace thaum::render::detail
