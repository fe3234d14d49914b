// core/powers.cpp: exp, log and pow of core/maths.h, and exp of core/exp8.h.
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/detail/double2.h"
#include "core/doubles4.h"
#include "core/exp8.h"
#include "core/maths.h"

namespace thaum::det {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// ln 2 in two parts. The product of the first part with an integer below 2^11 is exact.
constexpr double ln2_high = 0x1.62e42fee00000p-1;
constexpr double ln2_low = 0x1.a39ef35793c76p-33;

/// The form x = mantissa 2^exponent with mantissa in [sqrt(1/2), sqrt(2)), for x > 0 and finite.
struct Split {
    double mantissa;
    int exponent;
};

Split split(double x) {
    Split parts{};
    parts.mantissa = std::frexp(x, &parts.exponent);
    if (parts.mantissa < 0.70710678118654752) {
        parts.mantissa *= 2;
        --parts.exponent;
    }
    return parts;
}

/// Computes log x for x > 0 and finite, with a relative error below 2^-63. It uses log m = 2 atanh s with s =
/// (m - 1)/(m + 1) and |s| <= 0.172. Of the series 2 s + 2/3 s^3 + 2/5 s^5 + ..., the first two terms need
/// the precision of two doubles.
Double2 long_log(double x) {
    const auto [m, exponent] = split(x);
    const double f = m - 1;
    const Double2 g = sum_of(m, 1);
    const double s_high = f / g.high;
    const Double2 back = product_of(s_high, g.high);
    const Double2 s = sum_of(s_high, (((f - back.high) - back.low) - s_high * g.low) / g.high);
    const Double2 q = s * s;
    double tail = 0;
    for (int n = 25; n >= 7; n -= 2) tail = q.high * (2.0 / n + tail);
    tail = (2.0 / 5 + tail) * q.high * q.high * s.high;
    const Double2 cubic = Double2{0x1.5555555555555p-1, 0x1.5555555555555p-55} * (q * s);
    const double k = exponent;
    const Double2 turns = sum_of(k * ln2_high, 0) + product_of(k, ln2_low);
    return (turns + Double2{2 * s.high, 2 * s.low}) + (cubic + Double2{tail, 0});
}

/// Computes exp(x.high + x.low) for |x.high| <= 1100, within 0.8 ulp.
double long_exp(Double2 x) {
    const double k = std::floor(x.high / (ln2_high + ln2_low) + 0.5);
    const Double2 r = sum_of(x.high - k * ln2_high, x.low - k * ln2_low);
    double sum = 0;
    for (int n = 14; n >= 3; --n) sum = (1.0 + sum) * r.high * (1.0 / n);
    const double above = r.high * r.high / 2 * (1 + sum) + (r.low + r.low * r.high);
    return std::ldexp(1.0 + (r.high + above), static_cast<int>(k));
}

bool is_odd(double y) { return std::abs(y) < 0x1p53 && std::fmod(y, 2) != 0 && std::floor(y) == y; }

/// Computes |x|^y if x or y is 0 or infinite; y must not be 0.
double pow_at_the_ends(double x, double y) {
    if (x == 1) return 1;
    return (x > 1) == (y > 0) ? infinity : 0;
}

/// Computes x^y for x > 0, both finite.
double pow_of_positive(double x, double y) {
    if (x == 1 || std::abs(y) < 0x1p-70) return 1;
    if (std::abs(y) > 0x1p65) return (x > 1) == (y > 0) ? infinity : 0;
    const Double2 log = long_log(x);
    Double2 product = product_of(y, log.high);
    if (product.high > 1100) return infinity;
    if (product.high < -1100) return 0;
    product.low += y * log.low;
    return long_exp(product);
}

}  // namespace

double exp(double x) {
    if (std::isnan(x)) return no_number;
    if (x > 709.782712893384) return infinity;
    if (x < -745.2) return 0;
    const double k = std::floor(x / (ln2_high + ln2_low) + 0.5);
    const double r = (x - k * ln2_high) - k * ln2_low;
    double sum = 0;
    for (int n = 14; n >= 2; --n) sum = (1.0 + sum) * r / static_cast<double>(n);
    return std::ldexp(1.0 + (r + r * sum), static_cast<int>(k));
}

std::array<double, 8> exp8(const std::array<double, 8>& x) {
    constexpr double largest = 700;  // up to this |x|, the factor 2^k of exp(x) is a normal number
    const bool is_usual = std::ranges::all_of(x, [](double one) { return std::abs(one) <= largest; });
    std::array<double, 8> result{};
    if (!is_usual) {
        std::ranges::transform(x, result.begin(), [](double one) { return exp(one); });
        return result;
    }
    constexpr double whole = 0x1.8p52;  // adding and subtracting it rounds to an integer
    std::array<Doubles4, 2> k, r, sum{};
    for (std::size_t h = 0; h < 2; ++h) {
        const auto four = four_at<Doubles4>(&x[4 * h]);
        const Doubles4 shifted = four / (ln2_high + ln2_low) + 0.5, rounded = (shifted + whole) - whole;
        k[h] = rounded > shifted ? rounded - 1.0 : rounded;
        r[h] = (four - k[h] * ln2_high) - k[h] * ln2_low;
    }
    for (int n = 14; n >= 2; --n)
        for (std::size_t h = 0; h < 2; ++h) sum[h] = (1.0 + sum[h]) * r[h] / static_cast<double>(n);
    for (std::size_t h = 0; h < 2; ++h) {
        const auto exponent = (std::bit_cast<Integers4>(k[h] + whole) + 1023) << 52;
        const Doubles4 four = (1.0 + (r[h] + r[h] * sum[h])) * std::bit_cast<Doubles4>(exponent);
        put_four(&result[4 * h], four);
    }
    return result;
}

double log(double x) {
    if (std::isnan(x) || x < 0) return no_number;
    if (x == 0) return -infinity;
    if (std::isinf(x)) return x;
    int exponent = 0;
    double mantissa = std::frexp(x, &exponent);  // frexp gives a mantissa in [0.5, 1)
    if (mantissa < 0.70710678118654752) {
        mantissa *= 2;
        --exponent;
    }
    // log m = 2 atanh s with s = (m - 1) / (m + 1) and |s| <= 0.172.
    const double s = (mantissa - 1) / (mantissa + 1);
    const double q = s * s;
    double sum = 0;
    for (int n = 21; n >= 3; n -= 2) sum = q * (1.0 / static_cast<double>(n) + sum);
    const double k = exponent;
    return k * ln2_high + (2 * s + (2 * s * sum + k * ln2_low));
}

double pow(double x, double y) {
    if (y == 0 || x == 1) return 1;
    if (std::isnan(x) || std::isnan(y)) return no_number;
    const double size = std::abs(x);
    if (std::signbit(x) && size != 0 && std::isfinite(x) && std::isfinite(y) && std::floor(y) != y)
        return no_number;
    const bool ends = size == 0 || std::isinf(size) || std::isinf(y);
    const double value = ends ? pow_at_the_ends(size, y) : pow_of_positive(size, y);
    return std::signbit(x) && is_odd(y) ? -value : value;
}

}  // namespace thaum::det
