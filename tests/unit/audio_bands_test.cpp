// Tests of the levels of a sound in frequency bands over time: known tones, a known envelope, loops without a
// seam.
#include "audio/bands.h"

#include <gtest/gtest.h>

#include "unit/audio_rig.h"

namespace thaum::audio {
namespace {

using rig::sine;

constexpr std::array<Band, 3> bands{{{20, 80}, {80, 250}, {250, 1000}}};

Sound sound_of(std::vector<float> samples, bool loops) {
    return {.name = "test", .description = "test", .loops = loops, .samples = std::move(samples)};
}

/// Levels of a sine's frequency bands, in the middle of the sine.
BandLevels levels_of(double hz, double amplitude) {
    const auto course = band_course(sound_of(sine(hz, 1, amplitude), true), bands);
    return course.at(0.5 * sample_rate);
}

TEST(BandCourse, AToneHasItsAmplitudeInItsBandAndLittleInTheOthers) {
    const std::array<std::vector<double>, 3> tones{{{28, 40, 60}, {110, 141, 190}, {350, 500, 700}}};
    for (std::size_t band = 0; band < bands.size(); ++band) {
        for (const double hz : tones.at(band)) {
            const auto levels = levels_of(hz, 0.5);
            for (std::size_t other = 0; other < bands.size(); ++other) {
                if (other == band)
                    EXPECT_NEAR(levels.at(other), 0.5, 0.06) << hz;
                else
                    EXPECT_LT(levels.at(other), 0.17) << hz << " in band " << other;
            }
        }
    }
}

TEST(BandCourse, AnOctaveBeyondTheBandIs24DecibelsDown) {
    for (const auto& [hz, band] : {std::pair(10.0, 0U), {160, 0}, {40, 1}, {500, 1}, {125, 2}})
        EXPECT_NEAR(levels_of(hz, 1).at(band), 1.0 / 16, 0.02) << hz;
}

TEST(BandCourse, TonesAboveAllBandsDoNotComeBackAsLowOnes) {
    for (double hz = 4000; hz < 20'000; hz += 437)
        for (const float level : levels_of(hz, 1)) EXPECT_LT(level, 0.06F) << hz;
}

TEST(BandCourse, FollowsTheEnvelopeOfATone) {
    // A tone that grows for half a second and decays for half a second.
    for (const auto& [hz, band, late] : {std::tuple(40.0, 0U, 0.03), {141, 1, 0.01}, {500, 2, 0.004}}) {
        auto samples = sine(hz, 1, 1);
        const auto shape = [](double s) { return s < 0.5 ? 2 * s : std::max(0.0, 2 - 2 * s); };
        for (std::size_t i = 0; i < samples.size(); ++i)
            samples[i] *= static_cast<float>(shape(static_cast<double>(i) / sample_rate));
        const auto course = band_course(sound_of(std::move(samples), false), bands);
        for (std::size_t block = 0; block < 125; ++block) {
            const double middle = (static_cast<double>(block) + 0.5) * 0.008;
            const auto level = course.at(static_cast<double>(block * frame_samples)).at(band);
            EXPECT_NEAR(level, shape(std::max(0.0, middle - late)), 0.07) << hz << " Hz, block " << block;
        }
        EXPECT_LT(course.levels.back().at(band), 0.01) << "the tail is long enough";
        EXPECT_TRUE(course.has_ended(sample_rate + 12.5 * frame_samples));
        EXPECT_EQ(course.at(2 * sample_rate), BandLevels{});
    }
}

TEST(BandCourse, ALoopHasNoSeam) {
    // A loop of 40 whole periods. Its length is not a multiple of a block, so its seam lies within a block.
    const double seconds = 40.0 / 41;
    const auto course = band_course(sound_of(sine(41, seconds, 0.5), true), bands);
    for (const auto& levels : course.levels) EXPECT_NEAR(levels[0], 0.5, 0.04);
    EXPECT_EQ(course.at(course.samples * 7.25), course.at(course.samples * 0.25));
    EXPECT_FALSE(course.has_ended(1e9));
}

TEST(BandCourse, SilenceAndNothingGiveNothing) {
    const auto silence = band_course(sound_of(std::vector<float>(sample_rate), true), bands);
    for (const auto& levels : silence.levels) EXPECT_EQ(levels, BandLevels{});
    const auto nothing = band_course(sound_of({}, true), bands);
    EXPECT_EQ(nothing.at(0), BandLevels{});
    EXPECT_EQ(silence.at(-1), BandLevels{});
    EXPECT_EQ(silence.at(std::nan("")), BandLevels{});
}

TEST(BandCourse, EqualSoundsGiveEqualCourses) {
    const auto bank = rig::bank();
    const auto first = band_courses(bank, bands), second = band_courses(bank, bands);
    ASSERT_EQ(first.size(), bank.sounds.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_EQ(first[i].levels, second[i].levels);
        EXPECT_EQ(first[i].group, bank.sounds[i].group);
    }
}

}  // namespace
}  // namespace thaum::audio
