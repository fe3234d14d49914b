// render/colour.h: colours are linear light everywhere, so that lights add up physically. People write and
// read colours as sRGB hex, so code enters colours with colour(0xRRGGBB).
#pragma once
#include <cmath>
#include <cstdint>

#include "core/maths.h"

namespace thaum::render {

/// Converts one sRGB channel in [0, 1] to linear light (IEC 61966-2-1).
inline float linear_from_srgb(float s) {
    return s <= 0.04045F ? s / 12.92F : std::pow((s + 0.055F) / 1.055F, 2.4F);
}

inline float srgb_from_linear(float l) {
    return l <= 0.0031308F ? l * 12.92F : 1.055F * std::pow(l, 1 / 2.4F) - 0.055F;
}

/// Converts an sRGB hex colour to linear light: colour(0xFF8A2A).
inline fvec3 colour(std::uint32_t hex) {
    const auto channel = [hex](int shift) {
        return linear_from_srgb(static_cast<float>((hex >> shift) & 0xFFU) / 255);
    };
    return {channel(16), channel(8), channel(0)};
}

/// The same, with an opacity in [0, 1], for overlays.
inline fvec4 colour(std::uint32_t hex, float alpha) { return {colour(hex), alpha}; }

}  // namespace thaum::render
