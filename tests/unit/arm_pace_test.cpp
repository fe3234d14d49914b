// Tests how a match follows the clock of a real arm (a haptic device). Time is simulated; the machine's clock
// is not read.
#include "game/live/arm_pace.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace thaum::game {
namespace {

constexpr double ns_per_second = 1e9;
constexpr std::int64_t ns_per_tick = 1'000'000;

/// An arm and a live match, simulated for some seconds. The match keeps its pace as in live/simulation.cpp.
struct Rig {
    double arm_ticks_per_s = 1000;
    bool follows = true;
    /// Start and length of a time in which the match gets no processor (ns).
    std::int64_t stall_at = -1, stall_ns = 0;
    double jitter = 0;  ///< largest delay of a sample, as a share of a tick

    std::size_t max_waiting = 0;  ///< most samples of the arm that waited for the match, in the last second
    int without_sample = 0;       ///< ticks of the last second for which the arm had sent no sample

    void run(double seconds) {
        const auto arm_period = ns_per_second / arm_ticks_per_s;
        const auto end = static_cast<std::int64_t>(seconds * ns_per_second);
        std::int64_t start = 0, now = 0;
        std::int64_t done = 0, arm_sent = 0, waiting = 0;
        while (now < end) {
            const auto deadline = start + (done + 1) * ns_per_tick;
            now = std::max(now, deadline);
            if (stall_at >= 0 && now >= stall_at) {
                now += stall_ns;
                stall_at = -1;
            }
            const auto sent = arrived(now, arm_period);
            waiting += sent - arm_sent;
            arm_sent = sent;
            const auto behind = static_cast<Tick>((now - start) / ns_per_tick - done);
            if (follows) start += arm_pace_correction(waiting, behind);
            const bool last_second = now > end - static_cast<std::int64_t>(ns_per_second);
            if (last_second) max_waiting = std::max(max_waiting, static_cast<std::size_t>(waiting));
            if (last_second && waiting == 0) ++without_sample;
            if (waiting > 0) --waiting;
            ++done;
        }
    }

private:
    /// Number of samples of the arm that have arrived by now. Every second sample is late.
    std::int64_t arrived(std::int64_t now, double period) const {
        const auto at = static_cast<std::int64_t>(static_cast<double>(now) / period);
        const bool late =
            at % 2 == 1 && static_cast<double>(now) - static_cast<double>(at) * period < jitter * period;
        return late ? at - 1 : at;
    }
};

TEST(ArmPace, AFasterArmsSamplesDoNotPileUp) {
    for (const double rate : {1001.0, 1008.0, 1030.0}) {
        Rig rig{.arm_ticks_per_s = rate};
        rig.run(20);
        // A sample that waits makes the haptic models older by as many ticks. Models count as fresh up to an
        // age of 20 ticks, so at most 12 may wait.
        EXPECT_LE(rig.max_waiting, 12U) << rate;
        EXPECT_EQ(rig.without_sample, 0) << rate;
    }
    Rig alone{.arm_ticks_per_s = 1008, .follows = false};
    alone.run(20);
    EXPECT_GT(alone.max_waiting, 150U) << "the rig cannot fail";
}

TEST(ArmPace, ASlowerArmIsWaitedFor) {
    for (const double rate : {999.0, 998.0, 997.0}) {
        Rig rig{.arm_ticks_per_s = rate};
        rig.run(20);
        EXPECT_EQ(rig.without_sample, 0) << rate;
        Rig alone{.arm_ticks_per_s = rate, .follows = false};
        alone.run(20);
        EXPECT_GT(alone.without_sample, 0) << "the rig cannot fail at " << rate;
    }
}

TEST(ArmPace, AStalledMatchCatchesUp) {
    Rig rig{.arm_ticks_per_s = 1008, .stall_at = 5'000'000'000, .stall_ns = 40'000'000, .jitter = 0.5};
    rig.run(20);
    EXPECT_LE(rig.max_waiting, 12U);
}

TEST(ArmPace, AnArmThatStoppedChangesNothing) { EXPECT_EQ(arm_pace_correction(0, 5), 0); }

}  // namespace
}  // namespace thaum::game
