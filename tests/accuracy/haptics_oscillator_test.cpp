// Compares the oscillator's response with small steps in long double, for all dampings, also around critical
// damping.
#include "haptics/oscillator.h"

#include <gtest/gtest.h>

#include "unit/haptics_oracle.h"

namespace thaum::haptics {
namespace {

using oracle::Real;

/// The largest relative error of the response S to a unit velocity and of its integrals S1 and S2. S, and
/// without damping also S1, pass through zero; near there, the error is relative to their amplitude.
double worst_error(double x, double q) {
    constexpr double t = 0.003;
    const Oscillator o{.decay = x / t, .frequency2 = q / (t * t)};
    const Response r = response(o, t);
    const auto exact = oracle::response(o.decay, o.frequency2, t);
    const Real swing = Real(t) * std::exp(-Real(x)) / std::max<Real>(1, std::sqrt(Real(q)));
    const auto relative = [](double value, Real true_value, Real scale) {
        return static_cast<double>(std::abs(Real(value) - true_value) / scale);
    };
    return std::max({relative(r.s, exact[0], std::max(std::abs(exact[0]), swing)),
                     relative(r.s1, exact[1], std::max(std::abs(exact[1]), swing * swing)),
                     relative(r.s2, exact[2], std::abs(exact[2]))});
}

TEST(HapticsOscillator, ResponseIsExactAtAnyDampingAndStiffness) {
    double worst = 0;
    for (const double x : {0.0, 1e-9, 1e-4, 0.03, 0.5, 1.0, 1.49, 1.51, 2.0, 5.0, 30.0, 400.0, 5000.0}) {
        for (const double q : {0.0, 1e-12, 1e-6, 0.01, 0.3, 0.99, 1.01, 1.9, 2.5, 7.0, 40.0, 900.0, 6.4e4}) {
            const double error = worst_error(x, q);
            EXPECT_LE(error, 1e-13) << "decay t = " << x << ", frequency^2 t^2 = " << q;
            worst = std::max(worst, error);
        }
    }
    RecordProperty("worst_relative_error", std::to_string(worst * 1e16) + "e-16");
}

TEST(HapticsOscillator, NothingHappensAtCriticalDamping) {
    double worst = 0;
    for (const double x : {0.01, 0.7, 1.2, 1.6, 4.0, 7.9, 8.1, 20.0, 60.0, 150.0, 267.3, 299.0}) {
        for (double off = 1; off > 1e-17; off /= 8) {
            for (const double sign : {-1.0, 0.0, 1.0}) {
                const double error = worst_error(x, x * x * (1 + sign * std::min(off, 0.9)));
                EXPECT_LE(error, 1e-13) << x << " off by " << sign * off;
                worst = std::max(worst, error);
            }
        }
    }
    RecordProperty("worst_relative_error", std::to_string(worst * 1e16) + "e-16");
}

TEST(HapticsOscillator, TwoHalvesAreAWhole) {
    for (const double x : {0.1, 1.0, 3.0}) {
        for (const double q : {0.2, 1.0, 9.0, 500.0}) {
            const Oscillator o{x, q};
            const Response half = response(o, 0.5), whole = response(o, 1);
            // S(2 h) = S(h) (S'(h) + S'(h) + 2 decay S(h)), from the square of the matrix exponential.
            const double composed = half.s * (2 * slope(o, half) + 2 * o.decay * half.s);
            EXPECT_NEAR(composed, whole.s, 1e-14);
        }
    }
}

}  // namespace
}  // namespace thaum::haptics
