// Tests the playback of recorded forces at an arm: each force acts for one tick, and the safety stage (the
// last part of the servo) limits forces that are too strong, too fast or invalid.
#include "input/arm_playback.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/random.h"

namespace thaum::input {
namespace {

haptics::DeviceSpec touch_spec() {
    return {.name = "Touch",
            .sensed = 6,
            .actuated = 3,
            .peak_force = 3.3,
            .continuous_force = 0.88,
            .max_stiffness = 400,
            .max_damping = 4};
}

/// A hand at the arm that plays recorded forces. It rests, or is moved along x.
struct Hand {
    ArmPlayback playback{haptics::servo_of(touch_spec(), 0.5)};
    std::int64_t now_ns = 1'000'000;
    std::int32_t place_um = 0, step_um = 0;

    vec3 tick() {
        now_ns += 1'000'000;
        place_um += step_um;
        ArmReading reading{.time_ns = now_ns};
        reading.position_um = {place_um, 0, 0};
        return playback.step(reading);
    }
    vec3 play(vec3 force, bool jumps = false) {
        EXPECT_TRUE(playback.push(force, jumps));
        return tick();
    }
    std::uint64_t ticks_of(haptics::SafetyCause cause) const {
        return playback.report().causes[static_cast<std::size_t>(cause)];
    }
};

TEST(ArmPlayback, EachForceActsForATick) {
    Hand hand;
    EXPECT_EQ(hand.tick(), vec3(0)) << "before the first force";
    double strongest = 0;
    for (int t = 0; t < 1000; ++t) {
        const vec3 force(0.3 * std::sin(t * 0.02), 0.1, t % 100 == 50 ? 1.2 : 0);
        const vec3 told = hand.play(force);
        if (t < 20) continue;  // first the safety stage lets the force grow only slowly
        ASSERT_EQ(told, force) << t;
        strongest = std::max(strongest, glm::length(force));
    }
    EXPECT_EQ(hand.playback.report().played, 1000U);
    EXPECT_EQ(hand.playback.report().starved, 0U);
    EXPECT_EQ(hand.playback.report().strongest, strongest);
}

TEST(ArmPlayback, BeginsAndEndsSlowly) {
    // The slew limit lets a force change by 40 N/s, that is by this much in a tick (N).
    constexpr double max_step = 0.04 * (1 + 1e-9);
    Hand hand;
    vec3 before(0);
    const auto expect_slow = [&](vec3 told) {
        ASSERT_LE(glm::length(told - before), max_step);
        before = told;
    };
    for (int t = 0; t < 100; ++t) expect_slow(hand.play({1.5, 0, 0}));
    EXPECT_EQ(before, vec3(1.5, 0, 0));
    expect_slow(hand.play({-1.5, 0, 0}, true));  // true: a pause was recorded before this force
    for (int t = 0; t < 100; ++t) expect_slow(hand.play({-1.5, 0, 0}));
    EXPECT_EQ(before, vec3(-1.5, 0, 0));
    hand.playback.end();
    for (int t = 0; t < 37; ++t) expect_slow(hand.tick());
    EXPECT_NE(before, vec3(0));
    expect_slow(hand.tick());
    EXPECT_EQ(before, vec3(0));
    EXPECT_EQ(hand.playback.report().starved, 0U);
}

TEST(ArmPlayback, ForcesFadeWhenNoneArrive) {
    Hand hand;
    for (int t = 0; t < 100; ++t) hand.play({1, 0, 0});
    for (int t = 0; t < 20; ++t) EXPECT_EQ(hand.tick(), vec3(1, 0, 0));
    for (int t = 0; t < 50; ++t) hand.tick();
    EXPECT_EQ(hand.tick(), vec3(0));
    EXPECT_EQ(hand.playback.report().starved, 71U);
    EXPECT_LE(glm::length(hand.play({1, 0, 0})), 0.0401) << "forces come back too fast";
}

TEST(ArmPlayback, GivesNoForceAfterAStop) {
    Hand hand;
    for (int t = 0; t < 100; ++t) hand.play({1, 0, 0});
    hand.playback.stop();
    for (int t = 0; t < 300; ++t) ASSERT_EQ(hand.play({1, 0, 0}), vec3(0));
    EXPECT_EQ(hand.ticks_of(haptics::SafetyCause::panic), 300U);
}

TEST(ArmPlayback, EnergyGivenToTheHandIsLimited) {
    Hand hand;
    hand.step_um = 1000;  // the hand moves at 1 m/s in the direction of the force
    double work = 0;
    for (int t = 0; t < 3000; ++t) work += hand.play({1, 0, 0}).x * 1e-3;
    EXPECT_LT(work,
              // The test lasts 3 s, and one energy budget per second is allowed. Without the limit, 1 N
              // over 3 m would give the hand 3 J.
              3 * haptics::active_budget);
    EXPECT_GT(work, haptics::active_budget);
    hand.step_um = -1000;
    for (int t = 0; t < 20; ++t) hand.play({1, 0, 0});
    const double against = hand.play({1, 0, 0}).x;
    EXPECT_GT(against, 0) << "all of the force fades alike, and none of it jumps when the hand turns";
    EXPECT_LT(against, 0.5);
    hand.step_um = 0;
    for (int t = 0; t < 1100; ++t) hand.play({1, 0, 0});
    EXPECT_EQ(hand.play({1, 0, 0}), vec3(1, 0, 0)) << "the budget of another second";
}

TEST(ArmPlayback, AnInvalidPoseEndsTheForce) {
    Hand hand;
    for (int t = 0; t < 100; ++t) hand.play({1, 0, 0});
    vec3 told;
    for (int t = 0; t < 75; ++t) {
        ASSERT_TRUE(hand.playback.push({1, 0, 0}, false));
        told = hand.playback.step({.time_ns = hand.now_ns, .usable = false});
    }
    EXPECT_EQ(told, vec3(0));
    EXPECT_EQ(hand.playback.report().poses.unusable, 75U);
}

TEST(ArmPlayback, ForcesStayWithinTheLimitsWhateverIsRecorded) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double wild[] = {0, 0.1, -1, 1.6, 4, -50, 1e9, 1e308, nan, infinity, -infinity};
    Hand hand;
    Random random = random_stream(11, 1);
    const auto any = [&] { return wild[static_cast<std::size_t>(random.uniform() * std::size(wild))]; };
    for (int t = 0; t < 100'000; ++t) {
        // Three phases: hand and forces are random, only the forces are random, both are moderate.
        const auto phase = t % 4000;
        hand.step_um = phase < 1000 ? static_cast<std::int32_t>(20'000 * random.uniform()) : 0;
        const vec3 wanted = phase < 3000 ? vec3(any(), any(), any()) : vec3(2, 0, 0);
        const vec3 told = hand.play(wanted, random.uniform() < 0.01);
        ASSERT_TRUE(is_finite(told)) << t;
        ASSERT_LE(glm::length(told), 1.65) << t;
    }
    const auto report = hand.playback.report();
    EXPECT_EQ(report.played, 100'000U);
    EXPECT_GT(hand.ticks_of(haptics::SafetyCause::over_speed), 0U);
    EXPECT_GT(hand.ticks_of(haptics::SafetyCause::capped), 0U);
    EXPECT_GT(hand.ticks_of(haptics::SafetyCause::shut_off), 0U) << "the third time";
}

}  // namespace
}  // namespace thaum::input
