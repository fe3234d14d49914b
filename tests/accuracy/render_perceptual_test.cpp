// Tests the perceptual distance of pictures on pairs with a known distance.
#include "render/audit/perceptual.h"

#include <gtest/gtest.h>

#include <cmath>

namespace thaum::render {
namespace {

Image plain(int width, int height, std::uint8_t r, std::uint8_t g, std::uint8_t b) {
    Image image{width, height, {}};
    for (int i = 0; i < width * height; ++i) image.rgb.insert(image.rgb.end(), {r, g, b});
    return image;
}

/// L* of a grey level by the CIE formula. Greys have a* = b* = 0.
double lightness(int grey) {
    const double s = grey / 255.0;
    const double y = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
    return y > 216.0 / 24389 ? 116 * std::cbrt(y) - 16 : 24389.0 / 27 * y;
}

TEST(Perceptual, TheSameIsZero) {
    const auto image = plain(40, 30, 12, 200, 99);
    EXPECT_EQ(distance(image, image).mean, 0);
    EXPECT_EQ(distance(image, image).worst, 0);
    EXPECT_EQ(distance({}, {}).mean, 0);
}

TEST(Perceptual, OneStepOfGreyIsItsStepOfLightness) {
    for (const int grey : {1, 9, 60, 127, 254}) {
        const auto g = static_cast<std::uint8_t>(grey), next = static_cast<std::uint8_t>(grey + 1);
        const auto d = distance(plain(20, 20, g, g, g), plain(20, 20, next, next, next));
        // The rounded conversion matrix gives greys a chroma of less than 0.02, hence the tolerance.
        EXPECT_NEAR(d.mean, lightness(grey + 1) - lightness(grey), 1e-3) << grey;
        EXPECT_NEAR(d.worst, d.mean, 1e-6);
    }
}

TEST(Perceptual, KnownColours) {
    // CIELAB values of the sRGB primaries under D65, as published by Lindbloom.
    const auto expect = [](const Lab& lab, double l, double a, double b) {
        EXPECT_NEAR(lab.l, l, 0.05);
        EXPECT_NEAR(lab.a, a, 0.1);
        EXPECT_NEAR(lab.b, b, 0.1);
    };
    expect(lab_of(1, 0, 0), 53.24, 80.09, 67.20);
    expect(lab_of(0, 1, 0), 87.74, -86.18, 83.18);
    expect(lab_of(0, 0, 1), 32.30, 79.19, -107.86);
    const auto d = distance(plain(32, 32, 0, 0, 0), plain(32, 32, 255, 255, 255));
    EXPECT_NEAR(d.mean, 100, 0.02);
}

TEST(Perceptual, ASmallChangeShowsInItsTile) {
    const auto a = plain(160, 160, 80, 80, 80);
    auto b = a;
    for (int y = 48; y < 64; ++y) {
        for (int x = 64; x < 80; ++x)
            b.rgb[3 * (static_cast<std::size_t>(y) * 160 + static_cast<std::size_t>(x))] = 255;
    }
    const auto d = distance(a, b);
    EXPECT_LT(d.mean, 1.2);
    EXPECT_GT(d.worst, 60);
}

TEST(Perceptual, FineStripesLookLikeTheGreyOfTheirLight) {
    auto stripes = plain(64, 64, 0, 0, 0), grey = plain(64, 64, 188, 188, 188);
    for (std::size_t i = 0; i < stripes.rgb.size(); ++i) stripes.rgb[i] = (i / 3) % 2 == 0 ? 255 : 0;
    EXPECT_GT(distance(stripes, grey, 0).mean, 40);
    EXPECT_LT(distance(stripes, grey, 2).mean, 2);
}

}  // namespace
}  // namespace thaum::render
