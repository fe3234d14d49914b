#include "core/maths.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/detail/double2.h"
#include "core/sin_cos.h"

// Each function reduces its argument to a small interval and sums a Taylor series there. The number of terms
// is chosen so that the first omitted term is below half an ulp. exp, log and pow are in powers.cpp.
namespace thaum::det {
namespace {

__extension__ using Wide = unsigned __int128;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// pi/2 in three parts. The product of each of the first two with an integer below 2^20 is exact.
constexpr double half_pi_high = 0x1.921fb544p+0;
constexpr double half_pi_middle = 0x1.0b4611a6p-34;
constexpr double half_pi_low = 0x1.3198a2e037073p-69;

/// Computes sin(x + remainder) for |x| <= pi/4, where `remainder` is a correction smaller than an ulp of x.
double sin_near_zero(double x, double remainder) {
    if (std::abs(x) < 0x1p-27) return remainder == 0 ? x : x + remainder;  // x + 0 would lose the sign of -0
    const double q = x * x;
    const double q2 = q * q;
    const double low = (-1.0 / 6 + q / 120) + q2 * (-1.0 / 5040 + q / 362880);
    const double high = (-1.0 / 39916800 + q * (1.0 / 6227020800)) +
                        q2 * (-1.0 / 1307674368000 + q * (1.0 / 355687428096000));
    return x + (x * q * (low + q2 * q2 * high) + remainder * (1 - q / 2));
}

double cos_near_zero(double x, double remainder) {
    const double q = x * x;
    const double q2 = q * q;
    const double low = (1.0 / 24 - q * (1.0 / 720)) + q2 * (1.0 / 40320 - q * (1.0 / 3628800));
    const double high = (1.0 / 479001600 - q * (1.0 / 87178291200)) + q2 * (1.0 / 20922789888000);
    const double half = q / 2;
    const double top = 1 - half;
    return top + (((1 - top) - half) + (q2 * (low + q2 * q2 * high) - x * remainder));
}

/// An angle from which a whole number of quarter turns was subtracted.
struct Reduced {
    double x;          ///< remaining angle in [-pi/4, pi/4], up to rounding of the last place (rad)
    double remainder;  ///< rounding error of x; the angle is x + remainder (rad)
    int quadrant;      ///< number of quarter turns modulo 4
};

/// Bits of 2/pi after the binary point.
constexpr std::uint64_t two_over_pi[19] = {
    0xa2f9836e4e441529, 0xfc2757d1f534ddc0, 0xdb6295993c439041, 0xfe5163abdebbc561, 0xb7246e3a424dd2e0,
    0x06492eea09d1921c, 0xfe1deb1cb129a73e, 0xe88235f52ebb4484, 0xe99c7026b45f7e41, 0x3991d639835339f4,
    0x9c845f8bbdf9283b, 0x1ff897ffde05980f, 0xef2f118b5a0a6d1f, 0x6d367ecf27cb09b7, 0x4f463f669e5fea2d,
    0x7527bac7ebe5f17b, 0x3d0739f78a5292ea, 0x6bfb5fb11f8d5d08, 0x56033046fc7b6bab};

/// Returns the 64 bits of 2/pi from the bit of weight 2^-first on. Bits before the binary point are 0.
std::uint64_t bits_of_two_over_pi(int first) {
    if (first <= -63) return 0;
    if (first <= 0) return two_over_pi[0] >> static_cast<unsigned>(1 - first);
    const auto word = static_cast<std::size_t>(first - 1) / 64;
    const auto shift = static_cast<unsigned>(first - 1) % 64;
    if (shift == 0) return two_over_pi[word];
    return two_over_pi[word] << shift | two_over_pi[word + 1] >> (64 - shift);
}

/// An integer of 192 bits, lowest word first.
using Long = std::array<std::uint64_t, 3>;

/// Returns (x 2/pi) mod 4 in units of 2^-190, for x > 0 (Payne and Hanek). It omits the bits of 2/pi that
/// only add whole turns, and those too small to matter. The error is below 2^-137.
Long quarter_turns(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const std::uint64_t mantissa = (bits & 0xfffffffffffffULL) | 0x10000000000000ULL;
    const int first = static_cast<int>(bits >> 52U) - 1075 - 1;
    Long product{};
    Wide carry = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        carry += static_cast<Wide>(mantissa) * bits_of_two_over_pi(first + 128 - 64 * static_cast<int>(i));
        product[i] = static_cast<std::uint64_t>(carry);
        carry >>= 64U;
    }
    return product;
}

Long negated(Long value) {
    std::uint64_t carry = 1;
    for (auto& word : value) {
        word = ~word + carry;
        carry = word == 0 && carry == 1 ? 1 : 0;
    }
    return value;
}

/// Reduces an angle of any size (rad), accurate to the last bit.
Reduced reduce_exactly(double x) {
    Long turns = quarter_turns(std::abs(x));
    // The upper two bits are the quadrant. A remainder of half a quarter turn or more counts as the next
    // quadrant.
    int quadrant = static_cast<int>(turns[2] >> 62U);
    turns[2] &= 0x3fffffffffffffffULL;
    const bool beyond = (turns[2] & 0x2000000000000000ULL) != 0;
    if (beyond) {
        ++quadrant;
        turns[2] |= 0xc000000000000000ULL;
        turns = negated(turns);
    }
    int weight = 2;  // exponent of the highest bit of the top word, plus one
    while (turns[2] < 0x8000000000000000ULL && weight > -190) {
        turns = {turns[0] << 1U, turns[1] << 1U | turns[0] >> 63U, turns[2] << 1U | turns[1] >> 63U};
        --weight;
    }
    const double high = std::ldexp(static_cast<double>(turns[2] >> 11U), weight - 53);
    const auto next = (turns[2] & 0x7ffU) << 42U | turns[1] >> 22U;
    const double low = std::ldexp(static_cast<double>(next), weight - 106);
    auto [angle, remainder] = product_of(high, 0x1.921fb54442d18p+0);
    remainder += high * 0x1.1a62633145c07p-54 + low * 0x1.921fb54442d18p+0;
    if (beyond != std::signbit(x)) angle = -angle, remainder = -remainder;
    const Double2 sum = sum_of(angle, remainder);
    return {sum.high, sum.low, (std::signbit(x) ? -quadrant : quadrant) & 3};
}

Reduced reduce(double x) {
    if (std::abs(x) <= 0x1.921fb54442d18p-1) return {x, 0, 0};
    if (std::abs(x) > 1e6) return reduce_exactly(x);
    // Adding this number and then subtracting it rounds to the nearest integer.
    constexpr double to_integer = 0x1.8p52;
    const double k = (x * 0x1.45f306dc9c883p-1 + to_integer) - to_integer;
    const Double2 near = sum_of(x - k * half_pi_high, -(k * half_pi_middle));
    // The angle is so near to a multiple of pi/2 that the three parts of pi/2 have too few bits for it.
    if (std::abs(near.high) < 0x1p-20) return reduce_exactly(x);
    const Double2 sum = sum_of(near.high, near.low - k * half_pi_low);
    return {sum.high, sum.low, static_cast<int>(static_cast<std::int64_t>(k) & 3)};
}

double sin_of(const Reduced& r) {
    const double value =
        (r.quadrant & 1) != 0 ? cos_near_zero(r.x, r.remainder) : sin_near_zero(r.x, r.remainder);
    return (r.quadrant & 2) != 0 ? -value : value;
}

double cos_of(const Reduced& r) {
    const double value =
        (r.quadrant & 1) != 0 ? sin_near_zero(r.x, r.remainder) : cos_near_zero(r.x, r.remainder);
    return r.quadrant == 1 || r.quadrant == 2 ? -value : value;
}

constexpr double tan_16th = 0.198912367379658;     // tan(pi/16)
constexpr double tan_3_16ths = 0.668178637919299;  // tan(3 pi/16)

// Computes atan x for |x| <= 1.001 tan(pi/16).
double atan_near_zero(double x) {
    const double q = x * x;
    const double q2 = q * q;
    const double q4 = q2 * q2;
    const double low = (-1.0 / 3 + q * (1.0 / 5)) + q2 * (-1.0 / 7 + q * (1.0 / 9));
    const double middle = (-1.0 / 11 + q * (1.0 / 13)) + q2 * (-1.0 / 15 + q * (1.0 / 17));
    const double high = (-1.0 / 19 + q * (1.0 / 21)) + q2 * (-1.0 / 23);
    return x + x * (q * (low + q4 * (middle + q4 * high)));
}

// Computes atan x for x in [0, 1] by atan x = atan t + atan((x - t) / (1 + x t)). The constant t, near
// tan(pi/8), has few bits and is therefore exact.
double atan_unit(double x) {
    if (x <= tan_16th) return atan_near_zero(x);
    if (x > tan_3_16ths) return pi / 4 + (atan_near_zero((x - 1) / (x + 1)) + 0x1.1a62633145c07p-55);
    constexpr double t = 0.4140625;
    constexpr double atan_t = 0x1.91fde7cd0c662p-2;
    return atan_t + (atan_near_zero((x - t) / (1.0 + x * t)) + 0x1.1074188054b53p-56);
}

}  // namespace

double sin(double x) { return std::isfinite(x) ? sin_of(reduce(x)) : nan; }

double cos(double x) { return std::isfinite(x) ? cos_of(reduce(x)) : nan; }

SinCos sin_cos(double x) {
    if (!std::isfinite(x)) return {nan, nan};
    const Reduced r = reduce(x);
    return {sin_of(r), cos_of(r)};
}

double tan(double x) {
    const auto [sine, cosine] = sin_cos(x);
    return sine / cosine;
}

double atan2(double y, double x) {
    if (std::isnan(x) || std::isnan(y)) return nan;
    const double ax = std::abs(x);
    const double ay = std::abs(y);
    double angle = 0;
    if (ax == 0 && ay == 0) {
        angle = 0;
    } else if (std::isinf(ax) && std::isinf(ay)) {
        angle = pi / 4;
    } else if (ay <= ax) {
        angle = atan_unit(ay / ax);
    } else {
        angle = pi / 2 - atan_unit(ax / ay);
    }
    if (std::signbit(x)) angle = pi - angle;
    return std::copysign(angle, y);
}

double asin(double x) { return std::abs(x) <= 1 ? atan2(x, std::sqrt((1 - x) * (1 + x))) : nan; }
double acos(double x) { return std::abs(x) <= 1 ? atan2(std::sqrt((1 - x) * (1 + x)), x) : nan; }

}  // namespace thaum::det
