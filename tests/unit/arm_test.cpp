// Tests the measurement of an arm's ticks and poses before other code uses them.
#include "input/arm.h"

#include <gtest/gtest.h>

#include "input/tick_times.h"

namespace thaum::input {
namespace {

TEST(Arm, QuantisesToTheNearestUnit) {
    EXPECT_EQ(quantised(0.49), 0);
    EXPECT_EQ(quantised(-0.51), -1);
    EXPECT_EQ(quantised(12345.4), 12345);
    EXPECT_EQ(quantised(1e300), 1'000'000'000);
    EXPECT_EQ(quantised(-1e300), -1'000'000'000);
}

void expect_near(vec3 a, vec3 b, double within) {
    EXPECT_LE(glm::length(a - b), within) << a.x << ' ' << a.y;
}

TEST(Arm, RotationVectorUndoesTheRotation) {
    const vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}, glm::normalize(vec3(1, -2, 3))};
    for (const auto axis : axes) {
        for (const double angle : {0.0, 1e-12, 1e-7, 0.3, 1.6, 3.0, pi - 1e-6})
            expect_near(rotation_vector(glm::mat3_cast(rotation(axis, angle))), axis * angle, 1e-9);
    }
}

TEST(Arm, HalfATurnIsEitherWayRound) {
    const auto v = rotation_vector(glm::mat3_cast(rotation({0, 1, 0}, pi)));
    EXPECT_NEAR(glm::length(v), pi, 1e-12);
    EXPECT_NEAR(std::abs(v.y), pi, 1e-9);
}

// ---- times of an arm's ticks ------------------------------------------------------------------------------

constexpr std::int64_t us = 1000, ms = 1'000'000;

TEST(Arm, CaptionIsTheFirstSentenceOfTheFault) {
    EXPECT_EQ(caption_of({}), "");
    EXPECT_EQ(caption_of({ArmPresence::present, "all is well"}), "");
    EXPECT_EQ(caption_of({ArmPresence::fault, "the arm is warm: let it rest; WARM (0200)"}),
              "The arm is warm: let it rest");
    EXPECT_EQ(caption_of({ArmPresence::lost, "It is gone"}), "It is gone");
    EXPECT_EQ(caption_of({ArmPresence::fault, ";"}), "");
    EXPECT_EQ(caption_of({ArmPresence::lost, ""}), "");
}

TEST(Arm, BoxIsInWholeMicrometresOrUnknown) {
    using Box = std::array<std::uint32_t, 3>;
    const auto box = [](vec3 workspace) {
        ArmFacts facts;
        facts.spec.workspace = workspace;
        return box_um(facts);
    };
    EXPECT_EQ(box({0.16, 0.12, 0.0700004}), (Box{160'000, 120'000, 70'000}));
    EXPECT_EQ(box({0, 0, 0}), Box{});
    EXPECT_EQ(box({0.16, -0.12, 0.07}), Box{});
    EXPECT_EQ(box({0.16, 1e300, 0.07}), Box{});
    EXPECT_EQ(box({0.16, NAN, 0.07}), Box{});
}

TEST(TickTimes, KnowNothingAtFirst) {
    const TickTimes times;
    const auto report = times.report();
    EXPECT_EQ(report.ticks, 0U);
    EXPECT_EQ(report.missed, 0U);
    EXPECT_EQ(report.jitter_p99, 0);
    EXPECT_EQ(times.newest_ns(), 0);
}

TEST(TickTimes, CountUnevenTicks) {
    TickTimes times;
    std::int64_t now = 5 * ms;
    for (int tick = 0; tick < 1000; ++tick) {
        times.begins(now);
        times.ends(now + (tick == 500 ? 400 * us : 20 * us));
        now += tick == 200 ? 4 * ms : tick % 100 == 50 ? ms + 90 * us : ms;
    }
    const auto report = times.report();
    EXPECT_EQ(report.ticks, 1000U);
    EXPECT_EQ(report.missed, 3U);
    EXPECT_EQ(report.jitter_median, 0);
    EXPECT_EQ(report.jitter_p99, 90);  // ten of the 999 gaps are 90 us, and one gap is larger
    EXPECT_EQ(report.jitter_worst, 3000);
    EXPECT_EQ(report.answer_median, 20);
    EXPECT_EQ(report.answer_p99, 20);
    EXPECT_EQ(report.answer_worst, 400);
}

TEST(TickTimes, ATickThatComesEarlyIsNoMissedOne) {
    TickTimes times;
    for (const auto at : {10 * ms, 15 * ms, 15 * ms + 10 * us, 16 * ms}) times.begins(at);
    EXPECT_EQ(times.report().missed, 4U);
    EXPECT_EQ(times.report().jitter_worst, 4000);
}

TEST(TickTimes, HoursAreInRange) {
    TickTimes times;
    times.begins(ms);
    times.begins(ms + 3'600'000 * ms);
    EXPECT_EQ(times.report().missed, 3'599'999U);
    EXPECT_NEAR(times.report().jitter_p99, 3.6e9, 2e3);
}

}  // namespace
}  // namespace thaum::input
