// Compares the coupling (the spring and damper between a hand and an object) with exact solutions, for all
// stiffnesses, masses, dampings and steps that a game may use.
#include <gtest/gtest.h>

#include "haptics/coupling.h"
#include "unit/haptics_oracle.h"

namespace thaum::haptics {
namespace {

using oracle::Real;

double relative(double value, Real exact, Real scale) {
    return static_cast<double>(std::abs(Real(value) - exact) / scale);
}

/// The hand moves at constant velocity and the object follows. Compares velocity change and displacement over
/// one step with the result of small steps in long double.
double error_with_prescribed_hand(double stiffness, double damping, double mass, double dt) {
    const auto step = coupling_step({stiffness, damping, 0}, 1 / mass, 0, dt);
    const CouplingState state{.hand = {0.3, 0, 0},
                              .hand_velocity = {-2, 0, 0},
                              .object = {0.1, 0, 0},
                              .object_velocity = {1, 0, 0}};
    const auto result = couple(step, state);
    const Real decay = Real(damping) / (2 * Real(mass)), frequency2 = Real(stiffness) / Real(mass);
    const auto [s, s1, s2] = oracle::response(decay, frequency2, dt);
    const Real e = Real(0.3) - Real(0.1), rate = -3;
    const Real velocity_change = s * (frequency2 * e + 2 * decay * rate) + frequency2 * s1 * rate;
    const Real path = Real(dt) + s1 * (frequency2 * e + 2 * decay * rate) + frequency2 * s2 * rate;
    const Real speed = std::abs(velocity_change) + 3, way = std::abs(path) + 1e-3L;
    const Real impulse_scale = Real(mass) * std::abs(velocity_change) + 1e-9L;
    return std::max({relative(result.velocity_change.x, velocity_change, speed),
                     relative(result.displacement.x, path, way),
                     relative(result.impulse.x, Real(mass) * velocity_change, impulse_scale)});
}

TEST(HapticsCoupling, IsExactAtAnyStiffnessMassDampingAndStep) {
    double worst = 0;
    for (const double k : {10.0, 1e2, 4e3, 1e5, 1e6}) {
        for (const double m : {1e-3, 1e-2, 1.0, 5.0, 120.0, 1e3}) {
            for (const double ratio : {0.0, 0.05, 0.7, 1 - 1e-9, 1.0, 1 + 1e-9, 1.5, 30.0}) {
                for (const double dt : {1e-3, 2e-3, 4e-3, 8e-3}) {
                    const double error = error_with_prescribed_hand(k, ratio * 2 * std::sqrt(k * m), m, dt);
                    EXPECT_LE(error, 1e-9)
                        << k << " N/m, " << m << " kg, ratio " << ratio << ", " << dt << " s";
                    worst = std::max(worst, error);
                }
            }
        }
    }
    RecordProperty("worst_relative_error", std::to_string(worst * 1e12) + "e-12");
}

/// Two free bodies of 1 kg (the hand) and `ratio` kg (the object), joined by a spring and damper and released
/// 0.2 m apart. Compares their state after one second with the textbook formula.
double error_of_free_pair(double stiffness, double damping_ratio, double ratio, double dt) {
    const double reduced = ratio / (1 + ratio);
    const double damping = damping_ratio * 2 * std::sqrt(stiffness * reduced);
    const auto step = coupling_step({stiffness, damping, 0}, 1 / ratio, 1, dt);
    CouplingState s{.hand = {0.2, 0, 0}};
    const auto steps = static_cast<int>(std::lround(1 / dt));
    for (int i = 0; i < steps; ++i) {
        const auto r = couple(step, s);
        const vec3 hand_change = -r.impulse;  // the hand's change of velocity, for its mass of 1 kg
        // The centre of mass is at rest, so the hand's displacement is the object's times the ratio of
        // masses, in the opposite direction.
        s.hand -= ratio * r.displacement;
        s.hand_velocity += hand_change;
        s.object += r.displacement;
        s.object_velocity += r.velocity_change;
    }
    const Real m = Real(ratio) / (1 + Real(ratio));
    const auto exact = oracle::free_motion(Real(damping) / (2 * m), Real(stiffness) / m, {0.2L, 0}, 1);
    return relative((s.hand - s.object).x, exact.x, 0.2L);
}

TEST(HapticsCoupling, AFreePairFollowsTheTextbookForASecond) {
    double worst = 0;
    for (const double k : {10.0, 1e3, 1e6}) {
        for (const double ratio : {1e-3, 1e-1, 1.0, 1e1, 1e3}) {
            for (const double damping : {0.0, 0.01, 0.5, 2.0}) {
                for (const double dt : {1e-3, 8e-3}) {
                    const double error = error_of_free_pair(k, damping, ratio, dt);
                    EXPECT_LE(error, 1e-9) << k << " N/m, ratio " << ratio << ", " << damping << ", " << dt;
                    worst = std::max(worst, error);
                }
            }
        }
    }
    RecordProperty("worst_relative_error", std::to_string(worst * 1e12) + "e-12");
}

TEST(HapticsCoupling, DragAndWeightAreIntegratedToo) {
    constexpr double m = 5, k = 4000, b = 30, drag = 200, dt = 4e-3, w = 0.7, vf = 0.2, g = -9.81;
    const auto step = coupling_step({k, b, drag}, 1 / m, 0, dt);
    CouplingState s{.hand = {0, 0.1, 0},
                    .hand_velocity = {0, w, 0},
                    .object_velocity = {0, -0.4, 0},
                    .drag_velocity = {0, vf, 0},
                    .object_acceleration = {0, g, 0}};
    vec3 total{};
    for (int i = 0; i < 250; ++i) {
        const auto r = couple(step, s);
        // The returned values satisfy Newton's second law in every step.
        EXPECT_NEAR(m * r.velocity_change.y, r.impulse.y + r.drag_impulse.y + m * g * dt, 1e-11);
        s.hand += s.hand_velocity * dt;
        s.object += r.displacement;
        s.object_velocity += r.velocity_change;
        total += r.impulse;
    }
    // The stretch e = hand - object oscillates freely around the static deflection due to drag and weight.
    const Real sag = (Real(drag) * (Real(w) - Real(vf)) - Real(m) * Real(g)) / Real(k);
    const auto exact = oracle::free_motion((Real(b) + Real(drag)) / (2 * Real(m)), Real(k) / Real(m),
                                           {0.1L - sag, Real(w) + 0.4L}, 1);
    EXPECT_NEAR((s.hand - s.object).y, static_cast<double>(exact.x + sag), 1e-12);
    EXPECT_NEAR(s.object_velocity.y, static_cast<double>(Real(w) - exact.v), 1e-11);
}

}  // namespace
}  // namespace thaum::haptics
