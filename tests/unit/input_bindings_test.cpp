#include "input/bindings.h"
#include "unit/message_of.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace thaum::input {
namespace {

/// A keyboard with invented codes; no key is called "no_such_key".
std::optional<int> code_of(std::string_view name) {
    if (name == "no_such_key") return {};
    int code = 1000;
    for (const char c : name) code = code * 31 % 100003 + c;
    return code;
}

const std::vector<Control>& controls(const Bindings& b, Action a) {
    return b.controls[static_cast<std::size_t>(a)];
}

TEST(InputBindings, ActionsAreButtonsInTheirOrder) {
    const auto bit = [](Action a) { return static_cast<Button>(1U << static_cast<unsigned>(a)); };
    EXPECT_EQ(bit(Action::fire), Button::fire);
    EXPECT_EQ(bit(Action::clutch), Button::clutch);
    EXPECT_EQ(bit(Action::mark), Button::mark);
    EXPECT_EQ(bit(Action::quit), Button::quit);
    EXPECT_EQ(name_of(Action::throw_), "throw");
    EXPECT_EQ(name_of(Action::turn_down), "turn_down");
    EXPECT_EQ(name_of(Action::farther), "farther");
    EXPECT_EQ(name_of(Action::nearer), "nearer");
}

TEST(InputBindings, DefaultsReachEveryActionOfTheTable) {
    for (const auto kind : {DeviceKind::keyboard_mouse, DeviceKind::keyboard_half, DeviceKind::pad}) {
        const auto b = default_bindings(kind, code_of);
        for (const auto action :
             {Action::fire, Action::jump, Action::next_wand, Action::trace, Action::stir, Action::throw_,
              Action::clutch, Action::panic, Action::pause, Action::confirm, Action::move_left,
              Action::move_right, Action::move_forward, Action::move_back}) {
            EXPECT_FALSE(controls(b, action).empty()) << name_of(kind) << " " << name_of(action);
        }
        EXPECT_TRUE(b.mouse_look || !controls(b, Action::turn_left).empty());
        EXPECT_TRUE(b.mouse_look || !controls(b, Action::nearer).empty()) << "hands without a wheel";
    }
    EXPECT_TRUE(controls(default_bindings(DeviceKind::bot, code_of), Action::fire).empty());
}

TEST(InputBindings, NoDefaultKeyServesTwoPlayersAtOneKeyboard) {
    const auto one = default_bindings(DeviceKind::keyboard_mouse, code_of);
    const auto two = default_bindings(DeviceKind::keyboard_half, code_of);
    for (std::size_t a = 0; a < actions; ++a) {
        if (static_cast<Action>(a) == Action::panic) continue;  // both players share this key
        for (const auto& control : one.controls[a]) {
            for (const auto& other : two.controls) {
                EXPECT_EQ(std::count(other.begin(), other.end(), control), 0)
                    << name_of(static_cast<Action>(a));
            }
        }
    }
}

TEST(InputBindings, DefaultKeyNames) {
    const auto names = default_key_names();
    for (const auto* name : {"w", "space", "left_alt", "kp_8", "kp_enter", "end", "escape"}) {
        EXPECT_TRUE(std::binary_search(names.begin(), names.end(), name)) << name;
    }
}

TEST(InputBindings, ControlsAsWords) {
    using Source = Control::Source;
    EXPECT_EQ(parse_control("key w", code_of), (Control{Source::key, *code_of("w"), 0}));
    EXPECT_EQ(parse_control(" mouse  right ", code_of), (Control{Source::mouse_button, 1, 0}));
    EXPECT_EQ(parse_control("wheel down", code_of), (Control{Source::wheel, 0, -1}));
    EXPECT_EQ(parse_control("pad left", code_of), (Control{Source::pad_button, 14, 0}));
    EXPECT_EQ(parse_control("pad left_y -", code_of), (Control{Source::pad_axis, 1, -1}));
    for (const auto* wrong : {"", "key", "key no_such_key", "mouse sixth", "wheel", "wheel left",
                              "pad left_y", "pad a +", "pad left_y ++", "key w x", "joystick 1", "mouse"}) {
        EXPECT_FALSE(parse_control(wrong, code_of)) << wrong;
    }
}

Expected<Bindings> read(std::string_view toml) {
    const auto config = Config::parse(toml, "settings.toml", 1);
    if (!config) return config.error();
    const auto base = default_bindings(DeviceKind::pad, code_of);
    auto bindings = read_bindings(config->root().table("pad"), base, code_of);
    if (const auto checked = config->check(); !checked) return checked.error();
    return bindings;
}

TEST(InputBindings, SettingsOverrideDefaults) {
    const auto b =
        read("version = 1\n[pad]\nfire = \"pad a, key f\"\nmark = \"\"\ntrigger_press = 0.4\n").value();
    ASSERT_EQ(controls(b, Action::fire).size(), 2U);
    EXPECT_EQ(controls(b, Action::fire)[1].code, *code_of("f"));
    EXPECT_TRUE(controls(b, Action::mark).empty());
    EXPECT_EQ(b.trigger_press, 0.4);
    EXPECT_EQ(controls(b, Action::jump), controls(default_bindings(DeviceKind::pad, code_of), Action::jump));
    EXPECT_TRUE(read("version = 1\n"));
}

TEST(InputBindings, UnknownNamesTellFileLineAndKey) {
    const auto unknown_key = read("version = 1\n[pad]\nfire = \"key no_such_key\"\n");
    ASSERT_FALSE(unknown_key);
    EXPECT_EQ(
        unknown_key.error().message.rfind("settings.toml:3: 'fire': unknown control 'key no_such_key'", 0),
        0U)
        << unknown_key.error().message;
    EXPECT_NE(message_of(read("version = 1\n[pad]\nfly = \"key f\"\n")).find("settings.toml:3"),
              std::string::npos);
    EXPECT_FALSE(read("version = 1\n[pad]\nfire = 3\n"));
    EXPECT_FALSE(read("version = 1\n[pad]\nfire = \"pad a,,pad b\"\n"));
}

/// Names of the invented key codes that this test uses.
std::string name_of_code(int code) {
    for (const auto& name : default_key_names()) {
        if (code_of(name) == code) return name;
    }
    return "";
}

TEST(InputBindings, WordsOfControlsAreReadBack) {
    for (const auto kind : {DeviceKind::keyboard_mouse, DeviceKind::keyboard_half, DeviceKind::pad}) {
        const auto b = default_bindings(kind, code_of);
        for (const auto& list : b.controls) {
            const auto words = words_of(list, name_of_code);
            const auto again = parse_controls(words, code_of);
            ASSERT_TRUE(again) << words;
            EXPECT_EQ(*again, list) << words;
        }
    }
    EXPECT_EQ(words_of(default_bindings(DeviceKind::pad, code_of).of(Action::panic), name_of_code),
              "pad back, key end");
    EXPECT_FALSE(parse_controls("key a, pad nothing", code_of));
    EXPECT_TRUE(parse_controls("", code_of)->empty());
}

TEST(InputBindings, TogglesAreReadAndWritten) {
    const auto read = [](const std::string& line) {
        const auto file = Config::parse("version = 1\n[pad]\n" + line, "s", 1).value();
        auto b = read_bindings(file.root().table("pad"), default_bindings(DeviceKind::pad, code_of), code_of);
        return std::pair(b, file.check());
    };
    const auto [some, fine] = read("toggle = \"stir,fire\"\n");
    EXPECT_TRUE(fine);
    EXPECT_EQ(toggles_of(some), "fire, stir");
    EXPECT_EQ(toggles_of(read("toggle = \"\"\n").first), "");
    const auto [none, fault] = read("toggle = \"fire, jump\"\n");
    ASSERT_FALSE(fault);
    EXPECT_NE(fault.error().message.find("s:3: 'toggle': 'jump' is not one of fire, trace, stir, clutch"),
              std::string::npos)
        << fault.error().message;
}

}  // namespace
}  // namespace thaum::input
