#include "input/bindings.h"

#include <algorithm>
#include <span>

#include "core/letters.h"
#include "core/text.h"

// Defaults are written in the form of the settings file, so that one function reads both and a menu can show
// them.
namespace thaum::input {
namespace {

constexpr std::array<std::string_view, actions> action_names{
    "fire",       "jump",    "next_wand", "previous_wand", "trace",        "stir",      "throw",
    "clutch",     "panic",   "pause",     "rejoin",        "wand_1",       "wand_2",    "wand_3",
    "wand_4",     "wand_5",  "mark",      "confirm",       "quit",         "wand_6",    "wand_7",
    "wand_8",     "wand_9",  "move_left", "move_right",    "move_forward", "move_back", "turn_left",
    "turn_right", "turn_up", "turn_down", "farther",       "nearer"};
static_assert(static_cast<std::size_t>(Action::wand_9) + 1 == button_actions);
static_assert(static_cast<std::size_t>(Action::nearer) + 1 == actions);

constexpr std::array<std::string_view, 5> mouse_names{"left", "right", "middle", "fourth", "fifth"};
constexpr std::array<std::string_view, 15> pad_button_names{
    "a",     "b",          "x",           "y",  "left_bumper", "right_bumper", "back", "start",
    "guide", "left_stick", "right_stick", "up", "right",       "down",         "left"};
constexpr std::array<std::string_view, pad_axes> pad_axis_names{"left_x",  "left_y",       "right_x",
                                                                "right_y", "left_trigger", "right_trigger"};

struct Default {
    Action action;
    std::string_view controls;
};

constexpr Default keyboard_mouse_defaults[] = {
    {Action::move_left, "key a"},      {Action::move_right, "key d"},       {Action::move_forward, "key w"},
    {Action::move_back, "key s"},      {Action::fire, "mouse left"},        {Action::trace, "mouse right"},
    {Action::next_wand, "wheel down"}, {Action::previous_wand, "wheel up"}, {Action::wand_1, "key 1"},
    {Action::wand_2, "key 2"},         {Action::wand_3, "key 3"},           {Action::wand_4, "key 4"},
    {Action::wand_5, "key 5"},         {Action::wand_6, "key 6"},           {Action::wand_7, "key 7"},
    {Action::wand_8, "key 8"},         {Action::wand_9, "key 9"},           {Action::stir, "key e"},
    {Action::jump, "key space"},       {Action::throw_, "key f"},           {Action::clutch, "key left_alt"},
    {Action::panic, "key end"},        {Action::pause, "key escape"},       {Action::confirm, "key enter"},
};

constexpr Default keyboard_half_defaults[] = {
    {Action::move_left, "key kp_4"},    {Action::move_right, "key kp_6"},
    {Action::move_forward, "key kp_8"}, {Action::move_back, "key kp_5"},
    {Action::turn_left, "key left"},    {Action::turn_right, "key right"},
    {Action::turn_up, "key up"},        {Action::turn_down, "key down"},
    {Action::fire, "key kp_0"},         {Action::trace, "key kp_enter"},
    {Action::next_wand, "key kp_add"},  {Action::previous_wand, "key kp_subtract"},
    {Action::wand_1, "key insert"},     {Action::wand_2, "key home"},
    {Action::wand_3, "key page_up"},    {Action::wand_4, "key delete"},
    {Action::wand_5, "key page_down"},  {Action::stir, "key kp_decimal"},
    {Action::jump, "key kp_7"},         {Action::throw_, "key kp_9"},
    {Action::clutch, "key kp_1"},       {Action::panic, "key end"},
    {Action::pause, "key kp_multiply"}, {Action::confirm, "key kp_0"},
    {Action::farther, "key kp_3"},      {Action::nearer, "key kp_2"},
};

constexpr Default pad_defaults[] = {
    {Action::move_left, "pad left_x -"},
    {Action::move_right, "pad left_x +"},
    {Action::move_forward, "pad left_y +"},
    {Action::move_back, "pad left_y -"},
    {Action::turn_left, "pad right_x -"},
    {Action::turn_right, "pad right_x +"},
    {Action::turn_up, "pad right_y +"},
    {Action::turn_down, "pad right_y -"},
    {Action::fire, "pad right_trigger +"},
    // Gestures are drawn while a bumper is held, because the right thumb moves the stick meanwhile. The
    // bumper is on the side of the trigger for stirring, so that one hand can hold both: gestures are drawn
    // with the ladle, too.
    {Action::trace, "pad left_bumper"},
    {Action::next_wand, "pad right_bumper"},
    {Action::previous_wand, "pad left"},
    // The ladle stirs the brew while a trigger is held, because the thumb that would hold a button has to
    // push the right stick, which moves the ladle.
    {Action::stir, "pad left_trigger +"},
    {Action::jump, "pad a"},
    {Action::throw_, "pad right_stick"},
    {Action::clutch, "pad left_stick"},
    {Action::panic, "pad back, key end"},
    {Action::pause, "pad start"},
    {Action::confirm, "pad a"},
    {Action::farther, "pad up"},
    {Action::nearer, "pad down"},
};

std::span<const Default> defaults_of(DeviceKind kind) {
    switch (kind) {
        case DeviceKind::keyboard_mouse: return keyboard_mouse_defaults;
        case DeviceKind::keyboard_half: return keyboard_half_defaults;
        case DeviceKind::pad: return pad_defaults;
        default: return {};
    }
}

std::optional<int> index_in(std::span<const std::string_view> names, std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return {};
    return static_cast<int>(found - names.begin());
}

/// Removes the part before `separator` from `remaining` and returns it without surrounding spaces.
std::string_view take_piece(std::string_view& remaining, char separator) {
    remaining = trimmed(remaining);
    const auto end = std::min(remaining.find(separator), remaining.size());
    const auto piece = trimmed(remaining.substr(0, end));
    remaining = trimmed(remaining.substr(std::min(end + 1, remaining.size())));
    return piece;
}

/// Returns +1 if the word is `plus`, -1 if it is `minus`, otherwise 0.
int direction_of(std::string_view word, std::string_view plus, std::string_view minus) {
    if (word == plus) return 1;
    return word == minus ? -1 : 0;
}

std::optional<Control> pad_control(std::string_view name, std::string_view direction) {
    if (const auto axis = index_in(pad_axis_names, name)) {
        const int sign = direction_of(direction, "+", "-");
        if (sign == 0) return {};
        return Control{Control::Source::pad_axis, *axis, sign};
    }
    const auto button = index_in(pad_button_names, name);
    if (!button || !direction.empty()) return {};
    return Control{Control::Source::pad_button, *button, 0};
}

std::optional<Control> control_of(std::string_view source, std::string_view name, std::string_view more,
                                  const KeyCodes& codes) {
    if (name.empty()) return {};
    if (source == "pad") return pad_control(name, more);
    if (!more.empty()) return {};
    if (source == "wheel") {
        const int sign = direction_of(name, "up", "down");
        if (sign == 0) return {};
        return Control{Control::Source::wheel, 0, sign};
    }
    const bool key = source == "key";
    if (!key && source != "mouse") return {};
    const auto code = key ? codes(name) : index_in(mouse_names, name);
    if (!code) return {};
    return Control{key ? Control::Source::key : Control::Source::mouse_button, *code, 0};
}

}  // namespace

std::string_view name_of(Action action) { return action_names[static_cast<std::size_t>(action)]; }

Expected<Control> parse_control(std::string_view words, const KeyCodes& codes) {
    auto remaining = words;
    const auto source = take_piece(remaining, ' ');
    const auto name = take_piece(remaining, ' ');
    if (const auto control = control_of(source, name, remaining, codes)) return *control;
    return fail(text("unknown control '", words,
                     "' (such as \"key w\", \"mouse left\", \"wheel up\", \"pad a\", \"pad left_x +\")"));
}

Expected<std::vector<Control>> parse_controls(std::string_view words, const KeyCodes& codes) {
    std::vector<Control> controls;
    for (std::string_view remaining = words; !remaining.empty();) {
        const auto control = parse_control(take_piece(remaining, ','), codes);
        if (!control) return control.error();
        controls.push_back(*control);
    }
    return controls;
}

std::string words_of(const Control& control, const KeyNames& names) {
    const auto code = static_cast<std::size_t>(control.code);
    switch (control.source) {
        case Control::Source::key: return text("key ", names(control.code));
        case Control::Source::mouse_button: return text("mouse ", mouse_names.at(code));
        case Control::Source::wheel: return control.direction > 0 ? "wheel up" : "wheel down";
        case Control::Source::pad_button: return text("pad ", pad_button_names.at(code));
        case Control::Source::pad_axis:
            return text("pad ", pad_axis_names.at(code), control.direction > 0 ? " +" : " -");
    }
    return {};
}

std::string words_of(const std::vector<Control>& controls, const KeyNames& names) {
    std::string words;
    for (const auto& control : controls) words += text(words.empty() ? "" : ", ", words_of(control, names));
    return words;
}

namespace {

/// Names of those toggle_actions (actions that may stay on from one press to the next) for which `chosen`
/// returns true, separated by commas.
template <class Chosen>
std::string toggle_words(Chosen chosen) {
    std::string words;
    for (const auto action : toggle_actions) {
        if (chosen(action)) words += text(words.empty() ? "" : ", ", name_of(action));
    }
    return words;
}

std::string all_toggles() {
    return toggle_words([](Action) { return true; });
}

}  // namespace

std::string toggles_of(const Bindings& bindings) {
    return toggle_words([&](Action a) { return bindings.toggled[static_cast<std::size_t>(a)]; });
}

std::vector<std::string> default_key_names() {
    std::vector<std::string> names;
    const KeyCodes collect = [&](std::string_view name) {
        names.emplace_back(name);
        return std::optional<int>(0);
    };
    for (std::size_t kind = 0; kind < device_kinds; ++kind) {
        default_bindings(static_cast<DeviceKind>(kind), collect);
    }
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

Bindings default_bindings(DeviceKind kind, const KeyCodes& codes) {
    Bindings bindings;
    bindings.kind = kind;
    bindings.mouse_look = kind == DeviceKind::keyboard_mouse;
    for (const auto& item : defaults_of(kind)) {
        auto remaining = item.controls;
        while (!remaining.empty()) {
            const auto control = parse_control(take_piece(remaining, ','), codes);
            if (control) bindings.controls[static_cast<std::size_t>(item.action)].push_back(*control);
        }
    }
    return bindings;
}

namespace {

void read_toggles(const ConfigTable& table, Bindings& bindings) {
    if (!table.has("toggle")) return;
    const auto words = table.string("toggle", toggles_of(bindings));
    decltype(bindings.toggled) toggled{};
    for (std::string_view remaining = words; !remaining.empty();) {
        const auto name = take_piece(remaining, ',');
        const auto found = std::find_if(toggle_actions.begin(), toggle_actions.end(),
                                        [&](Action a) { return name_of(a) == name; });
        if (found == toggle_actions.end()) {
            table.report("toggle", text("'toggle': '", name, "' is not one of ", all_toggles()));
            return;
        }
        toggled[static_cast<std::size_t>(*found)] = true;
    }
    bindings.toggled = toggled;
}

}  // namespace

Bindings read_bindings(const ConfigTable& table, Bindings bindings, const KeyCodes& codes) {
    for (std::size_t action = 0; action < actions; ++action) {
        const auto key = action_names[action];
        if (!table.has(key)) continue;
        auto controls = parse_controls(table.string(key, no_control), codes);
        if (controls)
            bindings.controls[action] = std::move(*controls);
        else
            table.report(key, text("'", key, "': ", controls.error().message));
    }
    bindings.trigger_press = table.number("trigger_press", {0.15, 1}, bindings.trigger_press);
    read_toggles(table, bindings);
    return bindings;
}

}  // namespace thaum::input
