// Tests that a program can add a haptic mode by one source file of its own (homing.cpp).
#include <gtest/gtest.h>

#include <algorithm>

#include "field/analytic.h"
#include "haptics/modes.h"

namespace thaum::haptics {
namespace {

TEST(OwnMode, IsOfferedBesideTheShippedOnes) {
    const Mode* homing = find_mode("homing");
    ASSERT_NE(homing, nullptr);
    EXPECT_NE(find_mode("follow"), nullptr);
    EXPECT_TRUE(std::ranges::is_sorted(modes(), {}, &Mode::name));

    const field::Sphere ball{.middle = {}, .radius = 0.05};
    ModeUse use{homing, any_field(field::field_of<field::Scalar>(ball)), {}};
    use.settings.strength = field::constant(0.4);
    PrimitiveSet set;
    EXPECT_EQ(add_modes(std::span(&use, 1), {.proxy = {0.01, 0, 0}}, set), 0U);
    ASSERT_EQ(set.items().size(), 1U);
    EXPECT_EQ(set.items()[0].strength, 0.4);
}

}  // namespace
}  // namespace thaum::haptics
