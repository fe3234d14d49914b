// render/colour.h: colours are linear light everywhere, so that lights add up physically. People write and
// read colours as sRGB hex, so code enters colours with colour(0xRRGGBB).
#pragma once
#include <cmath>
#include <cstdint>

#include "core/colour.h"
#include "core/maths.h"

namespace thaum::render {

/// Converts one channel of linear light in [0, 1] to sRGB: the inverse of linear_from_srgb (core/colour.h).
inline float srgb_from_linear(float l) {
    return l <= 0.0031308F ? l * 12.92F : 1.055F * std::pow(l, 1 / 2.4F) - 0.055F;
}

/// Converts an sRGB hex colour to linear light: colour(0xFF8A2A).
inline fvec3 colour(std::uint32_t hex) { return fvec3(linear_colour(hex)); }

/// Converts an sRGB hex colour to linear light, with an opacity in [0, 1], for overlays.
inline fvec4 colour(std::uint32_t hex, float alpha) { return {colour(hex), alpha}; }

}  // namespace thaum::render
