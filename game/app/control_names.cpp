#include "game/app/control_names.h"

#include "game/app/bindings.h"

namespace thaum::app {
namespace {

using input::Action;

/// A label without words that a prompt does not need: "Left mouse" for "Left mouse button".
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

}  // namespace

game::ControlNames control_names(const Settings& settings, input::DeviceKind kind) {
    const auto& bindings = settings.bindings_of(kind);
    game::ControlNames names{.fire = first_label(bindings, Action::fire),
                             .stir = first_label(bindings, Action::stir),
                             .throw_ = first_label(bindings, Action::throw_),
                             .next_wand = first_label(bindings, Action::next_wand)};
    for (std::size_t wand = 0; wand < names.wands.size(); ++wand)
        names.wands[wand] = first_label(bindings, input::wand_action(wand + 1));
    return names;
}

}  // namespace thaum::app
