// Tests of the choice of a quality preset: by the OpenGL renderer and by measured times, without switching
// back and forth.
#include "render/quality.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/random.h"

namespace thaum::render {
namespace {

AutoQuality after(AutoQuality state, int frames, double frame_ms) {
    for (int i = 0; i < frames; ++i) state = after_frame(state, frame_ms);
    return state;
}

TEST(Quality, InsideSizesAreThoseOfThePresets) {
    EXPECT_FLOAT_EQ(internal_scale_of(Quality::low, 720), 1);
    EXPECT_FLOAT_EQ(internal_scale_of(Quality::medium, 720), 1);
    EXPECT_FLOAT_EQ(internal_scale_of(Quality::high, 720), 1);
    EXPECT_FLOAT_EQ(internal_scale_of(Quality::medium, 1080), 2 / 3.0F);
    EXPECT_FLOAT_EQ(internal_scale_of(Quality::low, 300), 1) << "never larger than the window";
    EXPECT_FLOAT_EQ(internal_scale_of(Quality::low, 100000), 0.25F);
    EXPECT_FLOAT_EQ(internal_scale_of(Quality::low, 0), 1);
}

TEST(Quality, SoftwareBeginsAtMedium) {
    EXPECT_EQ(first_quality("llvmpipe (LLVM 15.0.6, 256 bits)"), Quality::medium);
    EXPECT_EQ(first_quality("softpipe"), Quality::medium);
    EXPECT_EQ(first_quality("Mesa Intel(R) UHD Graphics 620 (KBL GT2)"), Quality::high);
    EXPECT_EQ(first_quality("NVIDIA GeForce GTX 1060/PCIe/SSE2"), Quality::high);
}

TEST(AutoQuality, StaysWhereTheTimeFits) {
    const auto s = after({.current = Quality::medium}, 10'000, 25);
    EXPECT_EQ(s.current, Quality::medium);
    EXPECT_EQ(s.most, Quality::high);
}

TEST(AutoQuality, StepsDownWhenMostPicturesAreLateAndNotForAFew) {
    EXPECT_EQ(after({.current = Quality::medium}, 67, 60).current, Quality::medium)
        << "no change before enough times were measured";
    EXPECT_EQ(after({.current = Quality::medium}, 68, 60).current, Quality::low);
    AutoQuality hiccups{.current = Quality::medium};
    for (int i = 0; i < 3000; ++i) hiccups = after_frame(hiccups, i % 3 == 0 ? 200 : 20);
    EXPECT_EQ(hiccups.current, Quality::medium);
    EXPECT_EQ(after({.current = Quality::low}, 1000, 500).current, Quality::low) << "there is nothing below";
}

TEST(AutoQuality, StepsUpOnlyWithRoomForTheNext) {
    EXPECT_EQ(after({.current = Quality::low}, 68, 5).current, Quality::medium);
    EXPECT_EQ(after({.current = Quality::low}, 10'000, 12).current, Quality::low);
    EXPECT_EQ(after({.current = Quality::low}, 136, 5).current, Quality::high);
}

TEST(AutoQuality, AQualityThatWasTooSlowIsNotTriedAgain) {
    auto s = after({.current = Quality::medium}, 68, 60);
    ASSERT_EQ(s.current, Quality::low);
    s = after(s, 100'000, 1);
    EXPECT_EQ(s.current, Quality::low);
}

/// Time of a picture whose cost is half that of its pixels and half that of its triangles.
double frame_ms_at(float resolution, double in_full_ms) {
    return in_full_ms * (0.5 + 0.5 * static_cast<double>(resolution * resolution));
}

/// Draws pictures that take `in_full_ms` at full resolution.
AutoQuality settled(AutoQuality state, double in_full_ms) {
    for (int i = 0; i < 1000; ++i) state = after_frame(state, frame_ms_at(state.resolution, in_full_ms));
    return state;
}

TEST(AutoQuality, LowersTheResolutionUntilPicturesAreInTime) {
    for (const double ms : {37.0, 42.0, 48.0, 51.0}) {
        const auto s = settled({.current = Quality::medium}, ms);
        EXPECT_EQ(s.current, Quality::medium) << ms;
        EXPECT_GE(s.resolution, 0.59F) << ms;
        EXPECT_LT(frame_ms_at(s.resolution, ms), 36.5) << ms;
    }
    const auto lowest = settled({.current = Quality::low}, 500);
    EXPECT_NEAR(lowest.resolution, 0.6F, 1e-6F) << "never below 60 percent";
}

TEST(AutoQuality, TheResolutionReturnsWithTheTimeAndRests) {
    const auto slow = settled({.current = Quality::medium}, 40);
    ASSERT_LT(slow.resolution, 1);
    EXPECT_FLOAT_EQ(settled(slow, 18).resolution, 1);
    const auto before = slow.resolution;
    EXPECT_FLOAT_EQ(settled(slow, 40).resolution, before) << "no alternation while the work stays the same";
}

/// Number of changes of preset or resolution after the first 2000 of 5000 pictures of a work that stays the
/// same, whose cost is that of its pixels alone. The screen shows a picture only every `refresh_ms`.
int late_changes(double in_full_ms, double refresh_ms) {
    AutoQuality s{.current = Quality::medium};
    int changes = 0;
    for (int i = 0; i < 5000; ++i) {
        const double work_ms = in_full_ms * static_cast<double>(s.resolution * s.resolution);
        const auto next = after_frame(s, std::ceil(work_ms / refresh_ms) * refresh_ms);
        changes += i >= 2000 && (next.current != s.current || next.resolution != s.resolution);
        s = next;
    }
    return changes;
}

TEST(AutoQuality, RestsAlsoWithScreensThatWait) {
    constexpr double no_wait_ms = 0.001;
    for (const double refresh_ms : {no_wait_ms, 1000.0 / 144, 1000.0 / 75, 1000.0 / 60, 20.0, 1000.0 / 30}) {
        for (int ms = 10; ms <= 120; ++ms)
            EXPECT_EQ(late_changes(ms, refresh_ms), 0) << ms << ' ' << refresh_ms;
    }
}

TEST(AutoQuality, TwoRefreshesOf60HertzAreInTimeAndThreeNotHopeless) {
    AutoQuality two{.current = Quality::medium}, three = two;
    for (int i = 0; i < 1000; ++i) two = after_frame(two, i % 2 == 0 ? 31.3 : 35.3);
    EXPECT_FLOAT_EQ(two.resolution, 1);
    for (int i = 0; i < 70; ++i) three = after_frame(three, i % 2 == 0 ? 49.0 : 51.0);
    EXPECT_EQ(three.current, Quality::medium);
    EXPECT_LT(three.resolution, 1);
}

TEST(AutoQuality, SwitchesRarelyForAnyTimes) {
    Random random = random_stream(5, 1);
    for (int run = 0; run < 50; ++run) {
        AutoQuality s{.current = static_cast<Quality>(random.below(qualities))};
        int changes = 0, resolutions = 0;
        for (int i = 0; i < 20'000; ++i) {
            // Times of pictures, which alternate between fast and slow every 300 pictures.
            const double ms = (i / 300 + run) % 2 == 0 ? random.uniform(0, 8) : random.uniform(20, 200);
            const auto next = after_frame(s, ms);
            changes += next.current != s.current;
            resolutions += next.resolution != s.resolution;
            s = next;
        }
        EXPECT_LE(changes, 4);
        // Two steps down and two up in each 600 pictures.
        EXPECT_LE(resolutions, 4 * 20'000 / 600 + 4);
    }
}

TEST(AutoQuality, TimesThatAreNotNumbersChangeNothing) {
    const auto s = after({.current = Quality::medium}, 1000, std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(s.current, Quality::medium);
}

}  // namespace
}  // namespace thaum::render
