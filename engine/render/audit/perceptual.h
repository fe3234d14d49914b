// render/audit/perceptual.h: measures how different two pictures look to the eye, rather than byte by byte.
//
// Both pictures are blurred slightly in linear light, since the eye does not resolve single pixels at a
// normal distance. They are then compared pixel by pixel in CIELAB (CIE 15:2004, 8.2; white D65). There the
// distance dE*ab = |Lab1 - Lab2| corresponds about evenly to what the eye sees: 1 is hardly visible, black
// and white are 100 apart. A blur followed by CIELAB is the scheme of S-CIELAB (Zhang and Wandell 1997), here
// with one filter for all three channels.
#pragma once
#include "render/image.h"

namespace thaum::render {

/// A colour in CIELAB.
struct Lab {
    double l{}, a{}, b{};
};

/// Converts linear light with the sRGB primaries to CIELAB.
Lab lab_of(double red, double green, double blue);

/// How different two pictures look.
struct PictureDistance {
    double mean{};  ///< mean over all pixels (dE*ab)
    /// Greatest mean of any tile of 16 x 16 pixels, which shows a small missing object (dE*ab).
    double worst{};
};

/// Distance of two pictures of equal size. `sigma` is the width of the Gaussian blur (px).
PictureDistance distance(const Image& a, const Image& b, double sigma = 1);

}  // namespace thaum::render
