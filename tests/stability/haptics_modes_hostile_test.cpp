// Haptic modes must stay within force limits and passive in faulty fields, with any strengths and any motion.
// `thaum bench haptics --stress` is a longer run of the same.
#include <gtest/gtest.h>

#include "tests/scenes/hostile_modes.h"

namespace thaum::haptics {
namespace {

using bench::HostileFeel;
using bench::HostileFields;
using bench::HostileHand;
using bench::HostileResult;

/// Largest energy that springs and other passive sources of force may create (engine/haptics/HAPTICS.md,
/// "Energy and switches") (J).
constexpr double most_created = 0.02;

TEST(HapticModesHostile, AllModesTogetherStayWithinTheCaps) {
    for (const std::uint32_t faults : {0U, 200U}) {
        HostileFields fields(7, faults);
        HostileHand hand(fields, 7, HostileFeel::all);
        HostileResult result;
        for (int run = 0; run < 25; ++run) {
            hand.run(2000, result);
            hand.choose_modes();
        }
        EXPECT_EQ(result.ticks, 50'000U);
        EXPECT_EQ(result.not_finite, 0U);
        EXPECT_EQ(result.left_out, 0U);
        EXPECT_LE(result.largest, hand.cap() * (1 + 1e-12));
        EXPECT_GT(result.felt, 0.2 * static_cast<double>(result.ticks));
        // Modes that push the hand by themselves are active sources, which may give half a joule a second.
        // Each choice of other modes is a switch of the source, which may give energy once.
        EXPECT_LE(result.max_given, active_budget + 2 * switch_energy);
    }
}

TEST(HapticModesHostile, PassiveModesCreateNoEnergy) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        HostileFields fields(seed, seed % 2 == 0 ? 0 : 1000);
        HostileHand hand(fields, seed, HostileFeel::passive);
        HostileResult result;
        hand.run(10'000, result);
        EXPECT_EQ(result.not_finite, 0U);
        EXPECT_EQ(result.left_out, 0U);
        EXPECT_LE(result.largest, hand.cap() * (1 + 1e-12));
        EXPECT_GT(result.felt, 0) << seed;
        EXPECT_LE(result.most_created, most_created) << seed;
        EXPECT_LE(result.observed, most_created) << seed;
    }
}

TEST(HapticModesHostile, AVolumeStaysWithinTheCaps) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        HostileFields fields(seed, seed % 2 == 0 ? 0 : 1000);
        HostileHand hand(fields, seed, HostileFeel::volume);
        HostileResult result;
        hand.run(10'000, result);
        EXPECT_EQ(result.not_finite, 0U);
        EXPECT_LE(result.largest, hand.cap() * (1 + 1e-12));
        EXPECT_GT(result.felt, 0) << seed;
        EXPECT_LE(result.observed, most_created) << seed;
    }
}

}  // namespace
}  // namespace thaum::haptics
