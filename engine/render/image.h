// render/image.h: pictures in memory and as PNG files.
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/error.h"

namespace thaum::render {

/// Rows from the top, three bytes a pixel: red, green, blue, as displays take them (sRGB).
struct Image {
    int width{}, height{};
    std::vector<std::uint8_t> rgb;
};

/// The error names the path; no half-written file is left.
Expected<void> write_png(const std::filesystem::path& path, const Image& image);

}  // namespace thaum::render
