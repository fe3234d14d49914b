// Tests of the bytes of effects for the motors. Expected bytes are written by hand from the layout of
// ff_effect in linux/input.h on x86-64.
#include "input/detail/rumble_effect.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <limits>
#include <map>

#include "unit/felt_output_rig.h"

namespace thaum::input {
namespace {

using detail::rumble_effect;
using rig::frame_of;

constexpr float no_number = std::numeric_limits<float>::quiet_NaN(),
                infinite = std::numeric_limits<float>::infinity();

/// Bytes of an effect that are not 0, by offset.
std::map<std::size_t, int> bytes_of(const ff_effect& effect) {
    std::array<unsigned char, sizeof(ff_effect)> bytes{};
    std::memcpy(bytes.data(), &effect, bytes.size());
    std::map<std::size_t, int> set;
    for (std::size_t i = 0; i < bytes.size(); ++i)
        if (bytes.at(i) != 0) set[i] = bytes.at(i);
    return set;
}
using BytesByOffset = std::map<std::size_t, int>;

TEST(RumbleEffect, LeftIsTheStrongMotorAndRightTheWeakOne) {
    static_assert(sizeof(ff_effect) == 48);
    // Offsets: 0 type (0x50), 2 id, 10 length, 16 strong magnitude, 18 weak magnitude; the lower byte first.
    EXPECT_EQ(bytes_of(rumble_effect(frame_of(1, 0), 0)),
              (BytesByOffset{{0, 0x50}, {10, 48}, {16, 0xff}, {17, 0xff}}));
    EXPECT_EQ(bytes_of(rumble_effect(frame_of(0, 1), 0)),
              (BytesByOffset{{0, 0x50}, {10, 48}, {18, 0xff}, {19, 0xff}}));
    EXPECT_EQ(bytes_of(rumble_effect(frame_of(0.2F, 0.4F, 300), 5)),
              (BytesByOffset{
                  {0, 0x50}, {2, 5}, {10, 300 - 256}, {11, 1}, {16, 51}, {17, 51}, {18, 102}, {19, 102}}));
    EXPECT_EQ(bytes_of(rumble_effect(frame_of(0, 0), -1)),
              (BytesByOffset{{0, 0x50}, {2, 0xff}, {3, 0xff}, {10, 48}}));
}

TEST(RumbleEffect, HostileAmplitudesAreClipped) {
    const auto strong = [](float amplitude) {
        return rumble_effect(frame_of(amplitude, 0), 0).u.rumble.strong_magnitude;
    };
    EXPECT_EQ(strong(no_number), 0);
    EXPECT_EQ(strong(-0.1F), 0);
    EXPECT_EQ(strong(-infinite), 0);
    EXPECT_EQ(strong(1.5F), 65535);
    EXPECT_EQ(strong(infinite), 65535);
    EXPECT_EQ(strong(std::numeric_limits<float>::max()), 65535);
    auto of_one = frame_of(1, 1);
    of_one.count = 1;
    EXPECT_EQ(rumble_effect(of_one, 0).u.rumble.weak_magnitude, 0) << "an actuator that is not in use";
}

TEST(RumbleEffect, AnEffectNeverLastsForEver) {
    EXPECT_EQ(rumble_effect(frame_of(1, 0, 0), 0).replay.length, 1) << "0 would mean for ever";
    EXPECT_EQ(rumble_effect(frame_of(1, 0, 65536), 0).replay.length, detail::longest_rumble_ms);
    EXPECT_EQ(rumble_effect(frame_of(1, 0, std::numeric_limits<Tick>::max()), 0).replay.length,
              detail::longest_rumble_ms);
}

TEST(RumbleEffect, MagnitudesGrowWithTheAmplitudeIn255Steps) {
    int before = -1, steps = 0;
    for (int i = 0; i <= 10000; ++i) {
        const int current =
            rumble_effect(frame_of(static_cast<float>(i) / 10000, 0), 0).u.rumble.strong_magnitude;
        ASSERT_GE(current, before);
        ASSERT_NEAR(current, 6.5535 * i, 129);
        if (current > before) ++steps;
        before = current;
    }
    EXPECT_EQ(steps, 256);
}

}  // namespace
}  // namespace thaum::input
