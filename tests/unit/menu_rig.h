// unit/menu_rig.h: a context and events of a menu, for tests of the menu.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>

#include "game/menu/menu.h"

namespace thaum::game::menu_tests {

using input::Action;
using input::Control;
using input::DeviceKind;
using input::PadButton;
using Kind = MenuEvent::Kind;

constexpr Device keyboard{DeviceKind::keyboard_mouse, 0}, half{DeviceKind::keyboard_half, 0},
    first_pad{DeviceKind::pad, 0}, second_pad{DeviceKind::pad, 1};

inline const MenuContext& context() {
    static const MenuContext context{
        .bots = {{"level_1", "Beginner"}, {"level_2", "Adept"}, {"level_3", "Expert"}},
        .rules = {{"quick", "quick: first to 3"}, {"standard", "standard: first to 5"}},
        .arenas = {{"boiling_court", "Boiling Court"}},
        .pads = {"Make-believe pad", "Another pad", "", ""},
        .ends_match = true,
        .body = {tactile::Purpose::impact, tactile::Purpose::fall, tactile::Purpose::warning},
        .sticks = {"Stick of wood and string"},
        .pad_question = "11 of 20: press RB, the button above the right trigger"};
    return context;
}

inline MenuState with(MenuState s, Kind kind, const Device& device = keyboard) {
    return step(std::move(s), {.kind = kind, .device = device}, context());
}

inline MenuState start_page() { return opened({}, "start"); }

inline std::size_t row_named(const MenuState& s, std::string_view label) {
    const auto rows = picture_of(s, context()).rows;
    const auto found =
        std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.label == label; });
    EXPECT_NE(found, rows.end()) << label;
    return static_cast<std::size_t>(found - rows.begin());
}

inline MenuState choose(MenuState s, std::string_view label, Kind kind = Kind::confirm) {
    const auto row = row_named(s, label);
    return step(std::move(s), {.kind = kind, .device = keyboard, .row = row}, context());
}

inline std::string value_of(const MenuState& s, std::string_view label) {
    return picture_of(s, context()).rows[row_named(s, label)].value;
}

inline MenuState bindings_of(std::string_view sheet) {
    return choose(choose(start_page(), "Controls"), sheet);
}

inline Control key(std::string_view name) { return {Control::Source::key, *key_code_of(name), 0}; }
inline Control button(PadButton b) { return {Control::Source::pad_button, static_cast<int>(b), 0}; }

inline MenuState press(MenuState s, const Control& control) {
    return step(std::move(s), {.kind = Kind::control, .control = control}, context());
}

inline const std::vector<Control>& bound(const MenuState& s, DeviceKind kind, Action action) {
    return s.settings.bindings_of(kind).of(action);
}

// Pages of the menu that several tests open.
inline MenuState settings_page() { return choose(opened({}, "pause"), "Settings"); }
inline MenuState player_page() { return choose(settings_page(), "Each player's own settings"); }
inline MenuState mixer_page() { return choose(settings_page(), "Forces and body"); }
inline MenuState cauldron_page() { return choose(mixer_page(), "Cauldron feedback"); }

}  // namespace thaum::game::menu_tests
