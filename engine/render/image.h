// render/image.h: pictures in memory and as PNG files.
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/error.h"

namespace thaum::render {

/// A picture: rows from the top, and for each pixel three bytes, red, green and blue (sRGB).
struct Image {
    int width{}, height{};
    std::vector<std::uint8_t> rgb;
};

/// Writes a PNG file. The error names the path; no half-written file remains.
Expected<void> write_png(const std::filesystem::path& path, const Image& image);

}  // namespace thaum::render
