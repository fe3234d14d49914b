// Switches of passive sources create next to no energy at the hand, whatever the device and whoever holds it.
#include <gtest/gtest.h>

#include <filesystem>

#include "core/file.h"
#include "tools/bench/switches.h"

namespace thaum::haptics {
namespace {

constexpr double most_per_switch = 0.02;  // J (haptics.md, "Energy")

std::vector<DeviceSpec> every_device() {
    std::vector<DeviceSpec> result;
    for (const auto& entry : std::filesystem::directory_iterator(THAUM_SOURCE_DIR "/assets/devices")) {
        const auto toml = read_text_file(entry.path(), 1U << 16U);
        result.push_back(*read_device(*Config::parse(*toml, entry.path().filename(), 1)));
    }
    return result;
}

TEST(HapticsSwitches, AStretchedSpringThatComesIsNotChased) {
    for (const auto& spec : every_device()) {
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
    for (const auto& spec : every_device()) {
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
