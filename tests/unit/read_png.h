// tests/unit/read_png.h: reads pictures from files.
#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "render/image.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace thaum::render {

/// Reads a picture; std::nullopt if the file is not a picture.
inline std::optional<Image> read_png(const std::filesystem::path& path) {
    int w = 0, h = 0, channels = 0;
    stbi_uc* read = stbi_load(path.c_str(), &w, &h, &channels, 3);
    if (read == nullptr) return {};
    Image image{w, h, std::vector<std::uint8_t>(read, read + 3 * w * h)};
    stbi_image_free(read);
    return image;
}

}  // namespace thaum::render
