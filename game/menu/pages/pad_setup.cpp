// Menu page: asks for the controls of a joystick that is no pad yet.
#include "core/text.h"
#include "game/menu/page.h"

namespace thaum::game::inline menu {
namespace {

void skip_control(const RowPress& press) {
    if (press.context.pad_needs_control)
        press.state.note = "a duel cannot be played without this control";
    else
        press.state.request = MenuRequest::skip_control;
}

void add_setup_rows(const MenuState&, const MenuContext& context, Rows& rows) {
    const bool needed = context.pad_needs_control;
    rows.push_back(
        {.look = {.label = "Skip this control",
                  .help = needed ? "A duel needs this one: both sticks, A, RT and Start must be set up."
                                 : "Leaves out a control that the joystick lacks.",
                  .dim = needed},
         .confirm = skip_control});
    rows.push_back({.look = {.label = "Cancel", .help = "Ends the set-up. Nothing is kept."},
                    .confirm = [](const RowPress& press) { press.state.pages.pop_back(); }});
}

const PageRegistration pad_setup_page{{
    .name = page_name::pad_setup,
    .title = [](const MenuState& s,
                const MenuContext& context) { return text("Set up ", name_of_stick(context, s.stick)); },
    .add_rows = add_setup_rows,
    .line = [](const MenuState&, const MenuContext& context, const Row&) { return context.pad_question; },
    .back_row = false,
}};

}  // namespace
}  // namespace thaum::game::inline menu
