// Compares the effects of paper 004 (the haptic jacket, see engine/README.md) with its formulas, written out
// independently here with the C library's functions.
#include <cmath>

#include "unit/tactile_rig.h"

namespace thaum::tactile {
namespace {

TEST(TactileGrating, HeightSlopeAndNormalAreThePapers) {
    const Grating g{0.35e-3, 12e-3};
    for (int i = -50; i <= 50; ++i) {
        const double x = i * 0.7e-3;
        const double h = g.amplitude * std::sin(2 * pi * x / g.wavelength) + g.amplitude;
        EXPECT_NEAR(height(g, x), h, 1e-17);
        const double step = 1e-8;
        const double numeric = (height(g, x + step) - height(g, x - step)) / (2 * step);
        EXPECT_NEAR(slope(g, x), numeric, 1e-7);
        const vec2 n = normal(g, x);
        EXPECT_NEAR(glm::length(n), 1, 1e-15);
        EXPECT_NEAR(glm::dot(n, vec2(1, slope(g, x))), 0, 1e-15)
            << "the normal is at a right angle to the grating";
        EXPECT_GT(n.y, 0);
    }
}

TEST(TactileGrating, DepthsAreThePapers) {
    const Grating g{2e-3, 10e-3};
    Random random = random_stream(4, 1);
    int in_both = 0, in_one = 0;
    for (int i = 0; i < 10'000; ++i) {
        const double x = random.uniform(-0.05, 0.05), z = random.uniform(-0.005, 0.008);
        const double h = 2e-3 * std::sin(2 * pi / 10e-3 * x) + 2e-3;
        EXPECT_NEAR(impact_depth(g, {x, z}), z > 0 ? 0 : h - z, 1e-15);
        EXPECT_NEAR(vibration_depth(g, {x, z}), z > h ? 0 : h - z, 1e-15);
        in_both += z <= 0;
        in_one += z > 0 && z < h;
    }
    EXPECT_GT(in_both, 1000);
    EXPECT_GT(in_one, 1000) << "only the grating itself is touched above the wall";
}

TEST(TactileGrating, TheDamperActsOnlyOnTheWayIn) {
    EXPECT_DOUBLE_EQ(reaction(5000, 2, 1e-3, 0.1), 5.2);
    EXPECT_DOUBLE_EQ(reaction(5000, 2, 1e-3, -0.1), 5.0);
    EXPECT_EQ(reaction(5000, 2, 0, 0.1), 0);
    EXPECT_EQ(reaction(5000, 2, -1e-3, 0.1), 0);
}

TEST(TactileGrating, TheSignalOfAnEffectIsTheGratingUnderItsEnvelope) {
    auto effect = plain_effect("a", {.attack = 5, .hold = 10, .decay = 20});
    effect.damping = 0.8;
    for (const auto method : {Method::impact, Method::vibration, Method::both}) {
        effect.method = method;
        for (double ms = 0; ms < 36; ms += 0.37) {
            const double shape = ms < 5 ? ms / 5 : ms < 15 ? 1 : ms < 35 ? (35 - ms) / 20 : 0;
            const double a = 2 * pi * ms / 12, amplitude = 0.6e-3;
            const double h = amplitude * (1 + std::sin(a));
            const double rate = amplitude * 2 * pi / 12e-3 * std::cos(a);
            const double force = shape * (5000 * h + 0.8 * std::max(0.0, rate)) / 5;
            const double tilt = std::atan(rate / 1.0);  // at a skin speed of 1 m/s
            const double part = method == Method::vibration ? 1 : method == Method::both ? 0.5 : 0;
            const auto found = signal(effect, 0.6, ms);
            EXPECT_NEAR(found.into_skin, force * (1 - part + part * std::cos(tilt)), 1e-12);
            EXPECT_NEAR(found.along_skin, -force * part * std::sin(tilt), 1e-12);
        }
    }
}

TEST(TactileGrating, TheLevelIsHalfOfTheSignalsSwing) {
    auto effect = plain_effect("a", {.hold = 1000});
    for (const double damping : {0.0, 0.5, 2.0}) {
        effect.damping = damping;
        double low = 1e9, high = -1e9;
        for (double ms = 12; ms < 24; ms += 1e-4) {
            const double value = signal(effect, 0.3, ms).into_skin;
            low = std::min(low, value);
            high = std::max(high, value);
        }
        EXPECT_NEAR(effect.level(0.3), (high - low) / 2, 1e-6) << damping;
    }
    effect.damping = 0;
    EXPECT_DOUBLE_EQ(effect.level(0.35), 0.35) << "1 mm at 5,000 N/m is the motors' 5 N";
    EXPECT_NEAR(effect.carrier(), 1000.0 / 12, 1e-12);
}

TEST(TactileGrating, EnvelopesRiseHoldAndFall) {
    const Envelope lines{.attack = 10, .hold = 20, .decay = 40};
    EXPECT_EQ(lines.at(-1), 0);
    EXPECT_EQ(lines.at(0), 0);
    EXPECT_DOUBLE_EQ(lines.at(5), 0.5);
    EXPECT_EQ(lines.at(10), 1);
    EXPECT_EQ(lines.at(30), 1);
    EXPECT_DOUBLE_EQ(lines.at(50), 0.5);
    EXPECT_EQ(lines.at(70), 0);
    const Envelope swell{.attack = 200, .decay = 200, .smooth = true};
    EXPECT_DOUBLE_EQ(swell.at(100), 0.5);
    EXPECT_DOUBLE_EQ(swell.at(200), 1);
    EXPECT_LT(swell.at(1), 1e-4) << "a swell begins without a corner";
    const Envelope blow{.hold = 3};
    EXPECT_EQ(blow.at(0), 1);
}

TEST(TactileGrating, ThePeakOfASpanIsTheGreatestStrengthInIt) {
    for (const Envelope& e :
         {Envelope{10, 20, 40, false}, Envelope{0, 2, 1, false}, Envelope{50, 0, 50, true}}) {
        for (double from = -10; from < 110; from += 3.1) {
            for (const double length : {0.0, 1.0, 8.0, 60.0}) {
                double greatest = 0;
                for (int i = 0; i <= 1000; ++i) greatest = std::max(greatest, e.at(from + length * i / 1000));
                EXPECT_NEAR(e.peak(from, from + length), greatest, 0.07) << from << " " << length;
                EXPECT_GE(e.peak(from, from + length), greatest);
            }
        }
    }
}

}  // namespace
}  // namespace thaum::tactile
