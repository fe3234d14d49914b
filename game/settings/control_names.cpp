#include "game/settings/control_names.h"

#include "core/text.h"
#include "game/settings/bindings.h"

namespace thaum::game::inline settings {
namespace {

using input::Action;

/// A label without words that a prompt can omit: "Left mouse" for "Left mouse button".
std::string short_label_of(const input::Control& control) {
    auto label = label_of(control);
    constexpr std::string_view button = " button";
    if (label.ends_with(button)) label.resize(label.size() - button.size());
    return label;
}

std::string first_label(const input::Bindings& bindings, Action action) {
    const auto& controls = bindings.of(action);
    return controls.empty() ? std::string() : short_label_of(controls.front());
}

/// Names of the controls for four directions: a stick by its own name, "W A S D", or "Keypad 8 4 5 6".
std::string directions(const input::Bindings& bindings, std::initializer_list<Action> actions) {
    constexpr std::string_view keypad = "Keypad ";
    std::string all;
    for (const auto action : actions) {
        const auto& controls = bindings.of(action);
        if (controls.empty()) continue;
        if (controls.front().source == input::Control::Source::pad_axis) {
            const auto label = label_of(controls.front());
            return label.substr(0, label.rfind(' '));
        }
        const auto label = short_label_of(controls.front());
        const bool again = label.starts_with(keypad) && all.starts_with(keypad);
        all += text(all.empty() ? "" : " ", again ? label.substr(keypad.size()) : label);
    }
    return all;
}

}  // namespace

ControlNames control_names(const Settings& settings, input::DeviceKind kind) {
    const auto& bindings = settings.bindings_of(kind);
    ControlNames names{.fire = first_label(bindings, Action::fire),
                       .stir = first_label(bindings, Action::stir),
                       .throw_ = first_label(bindings, Action::throw_),
                       .next_wand = first_label(bindings, Action::next_wand),
                       .trace = first_label(bindings, Action::trace)};
    names.move = directions(bindings,
                            {Action::move_forward, Action::move_left, Action::move_back, Action::move_right});
    names.aside = directions(bindings, {Action::move_left, Action::move_right});
    names.look = bindings.mouse_look ? std::string("Mouse")
                                     : directions(bindings, {Action::turn_up, Action::turn_left,
                                                             Action::turn_down, Action::turn_right});
    const auto toggled = [&](Action action) { return bindings.toggled[static_cast<std::size_t>(action)]; };
    names.fire_toggles = toggled(Action::fire);
    names.trace_toggles = toggled(Action::trace);
    names.stir_toggles = toggled(Action::stir);
    names.jump = first_label(bindings, Action::jump);
    names.pause = first_label(bindings, Action::pause);
    const auto& pause = settings.of(SessionKey::pause);
    if (names.pause.empty() && kind != input::DeviceKind::pad && !pause.empty())
        names.pause = short_label_of(pause.front());
    for (std::size_t wand = 0; wand < names.wands.size(); ++wand)
        names.wands[wand] = first_label(bindings, input::wand_action(wand + 1));
    return names;
}

}  // namespace thaum::game::inline settings
