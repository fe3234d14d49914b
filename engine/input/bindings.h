// input/bindings.h: bindings of physical controls to actions. Codes of mice and gamepads are defined here;
// codes and names of keys come from the window layer.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/config.h"
#include "core/error.h"
#include "input/frame.h"

namespace thaum::input {

/// Actions that a control may trigger. First come those that act like a button, in the order of the enum
/// Button, and among them those that select a wand. The directions of motion follow. The last two turn the
/// mouse wheel.
enum class Action : std::uint8_t {
    fire,
    jump,
    next_wand,
    previous_wand,
    trace,
    stir,
    throw_,
    clutch,
    panic,
    pause,
    rejoin,
    wand_1,
    wand_2,
    wand_3,
    wand_4,
    wand_5,
    mark,
    confirm,
    quit,
    wand_6,
    wand_7,
    wand_8,
    wand_9,
    move_left,
    move_right,
    move_forward,
    move_back,
    turn_left,
    turn_right,
    turn_up,
    turn_down,
    // turns of the wheel by keys or buttons, for devices without one; a mouse's own wheel always acts
    farther,
    nearer,
};
inline constexpr std::size_t button_actions = 23;
inline constexpr std::size_t actions = 33;

/// Action that selects a wand, 1 to max_wands.
constexpr Action wand_action(std::size_t wand) {
    const auto first = static_cast<std::size_t>(wand <= 5 ? Action::wand_1 : Action::wand_6);
    return static_cast<Action>(first + wand - (wand <= 5 ? 1 : 6));
}

/// Name of an action: "fire", "next_wand", "throw", "move_left", ... Settings tables use it as key.
std::string_view name_of(Action action);

/// Actions that may stay on from one press to the next (Bindings::toggled).
inline constexpr std::array<Action, 4> toggle_actions{Action::fire, Action::trace, Action::stir,
                                                      Action::clutch};

/// Codes of mouse buttons. The window layer converts its own codes to these, to PadButton and to PadAxis.
enum class MouseButton : std::uint8_t { left, right, middle, fourth, fifth };
/// Buttons of a game pad, by their names on an Xbox pad.
enum class PadButton : std::uint8_t {
    a,
    b,
    x,
    y,
    left_bumper,
    right_bumper,
    back,
    start,
    guide,
    left_stick,
    right_stick,
    up,
    right,
    down,
    left,
};
/// Axes of a game pad. Sticks are positive to the right and up.
enum class PadAxis : std::uint8_t { left_x, left_y, right_x, right_y, left_trigger, right_trigger };
inline constexpr std::size_t pad_axes = 6;

/// A physical control, or one direction of it.
struct Control {
    /// Kind of control.
    enum class Source : std::uint8_t { key, mouse_button, wheel, pad_button, pad_axis };
    Source source{};
    int code{};       ///< code of the key, button or axis; 0 for the wheel
    int direction{};  ///< direction of a wheel or axis: +1 or -1; 0 for other controls
    bool operator==(const Control&) const = default;
};

/// All bindings of one player's hands: the controls of each action, and how they act.
struct Bindings {
    DeviceKind kind{};
    std::array<std::vector<Control>, actions> controls;
    bool mouse_look = false;  ///< true: mouse motion and wheel act for this player
    /// Position at which an axis presses a button; it releases the button 0.1 below.
    double trigger_press = 0.3;
    /// For toggle_actions: one press turns the action on, the next one off.
    std::array<bool, actions> toggled{};
    bool operator==(const Bindings&) const = default;

    /// Controls that are bound to an action.
    std::vector<Control>& of(Action action) { return controls[static_cast<std::size_t>(action)]; }
    const std::vector<Control>& of(Action action) const { return controls[static_cast<std::size_t>(action)]; }
};

/// Returns the window layer's code of a key name such as "w", "space", "kp_8"; nothing for an unknown name.
using KeyCodes = std::function<std::optional<int>(std::string_view)>;
/// Returns the name of a key code; empty for a code that is no key.
using KeyNames = std::function<std::string(int)>;

/// Names of all keys in the default bindings, so that a test can check that the window layer knows each.
std::vector<std::string> default_key_names();

/// Default bindings of a kind of device: keyboard_mouse, keyboard_half (a second player's keys on the same
/// keyboard) or pad. Other kinds have no controls. A key that `codes` does not know is left out.
Bindings default_bindings(DeviceKind kind, const KeyCodes& codes);

/// Returns the bindings with the changes from a settings table:
///
///     fire = "mouse left"                     # replaces all controls of the action; "" leaves none
///     jump = "key space, mouse fourth"
///     next_wand = "wheel down, pad right_bumper"
///     move_left = "key a, pad left_x -"
///     trigger_press = 0.3
///     toggle = "trace, stir"                  # the toggle_actions that stay on until the next press
///
/// An unknown name is reported at its key, and the action keeps the controls that it had. Config::check then
/// returns the fault with file, line and key.
Bindings read_bindings(const ConfigTable& table, Bindings bindings, const KeyCodes& codes);

/// Text that stands for an invalid list of controls. The reader uses it if the value in the settings is no
/// text, a fault that has been reported already.
inline constexpr const char* no_control = "?";

/// Reads one control such as "key w", "mouse left", "wheel up", "pad a", "pad right_trigger +". The error
/// names the unknown control.
Expected<Control> parse_control(std::string_view words, const KeyCodes& codes);

/// Reads all controls of an action, "key space, mouse fourth". The error names the unknown control.
Expected<std::vector<Control>> parse_controls(std::string_view words, const KeyCodes& codes);

/// Writes controls in the form that parse_control and parse_controls read.
std::string words_of(const Control& control, const KeyNames& names);
std::string words_of(const std::vector<Control>& controls, const KeyNames& names);
/// Writes the value of the setting `toggle`: the actions that stay on from one press to the next.
std::string toggles_of(const Bindings& bindings);

}  // namespace thaum::input
