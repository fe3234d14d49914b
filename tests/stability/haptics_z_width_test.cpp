// Z-width: compares the simulated device with the theory of sampled walls, and with published simulations.
#include "tests/scenes/z_width.h"

#include <gtest/gtest.h>

namespace thaum::bench {
namespace {

TEST(HapticsZWidth, TheExactLimitIsThatOfTheClosedForm) {
    // Without latency, Jury's condition on the constant term of wall_polynomial() is K (a b2 - b1 e) < 1 - e.
    for (const double b : {0.2, 0.5, 1.0, 5.0}) {
        const double lost = 1 - std::exp(-b * 1e-3 / 0.1), e = 1 - lost;
        const double a = lost * 0.1 / b;
        const double limit = lost / (a * lost / b - (1e-3 - a) / b * e);
        EXPECT_NEAR(exact_limit(reference_device(b, 0)), limit, 1e-6 * limit);
    }
}

TEST(HapticsZWidth, EigenvaluesAreOnTheUnitCircleAtTheLimit) {
    for (const int latency : {0, 1, 2, 5}) {
        const auto spec = reference_device(0.5, latency);
        const double k = exact_limit(spec);
        EXPECT_TRUE(is_stable(wall_polynomial(spec, 0.999 * k)));
        // At the limit, the growth factor of the loop per tick, found by iteration, is 1.
        const auto p = wall_polynomial(spec, k);
        std::vector<double> y(p.size() - 1, 0.0);
        y.back() = 1;
        double early = 0, late = 0;
        for (int n = 0; n < 200'000; ++n) {
            double next = 0;
            for (std::size_t i = 0; i < y.size(); ++i) next -= p[i] * y[i];
            y.erase(y.begin());
            y.push_back(next);
            if (n >= 10'000 && n < 20'000) early = std::max(early, std::abs(next));
            if (n >= 190'000) late = std::max(late, std::abs(next));
        }
        EXPECT_NEAR(late / early, 1, 1e-3) << latency;
    }
}

TEST(HapticsZWidth, TheSimulatedDeviceReproducesTheTheory) {
    for (const double b : {0.2, 0.5, 1.0}) {
        for (const int latency : {0, 1}) {
            const auto spec = reference_device(b, latency);
            const double simulated = simulated_limit(spec), exact = exact_limit(spec);
            EXPECT_NEAR(simulated, exact, 0.01 * exact) << b << " N s/m, latency " << latency;
            const double passive = passive_stiffness(b, latency);
            EXPECT_NEAR(simulated, passive, 0.1 * passive) << b << " N s/m, latency " << latency;
            RecordProperty(
                "b" + std::to_string(b) + "_" + std::to_string(latency),
                std::to_string(simulated) + " " + std::to_string(exact) + " " + std::to_string(passive));
        }
    }
}

struct Published {
    double damping;
    int latency;
    double stiffness;
};

/// The first unstable stiffness among 50, 51.5, ... N/m in steps of 3 %, as in the published simulations.
double first_that_shakes(const haptics::DeviceSpec& spec) {
    double k = 50;
    while (wall_calms_down(spec, k)) k *= 1.03;
    return k;
}

TEST(HapticsZWidth, PublishedSimulationsAgree) {
    // With latency, the figures agree on the same step. Without it, the published ones are two or three steps
    // (up to 10 %) above the loop's own limit. Just above the limit the oscillation grows so slowly that the
    // published simulations missed it. Our figure is the first step above the limit.
    for (const auto& p : {Published{0.2, 0, 433}, Published{0.5, 0, 1082}, Published{0.5, 1, 341},
                          Published{1.0, 0, 2199}, Published{1.0, 1, 674}}) {
        const auto spec = reference_device(p.damping, p.latency);
        const double shakes = first_that_shakes(spec);
        EXPECT_NEAR(shakes, p.stiffness, (p.latency > 0 ? 0.005 : 0.1) * p.stiffness) << p.damping;
        EXPECT_GE(shakes, exact_limit(spec));
        EXPECT_LE(shakes, exact_limit(spec) * 1.03);
    }
}

TEST(HapticsZWidth, AnEncoderCostsLittle) {
    for (const double b : {0.2, 0.5, 1.0}) {
        for (const int latency : {0, 1}) {
            auto spec = reference_device(b, latency);
            const double exact = exact_limit(spec);
            spec.position_quantum = 5.5e-5;
            EXPECT_NEAR(simulated_limit(spec, 0.02), exact, 0.03 * exact) << b << " " << latency;
        }
    }
}

TEST(HapticsZWidth, DryFrictionSwallowsASmallShake) {
    auto spec = reference_device(0.5, 0);
    const double bare = simulated_limit(spec);
    spec.coulomb_friction = 0.05;
    EXPECT_GT(simulated_limit(spec), 2 * bare);
}

TEST(HapticsZWidth, WithDampingAndControllerAWallOf1000IsDeliveredAtOneTickOfDelay) {
    const auto spec = reference_device(0.5, 1);
    constexpr double newtons = 2;
    EXPECT_LE(delivered_limit(spec, {}, newtons),
              exact_limit(spec));  // limit without damping and controller: 334 N/m, and less after a landing
    EXPECT_GE(delivered_limit(spec, {.damping = 2, .controller = 5}, newtons), 2000);
    // The passivity controller acts alone, without damping of the wall.
    EXPECT_GE(delivered_limit(spec, {.controller = 5}, newtons), 1500);
    for (const double stiffness : {1000.0, 1500.0, 2000.0}) {
        const Pressed at = pressed(spec, {stiffness, 2, 5}, newtons);
        EXPECT_LE(at.depth + at.shake, 1.1 * newtons / stiffness) << stiffness;
        EXPECT_NEAR(at.depth, newtons / stiffness, 1e-3 * newtons / stiffness)
            << stiffness;                              // the wall is as stiff as its setting says
        EXPECT_LE(at.added_later, 0.05) << stiffness;  // once settled, stiffness alone acts (N)
        EXPECT_LE(at.created, 0.02) << stiffness;
    }
    // Without damping and controller, the device oscillates strongly on the wall of 1,000 N/m.
    EXPECT_GT(pressed(spec, {.stiffness = 1000}, newtons).shake, 0.5 * newtons / 1000);
}

TEST(HapticsZWidth, AFalconsEncoderKeepsAWallOf1000AtOneTickOfDelay) {
    // The passivity controller may add damping of up to 20 N s/m here, at which one encoder count of 53 um
    // per tick would mean 1 N.
    auto spec = reference_device(0.5, 1);
    spec.position_quantum = 5.3e-5;
    constexpr double newtons = 2;
    for (const double damping : {0.0, 2.0}) {
        for (double stiffness = 600; stiffness < 1200; stiffness *= 1.03) {
            const Pressed at = pressed(spec, {stiffness, damping, 20}, newtons);
            EXPECT_LE(at.depth + at.shake, 1.1 * newtons / stiffness) << stiffness << " " << damping;
            EXPECT_LE(at.created, 0.02) << stiffness << " " << damping;
        }
    }
}

TEST(HapticsZWidth, AControllerOfMoreThanTheLoopBearsShakesByItself) {
    // The wall's damping uses a velocity averaged over some ticks, which is late. So the limit of the
    // device's own damping counts, not the largest number that may be set.
    const auto spec = reference_device(0.5, 1);
    EXPECT_LT(delivered_limit(spec, {.damping = 2, .controller = 1000}, 2),
              delivered_limit(spec, {.damping = 2, .controller = 5}, 2) / 2);
}

}  // namespace
}  // namespace thaum::bench
