// haptics/oscillator.h: the damped oscillator over a time t, in closed form.
//
//     x'' + 2 decay x' + frequency2 x = 0
//
// S is its answer to a unit of velocity: S(0) = 0, S'(0) = 1. S and its integrals are enough for everything that happens
// under forces which stay constant for t. With the velocity v, the acceleration a and the velocity w of the spring's other
// end (constant too), all at the start,
//
//     v(t) = v + S a + frequency2 S1 (w - v)            (velocity obeys v'' + 2 decay v' + frequency2 (v - w) = 0)
//     x(t) = x + t v + S1 a + frequency2 S2 (w - v)     (its integral)
//
// Neither line subtracts large numbers that are nearly equal, be the spring weak, stiff or absent; so a step has rounding
// error only, whatever its length. That is what these functions are for: the textbook's three formulas (under-,
// critically, over-damped) lose half the digits near critical damping and, for a weak spring, in the integrals.
#pragma once

namespace thaum::haptics {

struct Oscillator {
    double decay{};       ///< 1/s, damping / (2 mass), >= 0
    double frequency2{};  ///< 1/s^2, stiffness / mass, >= 0: the square of the undamped angular frequency
};

/// Of mass kg > 0, damping N s/m >= 0, stiffness N/m >= 0.
constexpr Oscillator oscillator(double mass, double damping, double stiffness) {
    return {damping / (2 * mass), stiffness / mass};
}

/// S(t) and its first and second integral from 0 to t.
struct Response {
    double t{};   ///< s
    double s{};   ///< s
    double s1{};  ///< s^2
    double s2{};  ///< s^3
};

/// t >= 0; NaN where sqrt(frequency2) t is above 1e9. Relative error of each below 1e-13 where sqrt(frequency2) t <= 300, at critical
/// damping too (tests/accuracy); the same bits on every processor. S and, undamped, S1 pass through zero; near there the error is relative to their swing.
Response response(Oscillator o, double t);

/// S'(t).
constexpr double slope(Oscillator o, const Response& r) {
    return 1 - 2 * o.decay * r.s - o.frequency2 * r.s1;
}

}  // namespace thaum::haptics
