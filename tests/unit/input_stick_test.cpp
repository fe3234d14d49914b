// Tests of the dead zone and response curve of sticks, alone and in the counts of two players at the same
// time.
#include "input/stick.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "input/collector.h"

namespace thaum::input {
namespace {

constexpr double curves[] = {0, 0.1, 0.3, 0.5, 0.7, 0.9, 1};

/// Turn rate in the match for a stick pushed by `push` (0 to 1), as a share of the full rate.
double rate_of(double push, double curve) { return turn_share(deflection_for(push, curve)); }

TEST(InputStick, EveryCurveIsFixedAtRestAndAtTheEnds) {
    for (const double curve : curves) {
        EXPECT_EQ(deflection_for(0, curve), 0) << curve;
        EXPECT_NEAR(deflection_for(1, curve), 1, 1e-15) << curve;
        EXPECT_NEAR(deflection_for(-1, curve), -1, 1e-15) << curve;
        EXPECT_LE(deflection_for(1, curve), 1) << curve;
    }
}

TEST(InputStick, EveryCurveGrowsAndIsTheSameOnBothSides) {
    for (const double curve : curves) {
        double before = 0;
        for (int i = 1; i <= 1000; ++i) {
            const double push = i / 1000.0, now = deflection_for(push, curve);
            EXPECT_GT(now, before) << curve << " at " << push;
            EXPECT_EQ(deflection_for(-push, curve), -now) << curve << " at " << push;
            before = now;
        }
    }
}

/// The documented law (1 - curve) x + curve x^3, which results from two steps together: the input collector
/// shapes the stick's position, and the match shapes the rate of turning.
TEST(InputStick, TheRateOfATurnFollowsTheChosenCurve) {
    for (const double curve : curves) {
        for (int i = 1; i <= 1000; ++i) {
            const double x = i / 1000.0, wanted = (1 - curve) * x + curve * x * x * x;
            EXPECT_NEAR(rate_of(x, curve), wanted, 2e-15) << curve << " at " << x;
        }
        EXPECT_NEAR(rate_of(1e-6, curve) / 1e-6, 1 - curve, 1e-9) << "no digits are lost near rest";
    }
}

TEST(InputStick, TheUsualCurveLeavesEveryPushAsItIs) {
    const StickResponse usual;
    for (int i = -100'000; i <= 100'000; ++i)
        ASSERT_EQ(deflection_for(i / 100'000.0, usual.curve), i / 100'000.0);
}

TEST(InputStick, TheDeadZoneIsJoinedWithoutAStep) {
    for (const double dead : {0.0, 0.05, 0.15, 0.5, 0.9}) {
        for (const double angle : {0.0, 0.4, 1.0, 2.0, 4.0}) {
            const double right = std::cos(angle), up = std::sin(angle);
            const auto length_at = [&](double push) {
                const auto at = without_dead_zone({push * right, push * up}, dead);
                EXPECT_NEAR(at.x * up, at.y * right, 1e-12) << "the direction stays";
                return std::hypot(at.x, at.y);
            };
            EXPECT_EQ(length_at(dead * (1 - 1e-9)), 0) << dead;
            EXPECT_LT(length_at(dead + 1e-9), 1.1e-8) << dead;
            EXPECT_NEAR(length_at(1), 1, 1e-12) << dead;
            double before = 0;
            for (double push = dead; push < 1; push += 0.001) {
                const double current = length_at(push);
                EXPECT_GE(current, before) << dead << " at " << push;
                EXPECT_LE(current, before + 0.001 / (1 - dead) + 1e-9) << dead << " at " << push;
                before = current;
            }
        }
    }
}

TEST(InputStick, BrokenNumbersAreReplaced) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                     endless = std::numeric_limits<double>::infinity();
    EXPECT_EQ(checked_push(nan), 0);
    EXPECT_EQ(checked_push(-endless), 0);
    EXPECT_EQ(checked_push(7), 1);
    const auto low = StickResponse{-1, -1}.checked(), high = StickResponse{5, 5}.checked(),
               none = StickResponse{nan, endless}.checked();
    EXPECT_EQ(low.dead_zone, 0);
    EXPECT_EQ(low.curve, 0);
    EXPECT_EQ(high.dead_zone, 0.9);
    EXPECT_EQ(high.curve, 1);
    EXPECT_EQ(none.dead_zone, StickResponse{}.dead_zone);
    EXPECT_EQ(none.curve, StickResponse{}.curve);
}

// ---- response curve in the counts of a sample -------------------------------------------------------------

Bindings pad_bindings() {
    return default_bindings(DeviceKind::pad, [](std::string_view) { return 1; });
}

/// Both sticks pushed to the right by `push`.
PadState pushed(double push) {
    PadState state;
    state.axes[static_cast<std::size_t>(PadAxis::left_x)] = push;
    state.axes[static_cast<std::size_t>(PadAxis::right_x)] = push;
    return state;
}

TEST(InputStick, TwoPlayersSticksRespondEachInTheirOwnWay) {
    HandsCollector usual(pad_bindings()), straight(pad_bindings()), fine(pad_bindings());
    straight.set_sticks({.dead_zone = 0.05, .curve = 0});
    fine.set_sticks({.dead_zone = 0.4, .curve = 1});
    const auto counts = [](HandsCollector& hands, double push) {
        hands.pad(pushed(push));
        const auto sample = hands.take();
        return std::pair(sample.counts[hand::strafe], sample.counts[hand::turn_right]);
    };
    for (int i = -100; i <= 100; ++i) {
        const double push = i / 100.0;
        const auto live = [&](double dead) {
            return std::copysign(std::max((std::abs(push) - dead) / (1 - dead), 0.0), push);
        };
        const auto [walk, turn] = counts(usual, push);
        EXPECT_NEAR(walk, 127 * live(0.15), 0.5 + 1e-9) << push;
        EXPECT_EQ(turn, walk) << "by default the counts of a turn are those of the stick";
        const auto [straight_walk, straight_turn] = counts(straight, push);
        EXPECT_NEAR(straight_walk, 127 * live(0.05), 0.5 + 1e-9) << push;
        EXPECT_NEAR(turn_share(straight_turn / 127.0), live(0.05), 0.011) << push << ": one count of the rim";
        const auto [fine_walk, fine_turn] = counts(fine, push);
        EXPECT_NEAR(fine_walk, 127 * live(0.4), 0.5 + 1e-9) << push << ": walking has no curve";
        EXPECT_NEAR(turn_share(fine_turn / 127.0), std::pow(live(0.4), 3), 0.011) << push;
    }
    EXPECT_EQ(counts(fine, 1).second, 127);
    EXPECT_EQ(counts(straight, -1).second, -127);
}

TEST(InputStick, KeysTurnAtTheirFullRateWhateverTheCurve) {
    for (const double curve : curves) {
        HandsCollector hands(default_bindings(DeviceKind::keyboard_half, [](std::string_view name) {
            return name == "left" ? 1 : name == "up" ? 2 : 3;
        }));
        hands.set_sticks({.curve = curve});
        hands.key(1, true);
        hands.key(2, true);
        const auto sample = hands.take();
        EXPECT_EQ(sample.counts[hand::turn_right], -127) << curve;
        EXPECT_EQ(sample.counts[hand::turn_up], 127) << curve;
    }
}

TEST(InputStick, NewSettingsActOnTheNextPosition) {
    HandsCollector hands(pad_bindings());
    hands.pad(pushed(0.2));
    EXPECT_GT(hands.take().counts[hand::turn_right], 0);
    hands.set_sticks({.dead_zone = 0.3});
    hands.pad(pushed(0.2));
    EXPECT_EQ(hands.take().counts[hand::turn_right], 0);
    hands.rebind(pad_bindings());
    hands.pad(pushed(0.2));
    EXPECT_EQ(hands.take().counts[hand::turn_right], 0) << "other bindings leave the sticks as they are";
}

}  // namespace
}  // namespace thaum::input
