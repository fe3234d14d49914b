#include "game/menu/menu.h"

#include <algorithm>
#include <utility>

#include "core/text.h"
#include "game/menu/page.h"
#include "game/settings/player_name.h"

namespace thaum::game::inline menu {

using Kind = MenuEvent::Kind;

bool esc_ends_waiting(const MenuState& state) {
    if (!state.waiting) return false;
    return is_pad_sheet(state.waiting->sheet) || !pauses(*state.waiting);
}

namespace {

// Rows ------------------------------------------------------------------------------------------------------

/// Whether a press only gives its device a seat (a place in the match), and does not act on the chosen row.
/// That is so if the device has no seat yet and another device chose the row, or none did. A row for one
/// player needs no second press: it acts at once if nobody has a seat.
bool only_joins(const MenuState& s, const Row& row, const MenuEvent& event) {
    return shown_page(s).seats && !event.row && s.chooser != event.device && joined(s) < players &&
           !seat_of(s, event.device) && !starts_at_once(s, row);
}

void turn_row(const RowPress& press, int way) {
    if (press.row.turn != nullptr) press.row.turn(press, way);
}

void confirm(const RowPress& press, const MenuEvent& event) {
    if (only_joins(press.state, press.row, event)) return join(press.state, press.device);
    if (press.row.confirm != nullptr)
        press.row.confirm(press);
    else
        turn_row(press, 1);
}

void leave_page(MenuState& s, const MenuEvent& event, const Rows& rows) {
    const auto& page = shown_page(s);
    if (page.leave != nullptr)
        page.leave(s, event.device, rows);
    else
        s.pages.pop_back();
}

// Input for a binding or a name -----------------------------------------------------------------------------

void take_control(MenuState& s, const MenuEvent& event, const MenuContext& context) {
    const Slot slot = *s.waiting;
    if (!fits(slot, event.control)) {
        s.note = is_pad_sheet(slot.sheet) ? "that is not on a pad" : "only a key can do this";
        return;
    }
    const auto before = s.settings;
    const auto losers = assign(s.settings, slot, event.control);
    s.waiting.reset();
    s.undo = before;
    if (losers.empty()) return;
    s.note = text(label_of(event.control), " is taken from:");
    for (const auto loser : losers) {
        s.note += text(loser == losers.front() ? " " : ", ", label_of(loser, context.wands));
        if (loser.sheet != slot.sheet) s.note += text(" (", label_of_sheet(loser.sheet), ")");
    }
}

/// Handles an event while the menu waits for a control; all other events are ignored.
void wait_for_control(MenuState& s, const MenuEvent& event, const MenuContext& context) {
    if (event.kind == Kind::control) take_control(s, event, context);
    if (event.kind == Kind::back) s.waiting.reset();
}

/// Ends typing: the words become the player's name, or the name under which a new profile is saved.
void take_typed(MenuState& s) {
    auto words = player_name(*s.typing).value_or(std::string());
    s.typing.reset();
    if (s.typed == Typing::name) {
        s.settings.players[s.player].name = std::move(words);
    } else if (!words.empty()) {
        s.saves = feel_of(s.settings, s.player);
        s.saves->name = std::move(words);
    }
}

/// Handles an event while words are typed; all other events are ignored.
void type_name(MenuState& s, const MenuEvent& event) {
    switch (event.kind) {
        case Kind::character: s.typing = with_character(std::move(*s.typing), event.typed); break;
        case Kind::erase: s.typing = without_last(std::move(*s.typing)); break;
        case Kind::confirm: take_typed(s); break;
        case Kind::back: s.typing.reset(); break;
        default: break;
    }
}

// Events ----------------------------------------------------------------------------------------------------

constexpr std::size_t page_rows = 8;

void move(std::size_t& cursor, std::size_t count, Kind kind) {
    switch (kind) {
        case Kind::up: cursor = (cursor + count - 1) % count; break;
        case Kind::down: cursor = (cursor + 1) % count; break;
        case Kind::page_up: cursor -= std::min(cursor, page_rows); break;
        case Kind::page_down: cursor = std::min(cursor + page_rows, count - 1); break;
        default: break;
    }
}

bool chooses_row(Kind kind) { return kind <= Kind::page_down || kind == Kind::point; }

void act(MenuState& s, const MenuEvent& event, const MenuContext& context) {
    const auto rows = rows_of(s, context);
    auto& cursor = s.pages.back().cursor;
    cursor = std::min(event.row.value_or(cursor), rows.size() - 1);
    if (chooses_row(event.kind)) s.chooser = event.device;
    const RowPress press{s, context, event.device, rows[cursor]};
    switch (event.kind) {
        case Kind::left: turn_row(press, -1); break;
        case Kind::right: turn_row(press, 1); break;
        case Kind::confirm: confirm(press, event); break;
        case Kind::back: leave_page(s, event, rows); break;
        case Kind::other:
            if (const auto other = shown_page(s).other; other != nullptr) other(s, context, event.device);
            break;
        case Kind::point: break;
        default: move(cursor, rows.size(), event.kind); s.pages.back().middle = cursor;
    }
}

/// Whether a request also ends the pause.
bool ends_pause(MenuRequest request) {
    return request == MenuRequest::go_on || request == MenuRequest::ask_match ||
           request == MenuRequest::forget_gesture;
}

/// Refuses a request that would end the pause while a player has no device.
void keep_pause(MenuState& s, const MenuContext& context) {
    if (context.missing.empty() || !ends_pause(s.request)) return;
    s.request = MenuRequest::none;
    s.note = words_of_refusal(context);
}

}  // namespace

std::string words_of_refusal(const MenuContext& context) { return text("cannot go on: ", context.missing); }

MenuState opened(MenuState state, std::string_view page) {
    const auto last_row = std::exchange(state.pause_row, 0);
    const auto row = page == page_name::pause ? last_row : 0;
    state.pages = {{page, row, row}};
    state.chooser.reset();
    state.typing.reset();
    state.note.clear();
    state.request = MenuRequest::none;
    return state;
}

MenuState step(MenuState state, const MenuEvent& event, const MenuContext& context) {
    state.request = MenuRequest::none;
    state.saves.reset();
    state.tries.reset();
    // Mouse movements must not hide a note before it was read.
    if (event.kind != Kind::point && event.kind != Kind::gone) state.note.clear();
    if (event.kind == Kind::gone) {
        if (const auto seat = seat_of(state, event.device)) state.seats[*seat].reset();
    } else if (state.pages.empty()) {
        return state;
    } else if (state.waiting) {
        wait_for_control(state, event, context);
    } else if (state.typing) {
        type_name(state, event);
    } else {
        act(state, event, context);
        keep_pause(state, context);
    }
    return state;
}

}  // namespace thaum::game::inline menu
