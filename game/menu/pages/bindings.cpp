// Menu page: the bindings of one sheet, which are those of one kind of device or of the session.
#include "core/text.h"
#include "game/menu/page.h"

namespace thaum::game::inline menu {
namespace {

std::string labels_of(const std::vector<input::Control>& controls) {
    std::string labels;
    for (const auto& control : controls) labels += text(labels.empty() ? "" : ", ", label_of(control));
    return labels.empty() ? "none" : labels;
}

void wait_for_new_control(const RowPress& press) {
    press.state.waiting = Slot{press.state.sheet, press.row.index};
}

void turn_toggle(const RowPress& press, int) {
    auto& s = press.state;
    auto& toggled = s.settings.bindings_of(settings_hands[s.sheet]).toggled[press.row.index];
    toggled = !toggled;
}

/// Restores the bindings before their last change. Other settings keep their newest values.
void undo(const RowPress& press) {
    auto& s = press.state;
    if (!s.undo) return;
    s.settings.bindings = s.undo->bindings;
    s.settings.session = s.undo->session;
    s.undo.reset();
    s.note = "undone";
}

void add_toggle_rows(const MenuState& s, const MenuContext& context, Rows& rows) {
    const auto& toggled = s.settings.bindings_of(settings_hands[s.sheet]).toggled;
    for (const auto action : input::toggle_actions) {
        const auto index = static_cast<std::size_t>(action);
        rows.push_back(
            {.look = {.label = text(label_of(Slot{s.sheet, index}, context.wands), ": hold or toggle"),
                      .help = "Hold: lasts while pressed. Toggle: one press begins, the next one ends.",
                      .value = toggled[index] ? "toggle" : "hold",
                      .adjustable = true},
             .turn = turn_toggle,
             .index = index});
    }
}

void add_binding_rows(const MenuState& s, const MenuContext& context, Rows& rows) {
    for (std::size_t action = 0; action < size_of_sheet(s.sheet); ++action) {
        const Slot slot{s.sheet, action};
        if (!is_listed(slot, context.wands)) continue;
        const bool waits = s.waiting == slot;
        rows.push_back(
            {.look = {.label = label_of(slot, context.wands),
                      .help = help_of(slot, context.wands),
                      .value = waits ? (is_pad_sheet(s.sheet) ? "press it on the pad ..." : "press it ...")
                                     : labels_of(controls_of(s.settings, slot))},
             .confirm = wait_for_new_control,
             .index = action});
    }
    if (s.sheet != session_sheet) add_toggle_rows(s, context, rows);
    rows.push_back({.look = {.label = "Undo the last change",
                             .help = "Brings the controls back that the last change took away.",
                             .dim = !s.undo},
                    .confirm = undo});
}

std::string reset_sheet(MenuState& s) {
    s.undo = s.settings;
    const Settings fresh;
    if (s.sheet == session_sheet)
        s.settings.session = fresh.session;
    else
        s.settings.bindings_of(settings_hands[s.sheet]) = fresh.bindings_of(settings_hands[s.sheet]);
    return text(label_of_sheet(s.sheet), ": controls");
}

const PageRegistration bindings_page{{
    .name = "bindings",
    .title = [](const MenuState& s,
                const MenuContext&) { return text("Controls: ", label_of_sheet(s.sheet)); },
    .add_rows = add_binding_rows,
    .reset = reset_sheet,
}};

}  // namespace
}  // namespace thaum::game::inline menu
