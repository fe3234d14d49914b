// Tests of the names by which prompts on the screen call keys and buttons.
#include "game/settings/control_names.h"

#include <gtest/gtest.h>

#include <map>

#include "game/hud/wand_icon.h"
#include "game/settings/bindings.h"

namespace thaum::game {
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

TEST(ShortLabels, OfAllKeysAreShortAndNoTwoAreTheSame) {
    std::map<std::string, std::string> label_of_short;
    constexpr int max_code = 400;
    for (int code = 0; code < max_code; ++code) {
        if (key_name_of(code).empty()) continue;
        const auto label = label_of(input::Control{input::Control::Source::key, code, 0});
        const auto brief = game::brief_label(label);
        EXPECT_FALSE(brief.empty()) << label;
        EXPECT_LE(brief.size(), 3U) << label;
        if (label.starts_with("Keypad ")) continue;  // these keys are called as on their caps, such as "5"
        const auto [other, is_new] = label_of_short.emplace(brief, label);
        EXPECT_TRUE(is_new) << label << " and " << other->second << " are both " << brief;
    }
    EXPECT_GT(label_of_short.size(), 80U);
}

TEST(ShortLabels, OfButtonsAndWheel) {
    for (const auto& [label, brief] : {std::pair{"RB", "RB"},
                                       {"Keypad +", "+"},
                                       {"Print screen", "Prt"},
                                       {"Left mouse", "LMB"},
                                       {"Mouse button 4", "M4"},
                                       {"Wheel down", "Wh-"},
                                       {"Pad left", "PLe"},
                                       {"", ""}})
        EXPECT_EQ(game::brief_label(label), brief);
}

}  // namespace
}  // namespace thaum::game
