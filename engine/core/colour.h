// core/colour.h: colours in data files. People write them as sRGB, "#RRGGBB";
// pictures compute with linear light.
#pragma once
#include "core/config.h"
#include "core/maths.h"

namespace thaum {

/// Converts one channel of an sRGB colour to linear light; both are 0 to 1 (IEC 61966-2-1).
double linear_from_srgb(double s);

/// Linear light, 0 to 1, of an sRGB colour 0xRRGGBB.
vec3 linear_colour(std::uint32_t hex);

/// Reads a colour as linear light: "#RRGGBB", or, in older files, three values of linear light from 0 to 1.
vec3 read_linear_colour(const ConfigTable& table, std::string_view key);

}  // namespace thaum
