#include "core/maths.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

// Each function reduces its argument to a small interval and sums a Taylor series there, from the smallest term up.
// The number of terms makes the first one left out smaller than half an ulp.
namespace thaum::det {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// pi/2 and ln 2 in parts whose product with an integer below 2^20 (2^11) is exact.
constexpr double half_pi_high = 0x1.921fb544p+0;
constexpr double half_pi_middle = 0x1.0b4611a6p-34;
constexpr double half_pi_low = 0x1.3198a2e037073p-69;
constexpr double ln2_high = 0x1.62e42fee00000p-1;
constexpr double ln2_low = 0x1.a39ef35793c76p-33;

// x in [-pi/4, pi/4]
double sin_near_zero(double x) {
    const double q = x * x;
    double sum = 0;
    for (int n = 17; n >= 3; n -= 2) sum = (1.0 + sum) * -q / static_cast<double>(n * (n - 1));
    return x + x * sum;
}

double cos_near_zero(double x) {
    const double q = x * x;
    double sum = 0;
    for (int n = 18; n >= 4; n -= 2) sum = (1.0 + sum) * -q / static_cast<double>(n * (n - 1));
    return 1.0 + (-q / 2) * (1.0 + sum);
}

struct Reduced {
    double x;      // in [-pi/4, pi/4]
    int quadrant;  // 0..3
};

Reduced reduce(double x) {
    const double k = std::floor(x / (half_pi_high + half_pi_middle) + 0.5);
    const double high = x - k * half_pi_high;
    const double middle = k * half_pi_middle;
    const double r = high - middle;
    const double lost = (high - r) - middle;  // what the line above rounded away
    return {r + (lost - k * half_pi_low), static_cast<int>(static_cast<std::int64_t>(k) & 3)};
}

bool reducible(double x) { return std::abs(x) <= 1e9; }  // false for NaN too

constexpr double tan_16th = 0.198912367379658;     // tan(pi/16)
constexpr double tan_3_16ths = 0.668178637919299;  // tan(3 pi/16)

// |x| <= 1.001 tan(pi/16)
double atan_near_zero(double x) {
    const double q = x * x;
    double sum = 0;
    for (int n = 23; n >= 3; n -= 2) sum = -q * (1.0 / static_cast<double>(n) + sum);
    return x + x * sum;
}

// x in [0, 1]. atan x = atan t + atan((x - t) / (1 + x t)); t near tan(pi/8) has few bits, so that it is exact.
double atan_unit(double x) {
    if (x <= tan_16th) return atan_near_zero(x);
    if (x > tan_3_16ths) return pi / 4 + atan_near_zero((x - 1) / (x + 1));
    constexpr double t = 0.4140625;
    constexpr double atan_t = 0.3925701350118286;
    return atan_t + atan_near_zero((x - t) / (1.0 + x * t));
}

}  // namespace

double sin(double x) {
    if (!reducible(x)) return nan;
    if (x == 0) return x;  // the series would lose the sign of -0
    const auto [r, quadrant] = reduce(x);
    const double value = (quadrant & 1) != 0 ? cos_near_zero(r) : sin_near_zero(r);
    return (quadrant & 2) != 0 ? -value : value;
}

double cos(double x) {
    if (!reducible(x)) return nan;
    const auto [r, quadrant] = reduce(x);
    const double value = (quadrant & 1) != 0 ? sin_near_zero(r) : cos_near_zero(r);
    return quadrant == 1 || quadrant == 2 ? -value : value;
}

double tan(double x) { return sin(x) / cos(x); }

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

double exp(double x) {
    if (std::isnan(x)) return nan;
    if (x > 709.782712893384) return std::numeric_limits<double>::infinity();
    if (x < -745.2) return 0;
    const double k = std::floor(x / (ln2_high + ln2_low) + 0.5);
    const double r = (x - k * ln2_high) - k * ln2_low;
    double sum = 0;
    for (int n = 14; n >= 2; --n) sum = (1.0 + sum) * r / static_cast<double>(n);
    return std::ldexp(1.0 + (r + r * sum), static_cast<int>(k));
}

double log(double x) {
    if (std::isnan(x) || x < 0) return nan;
    if (x == 0) return -std::numeric_limits<double>::infinity();
    if (std::isinf(x)) return x;
    int exponent = 0;
    double mantissa = std::frexp(x, &exponent);  // [0.5, 1)
    if (mantissa < 0.70710678118654752) {
        mantissa *= 2;
        --exponent;
    }
    // log m = 2 atanh((m - 1) / (m + 1)), |s| <= 0.172
    const double s = (mantissa - 1) / (mantissa + 1);
    const double q = s * s;
    double sum = 0;
    for (int n = 21; n >= 3; n -= 2) sum = q * (1.0 / static_cast<double>(n) + sum);
    const double k = exponent;
    return k * ln2_high + (2 * s + (2 * s * sum + k * ln2_low));
}

double pow(double x, double y) { return exp(y * log(x)); }

}  // namespace thaum::det
