// Tests of pictures of sounds: a tone appears as a bright line at its frequency, and the waveform is as high
// as the samples.
#include "game/app/sound_picture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "audio/analysis.h"
#include "core/maths.h"

namespace thaum::game {
namespace {

audio::Sound tone(double hz, double level) {
    audio::Sound sound;
    sound.name = "tone";
    sound.description = "a tone";
    for (int i = 0; i < 24'000; ++i)
        sound.samples.push_back(
            static_cast<float>(level * std::sin(2 * pi * hz * static_cast<double>(i) / audio::sample_rate)));
    return sound;
}

int light_at(const render::Image& image, int x, int y) {
    const auto at = static_cast<std::size_t>(y * image.width + x) * 3;
    return image.rgb[at] + image.rgb[at + 1] + image.rgb[at + 2];
}

/// Row of the brightest pixel in column x, among the rows [from, to).
int brightest(const render::Image& image, int x, int from, int to) {
    int best = from;
    for (int y = from; y < to; ++y)
        if (light_at(image, x, y) > light_at(image, x, best)) best = y;
    return best;
}

/// Number of blue rows of the waveform in column x.
int wave_height(const render::Image& image, int x) {
    int rows = 0;
    for (int y = 54; y < 174; ++y) {
        const auto at = static_cast<std::size_t>(y * image.width + x) * 3;
        if (image.rgb[at + 2] > 200) ++rows;
    }
    return rows;
}

TEST(SoundPicture, ToneIsALineAtItsFrequency) {
    auto font = render::Font::load().value();
    for (const double hz : {200.0, 1500.0, 7000.0}) {
        const auto image = draw_sound(tone(hz, 0.5), font);
        const double share =
            std::log(hz / audio::lowest_row_hz) / std::log(audio::highest_row_hz / audio::lowest_row_hz);
        const int wanted = 184 + static_cast<int>((1 - share) * 244);
        // A line of the Fourier transform is 23 Hz wide, which is eight rows at 200 Hz.
        EXPECT_NEAR(brightest(image, 320, 184, 428), wanted, hz < 500 ? 8 : 2) << hz;
        EXPECT_LT(light_at(image, 320, wanted < 300 ? 420 : 190), 100);
    }
}

TEST(SoundPicture, WaveIsAsHighAsItsSamples) {
    auto font = render::Font::load().value();
    EXPECT_NEAR(wave_height(draw_sound(tone(3000, 0.9), font), 320), 108, 3);
    EXPECT_NEAR(wave_height(draw_sound(tone(3000, 0.3), font), 320), 36, 3);
}

TEST(SoundPicture, SheetHasAPlaceForEachSound) {
    auto font = render::Font::load().value();
    const auto one = tone(1000, 0.5);
    const std::vector<const audio::Sound*> three(3, &one), twelve(12, &one);
    const auto low = draw_sounds(three, font), high = draw_sounds(twelve, font);
    EXPECT_EQ(low.width, high.width);
    EXPECT_EQ(high.height - 8, 2 * (low.height - 8));
    EXPECT_EQ(high.rgb.size(),
              static_cast<std::size_t>(high.width) * static_cast<std::size_t>(high.height) * 3);
    // The twelfth sound is the third one of the second row; no other follows.
    const auto column = [&](int n) { return 8 + n * 158 + 75; };
    const int row = 8 + 176;
    EXPECT_GT(light_at(high, column(2), brightest(high, column(2), row + 62, row + 168)), 500);
    EXPECT_LT(light_at(high, column(3), brightest(high, column(3), row + 62, row + 168)), 100);
}

TEST(SoundPicture, EmptyAndSilentSoundsAreDrawn) {
    auto font = render::Font::load().value();
    auto silent = tone(100, 0);
    EXPECT_LT(light_at(draw_sound(silent, font), 320, 300), 100);
    silent.samples.clear();
    EXPECT_LT(light_at(draw_sound(silent, font), 320, 300), 100);
}

}  // namespace
}  // namespace thaum::game
