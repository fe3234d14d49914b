// Compares the deterministic elementary functions with the 80-bit functions of the C library, whose error
// is below 1/1000 of a double's ulp. The asserted bounds are those that core/maths.h states.
#include "core/maths.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "core/exp8.h"
#include "core/random.h"
#include "core/sin_cos.h"

namespace thaum {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double smallest = std::numeric_limits<double>::denorm_min();
constexpr double min_normal = std::numeric_limits<double>::min();
constexpr double largest = std::numeric_limits<double>::max();
constexpr int samples = 200'000;

/// Distance from a double of the size of x to the next double.
long double ulp_at(long double x) {
    const int exponent = x == 0 ? -1074 : std::max(std::ilogb(x) - 52, -1074);
    return std::ldexp(1.0L, exponent);
}

long double ulps(double value, long double exact) { return std::abs(value - exact) / ulp_at(exact); }

/// Largest error over many arguments, and the argument with that error.
struct Worst {
    long double error = 0;
    double at = 0;

    void add(long double e, double x) {
        if (e > error || std::isnan(e)) error = e, at = x;
    }
};

using Real = std::function<double(double)>;
using Exact = std::function<long double(long double)>;

Worst worst_over(const std::vector<double>& arguments, const Real& real, const Exact& exact) {
    Worst worst;
    for (const double x : arguments) worst.add(ulps(real(x), exact(x)), x);
    return worst;
}

std::vector<double> uniform_arguments(double low, double high, std::uint64_t seed) {
    Random random{seed};
    std::vector<double> result(samples);
    for (auto& x : result) x = random.uniform(low, high);
    return result;
}

/// Random arguments of both signs with every exponent from 2^low to 2^high.
std::vector<double> spread_arguments(int low, int high, std::uint64_t seed) {
    Random random{seed};
    std::vector<double> result(samples);
    for (auto& x : result) {
        const auto exponent = low + static_cast<int>(random.below(static_cast<std::uint64_t>(high - low)));
        x = std::ldexp(random.uniform(1, 2), exponent) * (random.below(2) == 0 ? 1 : -1);
    }
    return result;
}

/// Doubles around k pi/2, where an inexact reduction of the argument would lose all digits.
std::vector<double> arguments_near_quarter_turns() {
    std::vector<double> result;
    for (int k = -63'000; k <= 63'000; ++k) {
        const double centre = static_cast<double>(k * (std::acos(-1.0L) / 2));
        result.insert(result.end(),
                      {std::nextafter(centre, -infinity), centre, std::nextafter(centre, infinity)});
    }
    return result;
}

/// Positive numbers around the powers of two, subnormal numbers, and the ends of the range.
std::vector<double> special_positive() {
    std::vector<double> result{smallest, 2 * smallest, 3 * smallest, min_normal, largest};
    for (int e = -1074; e < 1024; ++e) {
        const double x = std::ldexp(1.0, e);
        result.insert(result.end(), {std::nextafter(x, 0.0), x, std::nextafter(x, infinity)});
    }
    std::erase(result, 0.0);
    return result;
}

void expect_same_bits(double a, double b) {
    EXPECT_EQ(a, b);
    EXPECT_EQ(std::signbit(a), std::signbit(b));
}

long double exact_sin(long double x) { return std::sin(x); }
long double exact_cos(long double x) { return std::cos(x); }
long double exact_tan(long double x) { return std::tan(x); }
long double exact_exp(long double x) { return std::exp(x); }

struct TurnFunction {
    const char* name;
    double (*real)(double);
    long double (*exact)(long double);
    long double bound;
};

// NOLINTNEXTLINE(readability-identifier-naming): GoogleTest calls it.
void PrintTo(const TurnFunction& f, std::ostream* out) { *out << f.name; }

class TurnAccuracy : public ::testing::TestWithParam<TurnFunction> {
protected:
    static void expect_within_bound(const std::vector<double>& arguments) {
        const auto worst = worst_over(arguments, GetParam().real, GetParam().exact);
        EXPECT_LE(worst.error, GetParam().bound) << "at " << worst.at;
    }
};

TEST_P(TurnAccuracy, OneTurn) { expect_within_bound(uniform_arguments(-7, 7, 1)); }
TEST_P(TurnAccuracy, ManyTurns) { expect_within_bound(uniform_arguments(-1e5, 1e5, 2)); }
TEST_P(TurnAccuracy, EveryExponent) { expect_within_bound(spread_arguments(-1074, 1023, 3)); }
TEST_P(TurnAccuracy, NearQuarterTurns) { expect_within_bound(arguments_near_quarter_turns()); }

TEST_P(TurnAccuracy, HugeArgumentsNextToQuarterTurns) {
    // The last argument is the double that lies nearest to a multiple of pi/2 (W. Kahan).
    expect_within_bound({1.0000001e9, -1e10, 1e22, largest, -largest, 6381956970095103.0 * 0x1p797});
}

TEST_P(TurnAccuracy, ReturnsNaNForArgumentsThatAreNotFinite) {
    for (const double x : {infinity, -infinity, nan}) EXPECT_TRUE(std::isnan(GetParam().real(x))) << x;
}

INSTANTIATE_TEST_SUITE_P(Maths, TurnAccuracy,
                         ::testing::Values(TurnFunction{"sin", det::sin, exact_sin, 1},
                                           TurnFunction{"cos", det::cos, exact_cos, 1},
                                           TurnFunction{"tan", det::tan, exact_tan, 3}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(MathsAccuracy, SineAndCosineTogetherAreTheSameBits) {
    for (const double x : spread_arguments(-1074, 1023, 4)) {
        const auto [sine, cosine] = det::sin_cos(x);
        ASSERT_EQ(sine, det::sin(x)) << x;
        ASSERT_EQ(cosine, det::cos(x)) << x;
    }
}

TEST(MathsAccuracy, ExpOfEightIsTheSameBits) {
    // Numbers within 1, 30, 700 or 1,500 of zero: beyond 700, exp8 (eight exponentials at once) uses another
    // formula. Some rounds have special numbers, or a NaN or infinity beside seven other numbers.
    Random random = random_stream(8, 1);
    for (int n = 0; n < 20'000; ++n) {
        const double reach = n % 4 == 0 ? 1 : n % 4 == 1 ? 30 : n % 4 == 2 ? 700 : 1500;
        std::array<double, 8> x{};
        for (double& one : x) one = random.uniform(-reach, reach);
        if (n % 16 == 0) x = {0, -0.0, 700, -700, 0.5 * std::log(2), -1e-300, 1e-18, 1};
        if (n % 16 == 8) x[3] = n % 32 == 8 ? std::nan("") : HUGE_VAL;
        const auto eight = det::exp8(x);
        for (std::size_t i = 0; i < 8; ++i)
            ASSERT_EQ(std::bit_cast<std::uint64_t>(eight[i]), std::bit_cast<std::uint64_t>(det::exp(x[i])))
                << x[i];
    }
}

TEST(MathsAccuracy, Atan2) {
    Random random{5};
    Worst worst;
    for (int i = 0; i < samples; ++i) {
        const double y = random.uniform(-1, 1) * std::ldexp(1.0, static_cast<int>(random.below(80)) - 40);
        const double x = random.uniform(-1, 1);
        worst.add(ulps(det::atan2(y, x), std::atan2(static_cast<long double>(y), x)), y / x);
    }
    EXPECT_LE(worst.error, 3.0L) << "at " << worst.at;
}

TEST(MathsAccuracy, Atan2OfEverySize) {
    const auto y = spread_arguments(-1074, 1023, 6);
    const auto x = spread_arguments(-1074, 1023, 7);
    Worst worst;
    for (std::size_t i = 0; i < y.size(); ++i) {
        worst.add(ulps(det::atan2(y[i], x[i]), std::atan2(static_cast<long double>(y[i]), x[i])), y[i]);
    }
    EXPECT_LE(worst.error, 3.0L) << "at " << worst.at;
}

TEST(MathsAccuracy, AsinAndAcos) {
    std::vector<double> arguments = uniform_arguments(-1, 1, 8);
    for (const double x : spread_arguments(-60, -1, 9)) {
        arguments.push_back(x);
        arguments.push_back(x > 0 ? 1 - x : -1 - x);
    }
    const auto asin = worst_over(arguments, det::asin, [](long double x) { return std::asin(x); });
    const auto acos = worst_over(arguments, det::acos, [](long double x) { return std::acos(x); });
    EXPECT_LE(asin.error, 4.0L) << "at " << asin.at;
    EXPECT_LE(acos.error, 4.0L) << "at " << acos.at;
}

TEST(MathsAccuracy, Exp) {
    for (const auto& arguments : {uniform_arguments(-745.2, 709.78, 10), uniform_arguments(-1, 1, 11),
                                  spread_arguments(-1074, 9, 12)}) {
        const auto worst = worst_over(arguments, det::exp, exact_exp);
        EXPECT_LE(worst.error, 2.0L) << "at " << worst.at;
    }
}

TEST(MathsAccuracy, Log) {
    auto arguments = spread_arguments(-1074, 1024, 13);
    for (auto& x : arguments) x = std::abs(x);
    const auto special = special_positive();
    arguments.insert(arguments.end(), special.begin(), special.end());
    const auto near_one = uniform_arguments(0.5, 2, 14);
    arguments.insert(arguments.end(), near_one.begin(), near_one.end());
    Worst worst;
    for (const double x : arguments) {
        const auto exact = std::log(static_cast<long double>(x));
        worst.add(std::abs(det::log(x) - exact) / ulp_at(std::max(std::abs(exact), 1.0L)), x);
    }
    EXPECT_LE(worst.error, 2.0L) << "at " << worst.at;
}

TEST(MathsAccuracy, Pow) {
    Random random{15};
    Worst worst;
    for (int i = 0; i < 5 * samples; ++i) {
        const double x = std::ldexp(random.uniform(1, 2), static_cast<int>(random.below(2040)) - 1020);
        // Half of the exponents are so large that results are near the ends of the range.
        const double y = i % 2 == 0 ? random.uniform(-10, 10) : random.uniform(-1000, 1000) / std::log2(x);
        const auto exact = std::pow(static_cast<long double>(x), static_cast<long double>(y));
        if (exact > largest || exact < min_normal) continue;
        worst.add(ulps(det::pow(x, y), exact), x);
    }
    EXPECT_LE(worst.error, 1.0L) << "at " << worst.at;
}

TEST(MathsAccuracy, PowOfSubnormals) {
    Random random{16};
    Worst worst;
    for (int i = 0; i < samples; ++i) {
        const double x = random.uniform(0.01, 100);
        const double y = random.uniform(-1074, -1022) / std::log2(x);
        const auto exact = std::pow(static_cast<long double>(x), static_cast<long double>(y));
        worst.add(ulps(det::pow(x, y), exact), x);
    }
    EXPECT_LE(worst.error, 2.0L) << "at " << worst.at;
}

TEST(MathsAccuracy, PowersThatAreDoublesAreExact) {
    for (int base = 1; base < 2000; ++base) {
        double power = 1;
        for (int n = 1; power * base < 0x1p53 && n < 60; ++n) {
            power *= base;
            ASSERT_EQ(det::pow(base, n), power) << base << ' ' << n;
            ASSERT_EQ(det::pow(-base, n), n % 2 == 0 ? power : -power) << base << ' ' << n;
        }
        const double x = base * 44963.0;
        ASSERT_EQ(det::pow(x * x, 0.5), x);
    }
    for (int e = -1074; e < 1024; ++e) ASSERT_EQ(det::pow(2, e), std::ldexp(1.0, e));
}

TEST(MathsSpecial, PowFollowsTheStandard) {
    const std::array<double, 20> values{0.0,       -0.0, 1,      -1,      2,          -2,      3,
                                        -3,        0.5,  -0.5,   1e300,   -1e300,     1e-300,  infinity,
                                        -infinity, nan,  0x1p53, -0x1p53, 0x1p53 - 1, smallest};
    for (const double x : values) {
        for (const double y : values) {
            const auto exact =
                static_cast<double>(std::pow(static_cast<long double>(x), static_cast<long double>(y)));
            const double ours = det::pow(x, y);
            if (std::isnan(exact)) {
                EXPECT_TRUE(std::isnan(ours)) << x << ' ' << y;
            } else if (std::isinf(exact) || exact == 0) {
                expect_same_bits(ours, exact);
            } else {
                EXPECT_LE(ulps(ours, exact), 1.0L) << x << ' ' << y;
            }
        }
    }
}

TEST(MathsSpecial, SignedZeros) {
    for (const auto f : {det::sin, det::tan, det::asin}) {
        expect_same_bits(f(0.0), 0.0);
        expect_same_bits(f(-0.0), -0.0);
    }
    expect_same_bits(det::cos(0.0), 1.0);
    expect_same_bits(det::cos(-0.0), 1.0);
    expect_same_bits(det::exp(0.0), 1.0);
    expect_same_bits(det::exp(-0.0), 1.0);
    expect_same_bits(det::log(1.0), 0.0);
}

TEST(MathsSpecial, SubnormalsPass) {
    for (const double x : {smallest, 5 * smallest, min_normal / 3}) {
        expect_same_bits(det::sin(x), x);
        expect_same_bits(det::sin(-x), -x);
        expect_same_bits(det::tan(x), x);
        expect_same_bits(det::cos(x), 1);
        expect_same_bits(det::exp(x), 1);
    }
}

TEST(MathsSpecial, Atan2FollowsTheStandard) {
    const std::array<double, 7> values{0.0, -0.0, 1.0, -1.0, infinity, -infinity, 1e-300};
    for (const double y : values) {
        for (const double x : values) {
            const auto exact = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
            EXPECT_LE(ulps(det::atan2(y, x), exact), 1.0L) << y << ' ' << x;
            EXPECT_EQ(std::signbit(det::atan2(y, x)), std::signbit(exact)) << y << ' ' << x;
        }
        EXPECT_TRUE(std::isnan(det::atan2(y, nan)));
        EXPECT_TRUE(std::isnan(det::atan2(nan, y)));
    }
}

TEST(MathsSpecial, OutsideTheDomainIsNan) {
    for (const double x : {1.0000000000000002, -1.0000000000000002, 2.0, infinity, -infinity, nan}) {
        EXPECT_TRUE(std::isnan(det::asin(x))) << x;
        EXPECT_TRUE(std::isnan(det::acos(x))) << x;
    }
    for (const double x : {-smallest, -1.0, -infinity, nan}) EXPECT_TRUE(std::isnan(det::log(x))) << x;
    EXPECT_TRUE(std::isnan(det::exp(nan)));
    EXPECT_TRUE(std::isnan(det::pow(-1.0, 0.5)));
    EXPECT_TRUE(std::isnan(det::pow(nan, 2.0)));
    EXPECT_TRUE(std::isnan(det::pow(2.0, nan)));
}

TEST(MathsSpecial, Ends) {
    EXPECT_EQ(det::exp(710), infinity);
    EXPECT_EQ(det::exp(infinity), infinity);
    EXPECT_EQ(det::exp(largest), infinity);
    EXPECT_TRUE(std::isfinite(det::exp(709.78)));
    EXPECT_EQ(det::exp(-746), 0);
    EXPECT_EQ(det::exp(-infinity), 0);
    EXPECT_EQ(det::exp(-745), smallest);
    EXPECT_EQ(det::log(0.0), -infinity);
    EXPECT_EQ(det::log(-0.0), -infinity);
    EXPECT_EQ(det::log(infinity), infinity);
    EXPECT_EQ(det::pow(0.0, 2.0), 0);
    EXPECT_EQ(det::pow(0.0, -2.0), infinity);
    EXPECT_EQ(det::pow(3.0, 0.0), 1);
    EXPECT_EQ(det::pow(1.0, 12345.0), 1);
    EXPECT_EQ(det::asin(1.0), pi / 2);
    EXPECT_EQ(det::acos(-1.0), pi);
    EXPECT_EQ(det::acos(1.0), 0);
}

TEST(MathsIdentities, OddAndEvenToTheBit) {
    for (const double x : spread_arguments(-1074, 29, 16)) {
        EXPECT_EQ(det::sin(-x), -det::sin(x)) << x;
        EXPECT_EQ(det::cos(-x), det::cos(x)) << x;
        EXPECT_EQ(det::atan2(-x, 1.5), -det::atan2(x, 1.5)) << x;
    }
}

TEST(MathsIdentities, PythagorasAndInverses) {
    for (const double x : uniform_arguments(-1.5, 1.5, 17)) {
        const double s = det::sin(x);
        const double c = det::cos(x);
        EXPECT_NEAR(s * s + c * c, 1.0, 4e-16);
        EXPECT_NEAR(det::atan2(s, c), x, 1e-15);
        EXPECT_NEAR(det::log(det::exp(x)), x, 1e-15);
    }
}

TEST(MathsRotation, LooksAlongMinusZ) {
    const vec3 ahead{0, 0, -1};
    const auto left = look_rotation(pi / 2, 0) * ahead;
    const auto up = look_rotation(0, pi / 2) * ahead;
    EXPECT_NEAR(glm::distance(look_rotation(0, 0) * ahead, ahead), 0, 1e-15);
    EXPECT_NEAR(glm::distance(left, vec3(-1, 0, 0)), 0, 1e-15);
    EXPECT_NEAR(glm::distance(up, vec3(0, 1, 0)), 0, 1e-15);
}

TEST(MathsRotation, FinitenessOfAVector) {
    EXPECT_TRUE(is_finite({1, -largest, 0}));
    for (const double bad : {nan, infinity, -infinity}) {
        EXPECT_FALSE(is_finite({bad, 0, 0}));
        EXPECT_FALSE(is_finite({0, bad, 0}));
        EXPECT_FALSE(is_finite({0, 0, bad}));
    }
}

}  // namespace
}  // namespace thaum
