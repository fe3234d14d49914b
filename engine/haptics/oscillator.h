// haptics/oscillator.h: closed-form solution of the damped oscillator.
//
//     x'' + 2 decay x' + frequency2 x = 0
//
// S is the motion after a start with unit velocity: S(0) = 0, S'(0) = 1. S and its integrals S1 and S2
// describe all motion under forces that stay constant over the time t. With the start velocity v, the start
// acceleration a, and the constant velocity w of the spring's other end:
//
//     v(t) = v + S a + frequency2 S1 (w - v)         (obeys v'' + 2 decay v' + frequency2 (v - w) = 0)
//     x(t) = x + t v + S1 a + frequency2 S2 (w - v)  (the integral of v)
//
// Neither equation subtracts large, nearly equal numbers, for any stiffness including zero. A step therefore
// has rounding error only, whatever its length. The textbook's three formulas (under-, critically,
// over-damped) lose half the digits near critical damping. For a weak spring they lose digits in the
// integrals too.
#pragma once

namespace thaum::haptics {

/// Constants of a damped oscillator, x'' + 2 decay x' + frequency2 x = 0.
struct Oscillator {
    double decay{};  ///< damping / (2 mass), >= 0 (1/s)
    /// Stiffness / mass, the square of the undamped angular frequency, >= 0 (1/s^2).
    double frequency2{};
};

/// Oscillator of a mass (kg, > 0) with damping (N s/m, >= 0) and stiffness (N/m, >= 0).
constexpr Oscillator oscillator(double mass, double damping, double stiffness) {
    return {damping / (2 * mass), stiffness / mass};
}

/// S(t), the motion after a start with unit velocity, and its first and second integral from 0 to t.
struct Response {
    double t{};   ///< time (s)
    double s{};   ///< S: displacement at t after a start with unit velocity (s)
    double s1{};  ///< S1: integral of S from 0 to t (s^2)
    double s2{};  ///< S2: integral of S1 from 0 to t (s^3)
};

/// Computes S and its integrals at t >= 0. NaN if sqrt(frequency2) t is above 1e9. The relative error of each
/// is below 1e-13 if sqrt(frequency2) t <= 300, also at critical damping (tests/accuracy). Results have the
/// same bits on every processor. S passes through zero, and so does S1 without damping. Near those zeros the
/// error is relative to the amplitude.
Response response(Oscillator o, double t);

/// Derivative of S at t: the velocity of an oscillator that started with unit velocity.
constexpr double slope(Oscillator o, const Response& r) {
    return 1 - 2 * o.decay * r.s - o.frequency2 * r.s1;
}

}  // namespace thaum::haptics
