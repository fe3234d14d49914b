#include "haptics/oscillator.h"

#include <array>
#include <cmath>

#include "core/maths.h"

// Three ways, each where it loses no digits; all in the units of t. With x = decay t and q = frequency2 t^2 the roots of the
// characteristic polynomial are -x +- sqrt(z), z = x^2 - q.
namespace thaum::haptics {
namespace {

constexpr double most_x_of_series = 1.5;  // then z > 1 wherever q <= 1 and the series is not used

constexpr int most_terms = 40;  // for x = 1.5; most calls need 8

/// 1 / ((n + 1) n), 1 / (n + 2), 1 / ((n + 2) (n + 3)): a division takes as long as all the rest of a term.
struct Reciprocals {
    std::array<double, most_terms + 1> term{}, once{}, twice{};
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

/// q <= 1, x small: S's Taylor series and its integrals, term by term.
Response by_series(double x, double q) {
    Response r{.t = 1, .s = 1, .s1 = 0.5, .s2 = 1.0 / 6};
    double before = 0, term = 1, factor = 0;
    for (std::size_t n = 1; n <= most_terms; ++n) {
        factor += 2 * x;  // 2 x n
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

/// (1 - e^-x) / x
double phi1(double x) {
    if (x > 0.5) return (1 - det::exp(-x)) / x;
    double sum = 0;
    for (int n = 16; n >= 2; --n) sum = (1 + sum) * -x / n;
    return 1 + sum;
}

/// (1 - phi1(x)) / x
double phi2(double x) {
    if (x > 0.5) return (1 - phi1(x)) / x;
    double sum = 0;
    for (int n = 17; n >= 3; --n) sum = (1 + sum) * -x / n;
    return (1 + sum) / 2;
}

/// z > 1, slow root below 1: sums of two exponentials, whose rates are far enough apart to be subtracted.
Response by_two_rates(double slow, double fast) {
    const double apart = fast - slow;
    return {.t = 1,
            .s = (det::exp(-slow) - det::exp(-fast)) / apart,
            .s1 = (phi1(slow) - phi1(fast)) / apart,
            .s2 = (phi2(slow) - phi2(fast)) / apart};
}

struct Waves {
    double c,
        s;  // e^-x cosh(sqrt z), e^-x sinh(sqrt z) / sqrt z: entire functions of z, so nothing happens at z = 0
};

Waves waves(double x, double q) {
    const double z = x * x - q;
    if (z > 1) {
        const double root = std::sqrt(z);
        const double rising = det::exp(-q / (x + root));  // x - root would cancel
        const double falling = det::exp(-root - x);
        return {(rising + falling) / 2, (rising - falling) / (2 * root)};
    }
    const double decayed = det::exp(-x);
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

/// q > 1 and no slow root: the oscillator's own equation, integrated once and twice, gives the integrals.
Response by_equation(double x, double q) {
    const auto [c, s] = waves(x, q);
    Response r{.t = 1, .s = s};
    r.s1 = (1 - (c + x * s)) / q;
    r.s2 = (1 - 2 * x * r.s1 - r.s) / q;
    return r;
}

Response in_units_of_t(double x, double q) {
    if (x <= most_x_of_series && q <= 1) return by_series(x, q);
    const double z = x * x - q;
    if (z > 1) {
        const double fast = x + std::sqrt(z);
        const double slow = q / fast;
        if (slow < 1) return by_two_rates(slow, fast);
    }
    return by_equation(x, q);
}

}  // namespace

Response response(Oscillator o, double t) {
    const Response unit = in_units_of_t(o.decay * t, o.frequency2 * t * t);
    return {.t = t, .s = unit.s * t, .s1 = unit.s1 * t * t, .s2 = unit.s2 * t * t * t};
}

}  // namespace thaum::haptics
