// render/perceptual.h: how different two pictures look, as the eye counts and not as bytes do.
//
// Both pictures are blurred a little in linear light, since nobody sees single pixels from where one sits, and then
// compared pixel by pixel in CIELAB (CIE 15:2004, 8.2; white D65), where the distance dE*ab = |Lab1 - Lab2| is about
// even to the eye: 1 is hardly seen, black and white are 100 apart. A blur followed by CIELAB is the scheme of S-CIELAB
// (Zhang and Wandell 1997) with one filter for all three channels.
#pragma once
#include "render/image.h"

namespace thaum::render {

struct Lab {
    double l{}, a{}, b{};
};

/// CIELAB of linear light with sRGB's primaries.
Lab lab_of(double red, double green, double blue);

struct PictureDistance {
    double mean{};   ///< dE*ab over all pixels
    double worst{};  ///< the greatest mean of a tile of 16 x 16 pixels: something small is missing
};

/// Both must be of one size. The blur is Gaussian, of `sigma` px.
PictureDistance distance(const Image& a, const Image& b, double sigma = 1);

}  // namespace thaum::render
