#include "game/menu/menu_input.h"

#include <cmath>

namespace thaum::game::inline menu {

using input::Control;
using input::DeviceKind;
using input::PadAxis;
using input::PadButton;
using Kind = MenuEvent::Kind;

// Keys ------------------------------------------------------------------------------------------------------

namespace {

constexpr Device whole_keyboard{DeviceKind::keyboard_mouse, 0}, half_keyboard{DeviceKind::keyboard_half, 0};

struct MenuKey {
    std::string_view name;
    Kind kind;
    Device device;
};
constexpr MenuKey menu_keys[] = {
    {"up", Kind::up, whole_keyboard},
    {"down", Kind::down, whole_keyboard},
    {"left", Kind::left, whole_keyboard},
    {"right", Kind::right, whole_keyboard},
    {"w", Kind::up, whole_keyboard},
    {"s", Kind::down, whole_keyboard},
    {"a", Kind::left, whole_keyboard},
    {"d", Kind::right, whole_keyboard},
    {"page_up", Kind::page_up, whole_keyboard},
    {"page_down", Kind::page_down, whole_keyboard},
    {"enter", Kind::confirm, whole_keyboard},
    {"space", Kind::confirm, whole_keyboard},
    {"escape", Kind::back, whole_keyboard},
    {"kp_8", Kind::up, half_keyboard},
    {"kp_5", Kind::down, half_keyboard},
    {"kp_2", Kind::down, half_keyboard},
    {"kp_4", Kind::left, half_keyboard},
    {"kp_6", Kind::right, half_keyboard},
    {"kp_0", Kind::confirm, half_keyboard},
    {"kp_enter", Kind::confirm, half_keyboard},
    {"kp_multiply", Kind::back, half_keyboard},
};

/// Keys without a meaning in the menu: modifiers that people press to change windows, and most keys of the
/// keypad. The keypad belongs to the half of the keyboard that is a device of its own.
bool means_nothing(const std::string& name) {
    for (const auto* start : {"kp_", "left_", "right_", "caps", "scroll", "num", "print", "menu", "pause"}) {
        if (name.starts_with(start)) return true;
    }
    return name.empty();
}

}  // namespace

std::optional<MenuEvent> menu_event_of(int key) {
    const auto name = key_name_of(key);
    for (const auto& one : menu_keys) {
        if (one.name == name) return MenuEvent{.kind = one.kind, .device = one.device};
    }
    if (means_nothing(name)) return {};
    return MenuEvent{.kind = Kind::other, .device = whole_keyboard};
}

std::optional<Kind> name_event_of(int key) {
    const auto name = key_name_of(key);
    if (name == "enter" || name == "kp_enter") return Kind::confirm;
    if (name == "escape") return Kind::back;
    if (name == "backspace") return Kind::erase;
    return {};
}

// Pads ------------------------------------------------------------------------------------------------------

namespace {

double axis_of(const input::PadState& pad, PadAxis axis) { return pad.axes[static_cast<std::size_t>(axis)]; }

}  // namespace

std::optional<Kind> menu_direction_of(const input::PadState& pad) {
    const auto down = [&](PadButton b) { return (pad.buttons >> static_cast<unsigned>(b) & 1U) != 0; };
    const double x = axis_of(pad, PadAxis::left_x), y = axis_of(pad, PadAxis::left_y);
    const bool upright = std::abs(y) > std::abs(x);
    if (down(PadButton::up) || (upright && y > menu_stick_press)) return Kind::up;
    if (down(PadButton::down) || (upright && y < -menu_stick_press)) return Kind::down;
    if (down(PadButton::left) || (!upright && x < -menu_stick_press)) return Kind::left;
    if (down(PadButton::right) || (!upright && x > menu_stick_press)) return Kind::right;
    return {};
}

std::vector<Control> pressed_controls(const input::PadState& before, const input::PadState& current) {
    std::vector<Control> controls;
    for (unsigned b = 0; b <= static_cast<unsigned>(PadButton::left); ++b) {
        if ((current.buttons & ~before.buttons & 1U << b) != 0)
            controls.push_back({Control::Source::pad_button, static_cast<int>(b), 0});
    }
    for (std::size_t a = 0; a < input::pad_axes; ++a) {
        const double from = before.axes[a], to = current.axes[a];
        if (std::abs(from) >= menu_stick_press || std::abs(to) < menu_stick_press) continue;
        controls.push_back({Control::Source::pad_axis, static_cast<int>(a), to > 0 ? 1 : -1});
    }
    return controls;
}

std::optional<Kind> menu_event_of(const Control& control, bool start_page) {
    if (control.source == Control::Source::pad_axis)
        return control.code >= static_cast<int>(PadAxis::left_trigger) ? std::optional(Kind::other)
                                                                       : std::nullopt;
    switch (static_cast<PadButton>(control.code)) {
        case PadButton::up:
        case PadButton::down:
        case PadButton::left:
        case PadButton::right: return {};
        case PadButton::a: return Kind::confirm;
        case PadButton::b: return Kind::back;
        case PadButton::start: return start_page ? Kind::other : Kind::back;
        case PadButton::left_bumper: return start_page ? Kind::other : Kind::page_up;
        case PadButton::right_bumper: return start_page ? Kind::other : Kind::page_down;
        default: return Kind::other;
    }
}

}  // namespace thaum::game::inline menu
