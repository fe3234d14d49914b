// Menu page: the list of the sheets of bindings (one for each kind of device, and one for the session), and
// of joysticks that can be set up as pads.
#include "core/text.h"
#include "game/menu/page.h"

namespace thaum::game::inline menu {
namespace {

void open_sheet(const RowPress& press) {
    press.state.sheet = press.row.index;
    open_page(press.state, press.row.opens);
}

/// Opens the page that asks for the controls of a joystick.
void set_up_pad(const RowPress& press) {
    press.state.stick = press.row.index;
    press.state.request = MenuRequest::set_up_pad;
    open_page(press.state, press.row.opens);
}

void forget_pad(const RowPress& press) {
    press.state.stick = press.row.index;
    press.state.request = MenuRequest::forget_pad;
}

Row set_up_row(std::string name, std::size_t stick, std::string label, std::string help) {
    return {.look = {.label = std::move(label), .help = std::move(help)},
            .confirm = set_up_pad,
            .index = stick,
            .opens = page_name::pad_setup,
            .stick = std::move(name)};
}

void add_sheet_rows(const MenuState&, const MenuContext& context, Rows& rows) {
    for (std::size_t i = 0; i < sheets; ++i)
        rows.push_back(
            {.look = {.label = label_of_sheet(i),
                      .help = i == session_sheet ? "Shows and changes the keys that belong to no player."
                                                 : "Shows and changes what this device's controls do."},
             .confirm = open_sheet,
             .index = i,
             .opens = "bindings"});
    for (std::size_t i = 0; i < context.sticks.size(); ++i)
        rows.push_back(
            set_up_row(context.sticks[i], i, text("Set up ", context.sticks[i]),
                       "Asks for one control after the other, so that this joystick plays as a pad."));
    for (std::size_t i = 0; i < context.own_pads.size(); ++i) {
        const auto stick = context.sticks.size() + i;
        rows.push_back(
            set_up_row(context.own_pads[i], stick, text("Set up ", context.own_pads[i], " again"),
                       "Asks for all its controls anew. Until the last one the old answers stay."));
        rows.push_back(
            {.look = {.label = text("Forget the set-up of ", context.own_pads[i]),
                      .help = "Takes it out of pads.txt. It plays again once it is set up anew, or if SDL "
                              "knows it."},
             .confirm = forget_pad,
             .index = stick,
             .stick = context.own_pads[i]});
    }
}

const PageRegistration sheets_page{{
    .name = "sheets",
    .title = [](const MenuState&, const MenuContext&) { return std::string("Controls"); },
    .add_rows = add_sheet_rows,
    .fault = pad_fault,
}};

}  // namespace
}  // namespace thaum::game::inline menu
