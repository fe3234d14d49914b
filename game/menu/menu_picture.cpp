// Pictures of the menu: titles, seats (which device has joined as which player), rows and help. The words of
// a page stand in its own file.
#include <algorithm>

#include "core/text.h"
#include "game/menu/page.h"

namespace thaum::game::inline menu {

using input::DeviceKind;

std::string name_of(const Device& device, const MenuContext& context) {
    if (device.kind == DeviceKind::keyboard_mouse)
        return context.arms[0].empty() ? "Mouse and keyboard" : text("Mouse, keys and ", context.arms[0]);
    if (device.kind == DeviceKind::keyboard_half) return "Keypad and arrows";
    const auto& name = context.pads.at(static_cast<std::size_t>(device.pad));
    return name.empty() ? text("Pad ", device.pad + 1) : text("Pad ", device.pad + 1, " (", name, ")");
}

namespace {

std::string line_of(const Page& page, const MenuState& s, const MenuContext& context, const Row& row) {
    return page.line != nullptr ? page.line(s, context, row) : std::string();
}

std::string hint_of(const Page& page, const MenuState& s, const MenuContext& context, const Row& row) {
    if (s.waiting) {
        return esc_ends_waiting(s) ? "press the new key or button    Esc: leave it as it is"
                                   : "press the new key or button";
    }
    if (s.typing) return "type the name    Enter: take it    Esc: leave it as it was";
    if (page.hint != nullptr) return page.hint(s, context, row);
    return "choose: arrows, W and S, mouse or pad    confirm: Enter, A, click    back: Esc, B, right button";
}

/// Name of a player's device. If another player has the mouse and there is a second real arm, that arm
/// belongs to this player, and its name follows.
std::string name_of_seat(const MenuState& s, const MenuContext& context, const Device& device) {
    const bool mouse = std::any_of(s.seats.begin(), s.seats.end(), [](const auto& seat) {
        return seat && seat->kind == DeviceKind::keyboard_mouse;
    });
    const auto name = name_of(device, context);
    const bool second = mouse && device.kind != DeviceKind::keyboard_mouse && !context.arms[1].empty();
    return second ? text(name, " and ", context.arms[1]) : name;
}

/// Text which says that a change of this row takes effect with the next match. It is only needed in the pause
/// of a match; empty for other rows and without a match.
std::string words_of_delay(const MenuState& s, const MenuContext& context, const Row& row) {
    if (!row.next_match || s.pages.front().page != page_name::pause) return {};
    return text("Applies from the next match, or after \"", label_of_restart(context), "\"");
}

std::string head_of_seat(const MenuState& s, std::size_t player) {
    auto who = player_words(s.settings, player);
    return s.seats[player] ? text(who, ": joined") : who;
}

std::vector<MenuSeat> seats_of(const MenuState& s, const MenuContext& context) {
    std::vector<MenuSeat> seats;
    for (std::size_t i = 0; i < s.seats.size(); ++i) {
        const auto& seat = s.seats[i];
        const bool bot = !seat && joined(s) == 1;
        seats.push_back({.head = head_of_seat(s, i),
                         .device = seat  ? name_of_seat(s, context, *seat)
                                   : bot ? text("press to join, or bot: ", context.bots[s.bot].label)
                                         : std::string("press to join"),
                         .taken = seat.has_value()});
    }
    return seats;
}

}  // namespace

MenuPicture picture_of(const MenuState& s, const MenuContext& context) {
    MenuPicture picture;
    if (s.pages.empty()) return picture;
    const auto& page = shown_page(s);
    auto rows = rows_of(s, context);
    picture.cursor = std::min(s.pages.back().cursor, rows.size() - 1);
    picture.middle = std::min(s.pages.back().middle, rows.size() - 1);
    const auto& chosen = rows[picture.cursor];
    picture.title = page.title(s, context);
    if (page.seats) picture.seats = seats_of(s, context);
    picture.line = line_of(page, s, context, chosen);
    picture.hint = hint_of(page, s, context, chosen);
    picture.note = s.note;
    if (picture.note.empty()) picture.note = words_of_delay(s, context, chosen);
    if (picture.note.empty() && page.fault != nullptr) picture.note = page.fault(context);
    for (auto& row : rows) picture.rows.push_back(std::move(row.look));
    return picture;
}

std::string window_title(const MenuState& s, const MenuContext& context) {
    if (s.pages.empty()) return "Thaum";
    const auto rows = rows_of(s, context);
    const auto& row = rows[std::min(s.pages.back().cursor, rows.size() - 1)].look;
    return text("Thaum", s.pages.front().page == page_name::pause ? " (paused): " : ": ",
                s.pages.size() > 1 ? text(shown_page(s).title(s, context), " / ") : std::string(), row.label,
                row.value.empty() ? "" : ": ", row.value);
}

}  // namespace thaum::game::inline menu
