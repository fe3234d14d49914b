// Tests of the names that prompts have for controls.
#include "game/app/control_names.h"

#include <gtest/gtest.h>

namespace thaum::app {
namespace {

using input::Action;
using input::DeviceKind;

TEST(ControlNames, AreThoseOfTheBindings) {
    Settings settings;
    const auto keys = control_names(settings, DeviceKind::keyboard_mouse);
    EXPECT_EQ(keys.fire, "Left mouse");
    EXPECT_EQ(keys.stir, "E");
    EXPECT_EQ(keys.throw_, "F");
    EXPECT_EQ(keys.wands[0], "1");
    EXPECT_EQ(keys.wands[4], "5");
    const auto pad = control_names(settings, DeviceKind::pad);
    EXPECT_EQ(pad.fire, "RT");
    EXPECT_EQ(pad.stir, "LT");
    EXPECT_FALSE(pad.stir_toggles || keys.stir_toggles || keys.fire_toggles);
    EXPECT_EQ(pad.wands[0], "") << "a pad steps through the wands";
    EXPECT_EQ(pad.next_wand, "RB");
    EXPECT_EQ(control_names(settings, DeviceKind::keyboard_half).fire, "Keypad 0");
}

TEST(ControlNames, NameDirectionsAsOneControl) {
    Settings settings;
    const auto keys = control_names(settings, DeviceKind::keyboard_mouse);
    EXPECT_EQ(keys.move, "W A S D");
    EXPECT_EQ(keys.look, "Mouse");
    EXPECT_EQ(keys.pause, "Esc");
    const auto pad = control_names(settings, DeviceKind::pad);
    EXPECT_EQ(pad.move, "Left stick");
    EXPECT_EQ(pad.look, "Right stick");
    EXPECT_EQ(pad.pause, "Start");
    const auto half = control_names(settings, DeviceKind::keyboard_half);
    EXPECT_EQ(half.move, "Keypad 8 4 5 6");
    EXPECT_EQ(half.look, "Up Left Down Right");
}

TEST(ControlNames, FollowANewBindingAndAreEmptyWithoutOne) {
    Settings settings;
    auto& bindings = settings.bindings_of(DeviceKind::keyboard_mouse);
    bindings.of(Action::stir) = {{input::Control::Source::wheel, 0, 1}};
    bindings.of(Action::fire).clear();
    const auto names = control_names(settings, DeviceKind::keyboard_mouse);
    EXPECT_EQ(names.stir, "Wheel up");
    EXPECT_EQ(names.fire, "");
    bindings.toggled[static_cast<std::size_t>(Action::stir)] = true;
    EXPECT_TRUE(control_names(settings, DeviceKind::keyboard_mouse).stir_toggles);
    EXPECT_FALSE(control_names(settings, DeviceKind::pad).stir_toggles);
}

}  // namespace
}  // namespace thaum::app
