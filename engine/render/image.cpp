#include "render/image.h"

#include "core/assert.h"
#include "core/bytes.h"
#include "core/file.h"
#include "core/text.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace thaum::render {
namespace {

void append_bytes(void* to, void* data, int size) {
    const auto* first = static_cast<const std::byte*>(data);
    auto& bytes = *static_cast<Bytes*>(to);
    bytes.insert(bytes.end(), first, first + size);
}

}  // namespace

Expected<void> write_png(const std::filesystem::path& path, const Image& image) {
    THAUM_ASSERT(image.rgb.size() ==
                     3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height),
                 "an image's bytes must fit its size");
    if (image.width <= 0 || image.height <= 0) return fail(text(path.string(), ": an empty picture"));
    Bytes bytes;
    const int stride = 3 * image.width;
    if (stbi_write_png_to_func(append_bytes, &bytes, image.width, image.height, 3, image.rgb.data(),
                               stride) == 0) {
        return fail(text(path.string(), ": the picture cannot be packed as PNG"));
    }
    return write_file(path, bytes);
}

}  // namespace thaum::render
