// Tests of volumes in memory, and of procedural volumes, which formulas fill.
#include "field/volume.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/random.h"
#include "field/analytic.h"
#include "field/block_averages.h"
#include "field/filters.h"

namespace thaum::field {
namespace {

TEST(Volume, TheOriginOfItsFrameIsTheMiddleOfItsSamples) {
    Volume v{.count = {3, 2, 4}, .spacing = {0.5, 2, 0.25}, .components = 3};
    for (int n = 0; n < 3 * 2 * 4; ++n) {
        for (int c = 0; c < 3; ++c) v.samples.floats().push_back(static_cast<float>(100 * c + n));
    }
    EXPECT_EQ(v.extent(), vec3(1, 2, 0.75));
    EXPECT_EQ(v.place(0, 0, 0), vec3(-0.5, -1, -0.375));
    EXPECT_EQ(v.place(2, 1, 3), vec3(0.5, 1, 0.375));
    for (const Kernel kernel : {Kernel::linear, Kernel::catmull_rom}) {
        const StaggeredGrid grid = v.vector_grid(kernel);
        for (int k = 0; k < 4; ++k) {
            for (int j = 0; j < 2; ++j) {
                for (int i = 0; i < 3; ++i) {
                    const int n = i + 3 * (j + 2 * k);
                    EXPECT_EQ(grid(v.place(i, j, k)).value, vec3(n, 100 + n, 200 + n));
                    EXPECT_EQ(v.grid(kernel, 2)(v.place(i, j, k)).value, 200 + n);
                }
            }
        }
    }
}

/// All numbers of an integer type of 8 or 16 bits, in an order without a pattern, many times over.
template <class T>
std::vector<T> all_numbers(std::size_t count) {
    std::vector<T> numbers;
    for (std::size_t i = 0; i < count; ++i) numbers.push_back(static_cast<T>(i * 25'173 + 13'849));
    return numbers;
}

/// Expects that a volume of integers gives the bits of one that holds the same numbers as floats.
template <class T>
void expect_the_bits_of_floats() {
    Volume held{.count = {64, 32, 32}, .spacing = {0.5, 2, 0.25}, .samples = all_numbers<T>(65'536)};
    Volume floats = held;
    floats.samples.floats();
    ASSERT_TRUE(std::holds_alternative<std::vector<T>>(held.samples.values));
    EXPECT_EQ(range_of(held).low, std::numeric_limits<T>::min());
    EXPECT_EQ(range_of(held).high, std::numeric_limits<T>::max());
    EXPECT_EQ(usual_level(held), usual_level(floats));
    EXPECT_EQ(not_finite(held), 0U);
    Random random{11};
    for (const Kernel kernel : {Kernel::linear, Kernel::catmull_rom}) {
        const Grid a = held.grid(kernel), b = floats.grid(kernel);
        for (int n = 0; n < 1000; ++n) {
            const vec3 at(random.uniform(-17, 17), random.uniform(-33, 33), random.uniform(-5, 5));
            EXPECT_EQ(a(at).value, b(at).value);
            EXPECT_EQ(a(at).gradient, b(at).gradient);
            EXPECT_EQ(a.value(at), b.value(at));
        }
        const auto means = make_block_averages(a), same = make_block_averages(b);
        EXPECT_FALSE(means.samples.empty());
        EXPECT_EQ(means.samples, same.samples);
        EXPECT_EQ(means.coarse_steps, same.coarse_steps);
    }
    smooth(held, 1.5);
    smooth(floats, 1.5);
    EXPECT_EQ(held.samples, floats.samples);
}

TEST(Volume, IntegersReadAsTheFloatsThatTheyEqual) {
    expect_the_bits_of_floats<std::uint8_t>();
    expect_the_bits_of_floats<std::int16_t>();
    expect_the_bits_of_floats<std::uint16_t>();
}

TEST(Volume, MissingComponentsReadAsZero) {
    const Volume v{.count = {1, 1, 1}, .samples = {7}};
    EXPECT_EQ(v.grid()(vec3(3)).value, 7);
    EXPECT_EQ(v.grid(Kernel::linear, 1)(vec3(0)).value, 0);
    EXPECT_EQ(v.grid(Kernel::linear, -1)(vec3(0)).value, 0);
    EXPECT_EQ(v.vector_grid()(vec3(0)).value, vec3(0));
    EXPECT_EQ(Volume{}.grid()(vec3(0)).value, 0);
}

TEST(Volume, ItsRangeIgnoresSamplesThatAreNoNumbers) {
    constexpr float none = std::numeric_limits<float>::quiet_NaN();
    const Volume v{.count = {5, 1, 1}, .samples = {none, 3, -2, HUGE_VALF, 1}};
    EXPECT_EQ(range_of(v).low, -2);
    EXPECT_EQ(range_of(v).high, 3);
    EXPECT_EQ(range_of(Volume{.count = {1, 1, 1}, .samples = {none}}).high, 0);
}

TEST(Volume, AScanHoldsTheVolumeOfTheBody) {
    const double radius = 0.07;
    const Sphere sphere{.radius = radius};
    const Volume v = scanned(field_of<Scalar>(sphere), {32, 24, 40}, {0.006, 0.008, 0.005});
    double sum = 0;
    for (const float sample : v.samples.as_floats()) {
        sum += sample / 255;
        EXPECT_EQ(sample, std::round(sample));
    }
    const double exact = 4.0 / 3 * pi * radius * radius * radius;
    EXPECT_NEAR(sum * 0.006 * 0.008 * 0.005, exact, 0.002 * exact);
    EXPECT_EQ(range_of(v).low, 0);
    EXPECT_EQ(range_of(v).high, 255);
    EXPECT_EQ(v.stored_as, SampleType::uint8);
}

TEST(UsualLevel, PartsTwoClassesAndABallAtItsSurface) {
    Volume v{.count = {1000, 1, 1}};
    for (int i = 0; i < 1000; ++i)
        v.samples.floats().push_back(static_cast<float>(i < 700 ? i % 100 : 1900 + i % 100));
    v.samples.floats()[3] = std::numeric_limits<float>::quiet_NaN();
    v.samples.floats()[4] = HUGE_VALF;
    EXPECT_NEAR(usual_level(v), 999.5, 10) << "the middle between the classes";
    v.samples.floats()[5] = 4000;
    EXPECT_LT(usual_level(v), 1900) << "one bright sample moves the middle of the range to 2000";
    EXPECT_NEAR(usual_level(*make_volume("sphere", 64, 1)), 127.5, 6) << "a fortieth of a voxel";
    EXPECT_NEAR(usual_level(*make_volume("gyroid", 48, 1)), 0, 0.02);
}

TEST(UsualLevel, OfVectorsIsOneOfTheirLengths) {
    Volume v{.count = {4, 1, 1}, .components = 3, .samples = {3, 4, 0, 0, 5, 0, 0, 0, 1, 1, 0, 0}};
    EXPECT_NEAR(usual_level(v), 3, 0.1);
    v = {.count = {2, 1, 1}, .samples = {7, 7}};
    EXPECT_EQ(usual_level(v), 7);
    v.samples = {HUGE_VALF, HUGE_VALF};
    EXPECT_EQ(usual_level(v), 0);
}

TEST(MadeVolume, EveryNameMakesAVolumeThatTheSeedRepeats) {
    for (const std::string_view name : volume_names()) {
        const auto a = make_volume(name, 12, 1), again = make_volume(name, 12, 1);
        ASSERT_TRUE(a && again) << name;
        EXPECT_EQ(a->name, name);
        EXPECT_EQ(a->samples, again->samples) << name;
        EXPECT_EQ(a->samples.size(), static_cast<std::size_t>(12 * 12 * 12 * a->components));
        EXPECT_NEAR(a->extent().x, made_extent, 1e-15);
        EXPECT_LT(range_of(*a).low, range_of(*a).high) << name;
    }
    for (const std::string_view name : {"gyroid", "vortices"})
        EXPECT_NE(make_volume(name, 12, 1)->samples, make_volume(name, 12, 2)->samples) << name;
}

TEST(MadeVolume, WrongNamesAndSizesAreRefusedInOneLine) {
    EXPECT_EQ(make_volume("cube", 12, 1).error().message,
              "no volume is called 'cube'; there are: sphere, gyroid, vortices, beltrami");
    for (const int count : {-1, 0, 1, 513, 2'000'000'000})
        EXPECT_NE(make_volume("sphere", count, 1).error().message.find("2 to 512"), std::string::npos);
    EXPECT_NE(make_volume("vortices", 512, 1).error().message.find("too large"), std::string::npos);
}

}  // namespace
}  // namespace thaum::field
