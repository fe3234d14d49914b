// Reference solution of the damped oscillator in long double, by methods other than the engine's: textbook
// closed forms where they are accurate, and Taylor steps elsewhere.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>

namespace thaum::haptics::oracle {

using Real = long double;

struct Motion {
    Real x, v;
};

/// Solution of x'' + 2 decay x' + frequency2 x = 0 from (x, v) after the time t, by the three textbook cases.
/// Not accurate near critical damping.
inline Motion free_motion(Real decay, Real frequency2, Motion start, Real t) {
    const Real d = decay * decay - frequency2;
    const Real e = std::exp(-decay * t);
    const Real b = start.v + decay * start.x;
    if (d < 0) {
        const Real w = std::sqrt(-d);
        const Real c = std::cos(w * t), s = std::sin(w * t);
        return {e * (start.x * c + b / w * s), e * (start.v * c - (decay * b / w + w * start.x) * s)};
    }
    if (d == 0) return {e * (start.x + b * t), e * (start.v - decay * b * t)};
    const Real r = std::sqrt(d);
    const Real p = -decay + r, q = -decay - r;
    const Real of_p = (start.v - q * start.x) / (p - q), of_q = (p * start.x - start.v) / (p - q);
    return {of_p * std::exp(p * t) + of_q * std::exp(q * t),
            of_p * p * std::exp(p * t) + of_q * q * std::exp(q * t)};
}

/// The oscillator's motion S after a start with unit velocity, and its integrals S1 and S2, by small steps of
/// a Taylor series: slow, but accurate at any damping.
inline std::array<Real, 3> response(Real decay, Real frequency2, Real t) {
    const Real size = std::max(2 * decay, std::sqrt(frequency2)) * t;
    const auto steps = static_cast<int>(std::ceil(4 * size)) + 1;
    const Real h = t / static_cast<Real>(steps);
    std::array<Real, 4> y{1, 0, 0, 0};  // S' (the slope of S), S, and its integrals S1 and S2
    for (int i = 0; i < steps; ++i) {
        auto term = y;
        for (int n = 1; n <= 24; ++n) {
            const Real f = h / static_cast<Real>(n);
            term = {f * (-2 * decay * term[0] - frequency2 * term[1]), f * term[0], f * term[1], f * term[2]};
            for (std::size_t k = 0; k < 4; ++k) y[k] += term[k];
        }
    }
    return {y[1], y[2], y[3]};
}

}  // namespace thaum::haptics::oracle
