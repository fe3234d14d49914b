#include "haptics/oscillator.h"

#include <array>
#include <cmath>

#include "core/maths.h"

// Three methods compute S and its integrals (oscillator.h): by_series, by_two_rates and by_equation, each
// where it loses no digits. Times are in units of t. With x = decay t and q = frequency2 t^2, the roots of
// the characteristic polynomial are -x +- sqrt(z), where z = x^2 - q.
namespace thaum::haptics {
namespace {

// Largest x = decay t for which the series is used. For a larger x and q = frequency2 t^2 <= 1, z = x^2 - q
// is above 1, so `by_two_rates` is accurate.
constexpr double max_x_of_series = 1.5;

constexpr int max_terms = 40;  // largest number of terms of the series; enough for x = 1.5, most calls need 8

/// Tables of 1 / ((n + 1) n), 1 / (n + 2) and 1 / ((n + 2) (n + 3)). A division would take as long as all
/// else that a term of the series needs.
struct Reciprocals {
    std::array<double, max_terms + 1> term{}, once{}, twice{};
    constexpr Reciprocals() {
        for (std::size_t i = 1; i < term.size(); ++i) {
            const auto n = static_cast<double>(i);
            term[i] = 1 / ((n + 1) * n);
            once[i] = 1 / (n + 2);
            twice[i] = 1 / ((n + 2) * (n + 3));
        }
    }
};
constexpr Reciprocals reciprocals;

/// Sums the Taylor series of S and its integrals. The sum is accurate for q <= 1 and small x.
Response by_series(double x, double q) {
    Response r{.t = 1, .s = 1, .s1 = 0.5, .s2 = 1.0 / 6};
    double before = 0, term = 1, factor = 0;
    for (std::size_t n = 1; n <= max_terms; ++n) {
        factor += 2 * x;  // the factor is 2 x n now
        const double next = -(factor * term + q * before) * reciprocals.term[n];
        before = term;
        term = next;
        r.s += term;
        r.s1 += term * reciprocals.once[n];
        r.s2 += term * reciprocals.twice[n];
        if (std::abs(term) + std::abs(before) < 1e-19) break;
    }
    return r;
}

/// (1 - e^-x) / x, without loss of digits at small x
double phi1(double x) {
    if (x > 0.5) return (1 - det::exp(-x)) / x;
    double sum = 0;
    for (int n = 16; n >= 2; --n) sum = (1 + sum) * -x / n;
    return 1 + sum;
}

/// (1 - phi1(x)) / x, without loss of digits at small x
double phi2(double x) {
    if (x > 0.5) return (1 - phi1(x)) / x;
    double sum = 0;
    for (int n = 17; n >= 3; --n) sum = (1 + sum) * -x / n;
    return (1 + sum) / 2;
}

/// S and its integrals as differences of two exponentials, e^-slow and e^-fast. For z > 1 and `slow` < 1 the
/// two decay rates are so far apart that the subtraction loses no digits.
Response by_two_rates(double slow, double fast) {
    const double apart = fast - slow;
    return {.t = 1,
            .s = (det::exp(-slow) - det::exp(-fast)) / apart,
            .s1 = (phi1(slow) - phi1(fast)) / apart,
            .s2 = (phi2(slow) - phi2(fast)) / apart};
}

struct Waves {
    double c,
        s;  // e^-x cosh(sqrt z) and e^-x sinh(sqrt z) / sqrt z; both are smooth at z = 0
};

/// A number as the sum of two doubles, so that a product of doubles is exact (Dekker 1971). A fused
/// multiply-add would do it too, but old processors have none.
struct Twofold {
    double high{}, low{};
};

Twofold halves(double a) {
    const double scaled = 134217729 * a;  // 2^27 + 1, which splits the digits of `a` into two halves
    const double high = scaled - (scaled - a);
    return {high, a - high};
}

Twofold product(double a, double b) {
    const Twofold p = halves(a), q = halves(b);
    const double high = a * b;
    return {high, ((p.high * q.high - high) + p.high * q.low + p.low * q.high) + p.low * q.low};
}

/// The oscillator with times in units of t (see the top of this file).
struct Scaled {
    double x{}, q{};
    double z{};          ///< x^2 - q; negative: the oscillator is underdamped
    double x_rounded{};  ///< rounding error of x: the exact product decay t minus x
};

// value of x = decay t from which the rounding of x^2 matters to z = x^2 - q
constexpr double rounding_matters_from = 8;

/// Computes x = decay t, q = frequency2 t^2 and z = x^2 - q. Near critical damping with large x, z is a small
/// difference of large numbers, so their rounding would be a large error of z. There the products are
/// computed exactly.
Scaled scaled(Oscillator o, double t) {
    const double x = o.decay * t, q = o.frequency2 * t * t;
    const double z = x * x - q;
    if (!(x > rounding_matters_from && std::abs(z) < x * x / 2)) return {x, q, z, 0};
    const Twofold decayed = product(o.decay, t), once = product(o.frequency2, t);
    const Twofold square = product(x, x), twice = product(once.high, t);
    const double low = square.low + 2 * x * decayed.low - twice.low - once.low * t;
    return {x, q, (square.high - twice.high) + low, decayed.low};
}

Waves waves(const Scaled& in) {
    const auto [x, q, z, x_rounded] = in;
    if (z > 16 || (z > 1 && x <= rounding_matters_from)) {
        const double root = std::sqrt(z);
        const double rising = det::exp(-q / (x + root));  // exponent root - x, without the loss of digits of
                                                          // that subtraction
        const double falling = det::exp(-root - x);
        return {(rising + falling) / 2, (rising - falling) / (2 * root)};
    }
    const double decayed = det::exp(-x) * (1 - x_rounded);
    if (z > 1) {  // the exponents of the case above would be large here, and their rounding would matter
        const double root = std::sqrt(z), up = det::exp(root), down = det::exp(-root);
        return {decayed * (up + down) / 2, decayed * (up - down) / (2 * root)};
    }
    if (z < -1) {
        const double root = std::sqrt(-z);
        return {decayed * det::cos(root), decayed * det::sin(root) / root};
    }
    double c = 0, s = 0;
    for (int n = 10; n >= 1; --n) {
        c = (1 + c) * z / (2.0 * n * (2.0 * n - 1));
        s = (1 + s) * z / (2.0 * n * (2.0 * n + 1));
    }
    return {decayed * (1 + c), decayed * (1 + s)};
}

/// Derives the integrals of S from the oscillator's equation, for all cases that suit neither of the other
/// two methods.
Response by_equation(const Scaled& in) {
    const double x = in.x, q = in.q;
    const auto [c, s] = waves(in);
    Response r{.t = 1, .s = s};
    r.s1 = (1 - (c + x * s)) / q;
    r.s2 = (1 - 2 * x * r.s1 - r.s) / q;
    return r;
}

Response in_units_of_t(const Scaled& in) {
    const auto [x, q, z, x_rounded] = in;
    if (x <= max_x_of_series && q <= 1) return by_series(x, q);
    if (z > 1) {
        const double fast = x + std::sqrt(z);
        const double slow = q / fast;
        if (slow < 1) return by_two_rates(slow, fast);
    }
    return by_equation(in);
}

}  // namespace

Response response(Oscillator o, double t) {
    const Response unit = in_units_of_t(scaled(o, t));
    return {.t = t, .s = unit.s * t, .s1 = unit.s1 * t * t, .s2 = unit.s2 * t * t * t};
}

}  // namespace thaum::haptics
