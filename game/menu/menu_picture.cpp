// Pictures of the menu: titles, seats, rows and help.
#include <algorithm>

#include "core/text.h"
#include "game/menu/menu_rows.h"

namespace thaum::app {

using input::DeviceKind;

std::string name_of(const Device& device, const MenuContext& context) {
    if (device.kind == DeviceKind::keyboard_mouse)
        return context.arms[0].empty() ? "Mouse and keyboard" : text("Mouse, keys and ", context.arms[0]);
    if (device.kind == DeviceKind::keyboard_half) return "Keypad and arrows";
    const auto& name = context.pads.at(static_cast<std::size_t>(device.pad));
    return name.empty() ? text("Pad ", device.pad + 1) : text("Pad ", device.pad + 1, " (", name, ")");
}

namespace {

std::string title_of(const MenuState& s, const MenuContext& context) {
    switch (s.pages.back().page) {
        case Page::start: return "Thaum";
        case Page::pause: return s.head;
        case Page::sheets: return "Controls";
        case Page::bindings: return text("Controls: ", label_of_sheet(s.sheet));
        case Page::pad_setup: return text("Set up ", name_of_stick(context, s.stick));
        case Page::settings: return "Settings";
        case Page::sound: return "Sound";
        case Page::player: return "Each player's own settings";
        case Page::mixer: return "Forces and body";
        case Page::cauldron: return "Cauldron feedback";
    }
    return {};
}

std::string start_line(const MenuState& s, const Row& row) {
    if (starts_at_once(s, row)) return "press Enter or A to start, or any other key to join";
    switch (joined(s)) {
        case 0: return "press to join";
        case 1: return "press again to start, or a second player joins";
        default: return "press again to start";
    }
}

std::string line_of(const MenuState& s, const MenuContext& context, const Row& row) {
    switch (s.pages.back().page) {
        case Page::start: return start_line(s, row);
        case Page::pause: return s.line;
        case Page::sound: return context.sound;
        case Page::pad_setup: return context.pad_question;
        case Page::mixer: return text("what ", player_words(s.settings, s.player), " feels");
        case Page::cauldron:
            return text("what the hand of ", player_words(s.settings, s.player), " feels while it stirs");
        default: return {};
    }
}

std::string hint_of(const MenuState& s, const MenuContext& context, const Row& row) {
    if (s.waiting) {
        return esc_ends_waiting(s) ? "press the new key or button    Esc: leave it as it is"
                                   : "press the new key or button";
    }
    if (s.typing) return "type the name    Enter: take it    Esc: leave it as it was";
    switch (s.pages.back().page) {
        case Page::start:
            if (starts_at_once(s, row))
                return "choose: arrows, W and S    start: Enter, A, click, keypad 0    "
                       "join: any other key or button";
            return "choose: arrows, W and S    join: Enter, click, any pad button, keypad 0    "
                   "give up a seat: Esc, B, keypad *";
        case Page::pause:
            return text("choose: arrows, W and S, mouse or pad    confirm: Enter, A, click",
                        context.missing.empty() ? "    go on: Esc, Start" : "");
        case Page::cauldron:
            return "less, more: arrows    off, on: Enter, A, click on its name    back: Esc, B, right button";
        case Page::mixer:
            return row.kind == RowKind::body_fader || felt_fader_of(row) != input::HandFader::none
                       ? "less, more: arrows    feel it: Enter, A, click on its name    back: Esc, B, right "
                         "button"
                       : "less, more: arrows    confirm: Enter, A, click    back: Esc, B, right button";
        default:
            return "choose: arrows, W and S, mouse or pad    confirm: Enter, A, click    back: Esc, B, right "
                   "button";
    }
}

/// Name of a player's devices. A second real arm goes to the player without the mouse.
std::string name_of_seat(const MenuState& s, const MenuContext& context, const Device& device) {
    const bool mouse = std::any_of(s.seats.begin(), s.seats.end(), [](const auto& seat) {
        return seat && seat->kind == DeviceKind::keyboard_mouse;
    });
    const auto name = name_of(device, context);
    const bool second = mouse && device.kind != DeviceKind::keyboard_mouse && !context.arms[1].empty();
    return second ? text(name, " and ", context.arms[1]) : name;
}

/// Tells the players of a match that a change of the row does not act in it; empty for other rows and without a match.
std::string words_of_delay(const MenuState& s, const MenuContext& context, const Row& row) {
    if (!row.next_match || s.pages.front().page != Page::pause) return {};
    return text("Applies from the next match, or after \"", label_of_restart(context), "\"");
}

/// A fault that a page shows while there is nothing else to report; empty: none.
std::string fault_shown(Page page, const MenuContext& context) {
    if (page == Page::start && !context.start_fault.empty()) return context.start_fault;
    const bool tells = page == Page::start || page == Page::pause || page == Page::sheets;
    if (!tells || context.pad_faults.empty()) return {};
    const auto more = context.pad_faults.size() - 1;
    return more == 0 ? context.pad_faults.front()
                     : text(context.pad_faults.front(), " (", more, " more in the terminal)");
}

std::string head_of_seat(const MenuState& s, std::size_t player) {
    auto who = player_words(s.settings, player);
    return s.seats[player] ? text(who, ": joined") : who;
}

std::vector<game::MenuSeat> seats_of(const MenuState& s, const MenuContext& context) {
    std::vector<game::MenuSeat> seats;
    for (std::size_t i = 0; i < s.seats.size(); ++i) {
        const auto& seat = s.seats[i];
        const bool bot = !seat && joined(s) == 1;
        seats.push_back({.head = head_of_seat(s, i),
                         .device = seat  ? name_of_seat(s, context, *seat)
                                   : bot ? text("press to join, or bot level ", context.levels[s.level])
                                         : std::string("press to join"),
                         .taken = seat.has_value()});
    }
    return seats;
}

}  // namespace

game::MenuPicture picture_of(const MenuState& s, const MenuContext& context) {
    game::MenuPicture picture;
    if (s.pages.empty()) return picture;
    picture.title = title_of(s, context);
    if (s.pages.back().page == Page::start) picture.seats = seats_of(s, context);
    auto rows = rows_of(s, context);
    picture.cursor = std::min(s.pages.back().cursor, rows.size() - 1);
    picture.middle = std::min(s.pages.back().middle, rows.size() - 1);
    picture.line = line_of(s, context, rows[picture.cursor]);
    picture.hint = hint_of(s, context, rows[picture.cursor]);
    for (auto& row : rows) picture.rows.push_back(std::move(row.look));
    picture.note = s.note;
    if (s.note.empty()) picture.note = words_of_delay(s, context, rows[picture.cursor]);
    if (picture.note.empty()) picture.note = fault_shown(s.pages.back().page, context);
    return picture;
}

std::string window_title(const MenuState& s, const MenuContext& context) {
    if (s.pages.empty()) return "Thaum";
    const auto rows = rows_of(s, context);
    const auto& row = rows[std::min(s.pages.back().cursor, rows.size() - 1)].look;
    return text("Thaum", s.pages.front().page == Page::pause ? " (paused): " : ": ",
                s.pages.size() > 1 ? text(title_of(s, context), " / ") : std::string(), row.label,
                row.value.empty() ? "" : ": ", row.value);
}

}  // namespace thaum::app
