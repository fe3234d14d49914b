// Stability of switches: switching passive sources creates hardly any energy at the hand, for every device
// and hand.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/scenes/switches.h"
#include "unit/shipped_devices.h"

namespace thaum::haptics {
namespace {

constexpr double most_per_switch = 0.02;  // J (haptics.md, "Energy")

TEST(HapticsSwitches, AStretchedSpringThatComesIsNotChased) {
    for (const auto& spec : shipped_devices()) {
        const double full = spec.peak_force / spec.max_stiffness;
        for (const auto& hand : bench::switch_hands) {
            for (const double stretch : {0.2 * full, full, 3 * full}) {
                const auto run = bench::one_spring(spec, hand, stretch);
                EXPECT_LE(run.most_created, most_per_switch)
                    << spec.name << ", " << hand.name << ", " << stretch;
            }
        }
    }
}

TEST(HapticsSwitches, TenThousandRandomSwitchesOfEachDeviceCreateNextToNothing) {
    // For each of five devices: five hands and eight seeds.
    constexpr int switches = 250;
    for (const auto& spec : shipped_devices()) {
        for (const auto& hand : bench::switch_hands) {
            const auto run = bench::random_switches(spec, hand, switches);
            EXPECT_LE(run.most_created, most_per_switch) << spec.name << ", " << hand.name;
            EXPECT_EQ(run.switches, switches * static_cast<int>(bench::switch_seeds.size()));
            EXPECT_GT(run.fastest, 0.01) << "nothing moved: " << spec.name << ", " << hand.name;
        }
    }
}

TEST(HapticsSwitches, AFigureThatIsNoNumberStaysTheWorst) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(bench::worse(1, 2), 2);
    EXPECT_EQ(bench::worse(2, 1), 2);
    EXPECT_TRUE(std::isnan(bench::worse(1, nan)));
    EXPECT_TRUE(std::isnan(bench::worse(nan, 1)));
    const auto run = bench::one_spring(shipped_devices().front(), bench::switch_hands[0], nan);
    EXPECT_TRUE(std::isnan(run.most_created)) << run.most_created;
}

}  // namespace
}  // namespace thaum::haptics
