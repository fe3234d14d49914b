#include "game/menu/page.h"

#include <algorithm>

#include "core/assert.h"
#include "core/text.h"
#include "game/hud/layout.h"

namespace thaum::game::inline menu {

const Page& page_of(std::string_view name) {
    const auto* page = registry_of<Page>().find(name);
    THAUM_ASSERT(page != nullptr, "a page is opened that was not registered");
    return *page;
}

// Rows of every page ----------------------------------------------------------------------------------------

namespace {

void reset_page(const RowPress& press) {
    const auto what = shown_page(press.state).reset(press.state);
    press.state.note = text(what, " reset to defaults");
}

void add_last_rows(const Page& page, Rows& rows) {
    if (page.reset != nullptr)
        rows.push_back(
            {.look = {.label = "Reset to defaults", .help = "Sets every value of this page to its default."},
             .confirm = reset_page});
    if (page.back_row)
        rows.push_back({.look = {.label = "Back", .help = "Returns to the page before."},
                        .confirm = [](const RowPress& press) { press.state.pages.pop_back(); }});
}

}  // namespace

Rows rows_of(const MenuState& s, const MenuContext& context) {
    Rows rows;
    const auto& page = shown_page(s);
    page.add_rows(s, context, rows);
    add_last_rows(page, rows);
    return rows;
}

namespace {

/// Whether two rows, of different contexts, stand for the same choice. A row about a joystick is compared by
/// the joystick's name, not by its number, which may change.
bool is_same(const Row& a, const Row& b) {
    return a.confirm == b.confirm && a.turn == b.turn && a.opens == b.opens && a.stick == b.stick &&
           (!a.stick.empty() || a.index == b.index);
}

}  // namespace

MenuState on_same_rows(MenuState state, const MenuContext& before, const MenuContext& context) {
    const auto open_pages = state.pages;
    for (state.pages.clear(); state.pages.size() < open_pages.size();) {
        const auto& page = open_pages[state.pages.size()];
        state.pages.push_back(page);
        const auto rows = rows_of(state, before);
        if (page.cursor >= rows.size()) continue;
        const auto current = rows_of(state, context);
        const auto same =
            std::ranges::find_if(current, [&](const Row& row) { return is_same(row, rows[page.cursor]); });
        if (same == current.end()) continue;
        const auto place = static_cast<std::size_t>(same - current.begin());
        auto& open = state.pages.back();
        open.middle = open.middle + place > page.cursor ? open.middle + place - page.cursor : 0;
        open.cursor = place;
    }
    return state;
}

// Links -----------------------------------------------------------------------------------------------------

void open_page(MenuState& s, std::string_view page) { s.pages.push_back({page, 0, 0}); }

Row link_to(std::string_view page, std::string label, std::string help) {
    return {.look = {.label = std::move(label), .help = std::move(help)},
            .confirm = [](const RowPress& press) { open_page(press.state, press.row.opens); },
            .opens = page};
}

Row link_for_player(std::string_view page, std::string label, std::string help) {
    auto row = link_to(page, std::move(label), std::move(help));
    row.confirm = [](const RowPress& press) {
        auto& s = press.state;
        s.player = seat_of(s, press.device).value_or(s.player);
        open_page(s, press.row.opens);
    };
    return row;
}

void add_page_rows(Rows& rows) {
    rows.push_back(link_to("sheets", "Controls", "Shows and changes which key or button does what."));
    rows.push_back(
        link_to("settings", "Settings", "Changes picture, sound, words, look, forces and recordings."));
}

// Values ----------------------------------------------------------------------------------------------------

std::size_t turned(std::size_t index, std::size_t size, int way) {
    return (index + size + static_cast<std::size_t>(way + static_cast<int>(size))) % size;
}

std::string longest(const std::vector<std::string_view>& words) {
    const auto found = std::ranges::max_element(words, {}, [](auto one) { return width_of(one, 1); });
    return found == words.end() ? std::string() : std::string(*found);
}

Row whose_row(const MenuState& s, std::string label) {
    return {.look = {.label = std::move(label),
                     .help = "Shows this page for the other player.",
                     .value = player_words(s.settings, s.player),
                     .adjustable = true},
            .turn = [](const RowPress& press, int way) {
                turn(press.state.player, press.state.settings.players, way);
            }};
}

namespace {

template <class Of>
Row row_of(std::size_t index, const SettingOf<Of>& setting, const Of& values) {
    const auto* choice = std::get_if<ChoiceOf<Of>>(&setting.kind);
    return {.look = {.label = std::string(setting.label),
                     .help = std::string(setting.help),
                     .value = shown(setting, values),
                     .longest_value = choice != nullptr ? longest(choice->names) : std::string(),
                     .adjustable = true},
            .index = index,
            .next_match = setting.next_match};
}

void turn_setting(const RowPress& press, int way) {
    change(all_settings()[press.row.index], press.state.settings, way);
}

void turn_player_setting(const RowPress& press, int way) {
    auto& s = press.state;
    change(player_settings()[press.row.index], s.settings.players[s.player], way);
}

}  // namespace

void add_settings(const MenuState& s, SettingPage page, Rows& rows) {
    const auto settings = all_settings();
    for (std::size_t i = 0; i < settings.size(); ++i)
        if (settings[i].page == page) {
            rows.push_back(row_of(i, settings[i], s.settings));
            rows.back().turn = turn_setting;
        }
}

void add_player_settings(const MenuState& s, SettingPage page, Rows& rows) {
    const auto settings = player_settings();
    for (std::size_t i = 0; i < settings.size(); ++i)
        if (settings[i].page == page) {
            rows.push_back(row_of(i, settings[i], s.settings.players[s.player]));
            rows.back().turn = turn_player_setting;
        }
}

std::string reset_settings(MenuState& s, SettingPage page) {
    for (const auto& setting : all_settings())
        if (setting.page == page) reset(setting, s.settings);
    return "settings of this page";
}

void type(MenuState& s, Typing what, std::string words) {
    s.typing = std::move(words);
    s.typed = what;
}

// Seats and joysticks ---------------------------------------------------------------------------------------

std::size_t joined(const MenuState& s) {
    return static_cast<std::size_t>(
        std::count_if(s.seats.begin(), s.seats.end(), [](const auto& seat) { return seat.has_value(); }));
}

std::optional<std::size_t> seat_of(const MenuState& s, const Device& device) {
    for (std::size_t i = 0; i < s.seats.size(); ++i) {
        if (s.seats[i] == device) return i;
    }
    return {};
}

void join(MenuState& s, const Device& device) {
    for (auto& seat : s.seats) {
        if (seat) continue;
        seat = device;
        return;
    }
    s.note = "both seats are taken";
}

std::string name_of_stick(const MenuContext& context, std::size_t stick) {
    const auto unknown = context.sticks.size();
    if (stick < unknown) return context.sticks[stick];
    return stick - unknown < context.own_pads.size() ? context.own_pads[stick - unknown] : std::string();
}

std::string pad_fault(const MenuContext& context) {
    if (context.pad_faults.empty()) return {};
    const auto more = context.pad_faults.size() - 1;
    return more == 0 ? context.pad_faults.front()
                     : text(context.pad_faults.front(), " (", more, " more in the terminal)");
}

std::string_view name_of_play(const MenuContext& context) {
    if (context.apprentice) return "Apprentice";
    return context.practice ? "range" : "match";
}

std::string label_of_restart(const MenuContext& context) {
    return text("Restart the ", name_of_play(context));
}

}  // namespace thaum::game::inline menu
