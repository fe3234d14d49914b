// Switches of passive sources create next to no energy at the hand, whatever the device and whoever holds it.
#include <gtest/gtest.h>

#include "tools/bench/switches.h"
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

TEST(HapticsSwitches, TenThousandRandomSwitchesCreateNextToNothing) {
    constexpr int switches = 500;  // each of five devices and five hands: 12,500
    for (const auto& spec : shipped_devices()) {
        for (const auto& hand : bench::switch_hands) {
            const auto run = bench::random_switches(spec, hand, switches, 7);
            EXPECT_LE(run.most_created, most_per_switch) << spec.name << ", " << hand.name;
            EXPECT_EQ(run.switches, switches);
            EXPECT_GT(run.fastest, 0.01) << "nothing moved: " << spec.name << ", " << hand.name;
        }
    }
}

}  // namespace
}  // namespace thaum::haptics
