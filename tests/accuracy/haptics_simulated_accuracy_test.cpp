// Compares the simulated device's motion with closed forms: without dry friction, with it, and when the
// motion stops and starts again.
#include <gtest/gtest.h>

#include "core/random.h"
#include "unit/haptics_oracle.h"
#include "unit/haptics_rig.h"

namespace thaum::haptics {
namespace {

using oracle::Real;

constexpr double max_error = 1e-9;  // largest relative error allowed

/// Hands that hold the reference device under-damped, critically damped and over-damped.
struct Grip {
    const char* name;
    Hand hand;
};

// Hand and device together weigh 0.25 kg, except with the lighter last hand. The device has a damping of 0.5
// N s/m, so damping is critical if the hand's damping + 0.5 = 2 sqrt(400 * 0.25) = 20.
constexpr Grip grips[] = {
    {"loose", {.mass = 0.15, .stiffness = 400, .damping = 3, .max_target_speed = 1e9}},
    {"nearly critical", {.mass = 0.15, .stiffness = 400, .damping = 19.5001, .max_target_speed = 1e9}},
    {"stiff and dry", {.mass = 0.15, .stiffness = 400, .damping = 90, .max_target_speed = 1e9}},
    {"very stiff", {.mass = 0.01, .stiffness = 90'000, .damping = 0, .max_target_speed = 1e9}},
};

struct System {
    SimulatedDevice device;
    Real m, b, k, hand_damping;

    explicit System(const Hand& hand)
        : device(simulated_device(reference_spec(), hand)),
          m(Real(0.1) + Real(hand.mass)),
          b(Real(0.5) + Real(hand.damping)),
          k(hand.stiffness),
          hand_damping(hand.damping) {}

    oracle::Motion free(oracle::Motion start, Real t) const {
        return oracle::free_motion(b / (2 * m), k / m, start, t);
    }
};

void expect_close(double value, Real exact, Real scale, const char* what) {
    EXPECT_LE(std::abs(Real(value) - exact), Real(max_error) * scale) << what;
}

TEST(HapticsSimulatedAccuracy, FreeDecay) {
    for (const auto& grip : grips) {
        const System system(grip.hand);
        auto state = resting_at({});
        state.position.x = 0.03;
        state.velocity.x = -0.2;
        for (int tick = 1; tick <= 1000; ++tick) {
            state = step(system.device, state, {}, {});
            const auto exact = system.free({Real(0.03), Real(-0.2)}, Real(tick) / 1000);
            expect_close(state.position.x, exact.x, 0.03L, grip.name);
            expect_close(state.velocity.x, exact.v, 0.2L, grip.name);
        }
    }
}

TEST(HapticsSimulatedAccuracy, ConstantForce) {
    for (const auto& grip : grips) {
        const System system(grip.hand);
        auto state = resting_at({});
        const Real sag = Real(1.5) / system.k;
        for (int tick = 1; tick <= 1000; ++tick) {
            state = step(system.device, state, {}, {0, -1.5, 0});
            const auto exact = system.free({sag, 0}, Real(tick) / 1000);
            expect_close(state.position.y, exact.x - sag, sag, grip.name);
        }
    }
}

TEST(HapticsSimulatedAccuracy, ConstantForceOnTheBareDevice) {
    const auto device = simulated_device(reference_spec(), no_hand);
    auto state = resting_at({});
    for (int tick = 1; tick <= 1000; ++tick) {
        state = step(device, state, {}, {2, 0, 0});
        const Real t = Real(tick) / 1000, rate = Real(0.5) / Real(0.1);
        const Real v = 4 * (1 - std::exp(-rate * t));  // terminal velocity 4 m/s: 2 N over 0.5 N s/m
        expect_close(state.velocity.x, v, 4, "velocity");
        expect_close(state.position.x, 4 * t - v / rate, 4, "position");
    }
}

TEST(HapticsSimulatedAccuracy, RampTarget) {
    for (const auto& grip : grips) {
        const System system(grip.hand);
        auto state = resting_at({});
        constexpr Real w = 0.25L;
        // Steady state: the device lags behind the target, because of damping relative to the ground.
        const Real lag = Real(0.5) * w / system.k;
        for (int tick = 1; tick <= 1000; ++tick) {
            const Real t = Real(tick) / 1000;
            state = step(system.device, state, {0, 0, static_cast<double>(w * t)}, {});
            const auto exact = system.free({lag, -w}, t);  // relative to the steady motion: x - (w t - lag)
            expect_close(state.position.z, exact.x + w * t - lag, w, grip.name);
            expect_close(state.velocity.z, exact.v + w, w, grip.name);
        }
    }
}

// ---- a device with dry friction ---------------------------------------------------------------------------

SimulatedDevice with_friction(const Hand& hand, double friction, double damping, double dt = 1e-3) {
    auto spec = reference_spec();
    spec.coulomb_friction = friction;
    spec.damping = damping;
    return simulated_device(spec, hand, dt);
}

TEST(HapticsSimulatedAccuracy, FrictionStopsASlideWhereItShould) {
    const auto device = with_friction(no_hand, 0.3, 0);
    for (const double speed : {1e-6, 0.001, 0.123, 1.7}) {
        auto state = resting_at({});
        state.velocity.x = speed;
        for (int tick = 0; tick < 2000; ++tick) state = step(device, state, {}, {});
        EXPECT_EQ(state.velocity.x, 0);
        const Real way = Real(0.1) * Real(speed) * Real(speed) / (2 * Real(0.3));
        expect_close(state.position.x, way, way, "way to stop");
    }
}

TEST(HapticsSimulatedAccuracy, AnUndampedSpringLosesTwoBandsAnHalfSwing) {
    // An oscillator with stiffness k and dry friction F. Each half swing is a half cosine around -F/k or
    // +F/k, so each turning point is nearer to the middle by 2 F/k. The mass stops at the first turning point
    // within +-F/k.
    constexpr double k = 400, friction = 0.26;
    const auto device =
        with_friction({.mass = 0.15, .stiffness = k, .damping = 0, .max_target_speed = 1e9}, friction, 0);
    const Real band = Real(friction) / k, half = std::acos(Real(-1)) * std::sqrt(Real(0.25) / k);
    auto state = resting_at({});
    state.position.x = 0.02;
    const auto exact = [&](Real t) {
        Real amplitude = 0.02L, sign = 1;
        while (t > half && amplitude > band) {
            amplitude -= 2 * band;
            sign = -sign;
            t -= half;
        }
        if (amplitude <= band) return sign * amplitude;
        return sign * (band + (amplitude - band) * std::cos(std::sqrt(k / 0.25L) * t));
    };
    int stops = 0;
    for (int tick = 1; tick <= 2000; ++tick) {
        state = step(device, state, {}, {});
        expect_close(state.position.x, exact(Real(tick) / 1000), 0.02L, "dry oscillator");
        if (state.velocity.x == 0) ++stops;
    }
    EXPECT_GT(stops, 500);
}

TEST(HapticsSimulatedAccuracy, ARampLetsGoAtTheMomentItShould) {
    constexpr double k = 400, friction = 0.26, w = 0.0371;
    const auto device =
        with_friction({.mass = 0.15, .stiffness = k, .damping = 0, .max_target_speed = 1e9}, friction, 0);
    const Real go = Real(friction) / (k * Real(w)), rate = std::sqrt(Real(k) / Real(0.25));
    auto state = resting_at({});
    // The test ends just before the mass would stop at the next turning point.
    for (int tick = 1; tick <= 90; ++tick) {
        const Real t = Real(tick) / 1000;
        state = step(device, state, {static_cast<double>(Real(w) * t), 0, 0}, {});
        const Real u = t - go;
        const Real exact = u <= 0 ? 0 : Real(w) * (u - std::sin(rate * u) / rate);
        expect_close(state.position.x, exact, 1e-3L, "stick and slip");
    }
}

TEST(HapticsSimulatedAccuracy, StickAndSlipDoNotDependOnTheTick) {
    // The target's velocity and the force are constant. The motion is simulated with ticks of 1/8, 1 and 8
    // ms. The longer a tick, the more stops and starts of the motion fall into it.
    const Hand hand{.mass = 0.15, .stiffness = 400, .damping = 2, .max_target_speed = 1e9};
    const auto run = [&hand](int ticks_per_8_ms) {
        const auto device = with_friction(hand, 0.26, 0.2, 8e-3 / ticks_per_8_ms);
        auto state = resting_at({});
        Random random{11};
        std::vector<double> places;
        vec3 target{};
        for (int i = 0; i < 500; ++i) {
            const vec3 next{random.uniform(-0.004, 0.004), 0, 0};
            const vec3 force{random.uniform(-1, 1), 0, 0};
            for (int j = 1; j <= ticks_per_8_ms; ++j)
                state = step(device, state, target + (next - target) * (double(j) / ticks_per_8_ms), force);
            target = next;
            places.push_back(state.position.x);
        }
        return places;
    };
    const auto fine = run(64), usual = run(8), coarse = run(1);
    double worst = 0;
    for (std::size_t i = 0; i < fine.size(); ++i)
        worst = std::max({worst, std::abs(fine[i] - usual[i]), std::abs(fine[i] - coarse[i])});
    EXPECT_LE(worst, 1e-12);
    RecordProperty("worst_m", std::to_string(worst * 1e15) + "e-15");
}

}  // namespace
}  // namespace thaum::haptics
