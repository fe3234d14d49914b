// game/menu/page.h: a page of the menu as one value: its title, its rows and how it is reset. Each page is a
// source in game/menu/pages/, which registers it; a row of another page opens it by its name.
//
// Rows are made anew for every event and picture. A row has pointers to the functions that act for it, so
// that the menu needs no list of all kinds of rows.
#pragma once
#include "core/registry.h"
#include "game/menu/menu.h"

namespace thaum::game::inline menu {

struct Row;

/// A press on a row, or a change of its value, with the data on which it can act.
struct RowPress {
    MenuState& state;
    const MenuContext& context;
    const Device& device;
    const Row& row;
};

struct Row {
    MenuRow look{};
    /// Acts on Enter, A and clicks; null: turns the value one step on.
    void (*confirm)(const RowPress&) = nullptr;
    /// Acts on left (-1) and right (1); null: the row has no value to turn.
    void (*turn)(const RowPress&, int way) = nullptr;
    /// index of what the row is about: a setting, an action, a sheet of bindings, a joystick, a fader or a
    /// tactile::Purpose
    std::size_t index = 0;
    std::string_view opens{};  ///< name of the page that a press opens; empty: none
    /// name of the joystick that the row is about, since its index may change; empty: none
    std::string stick{};
    bool next_match = false;  ///< true: a change takes effect with the next match
    bool for_one = false;     ///< true: a press begins a practice for the player who presses
    bool felt = false;        ///< true: a press lets the player feel the value
};

using Rows = std::vector<Row>;

struct Page {
    std::string_view name;  ///< name by which other pages open it; not shown on the screen
    std::string (*title)(const MenuState&, const MenuContext&);
    void (*add_rows)(const MenuState&, const MenuContext&, Rows&);
    /// Sets all values of the page to their defaults. Returns words for these values, such as "settings of
    /// this page". null: the page has no row "Reset to defaults".
    std::string (*reset)(MenuState&) = nullptr;
    /// Text below the title, which may depend on the chosen row; null: none.
    std::string (*line)(const MenuState&, const MenuContext&, const Row&) = nullptr;
    /// Help on the keys, which may depend on the chosen row; null: the help of most pages.
    std::string (*hint)(const MenuState&, const MenuContext&, const Row&) = nullptr;
    /// A fault that the page shows while there is nothing else to report; null: none.
    std::string (*fault)(const MenuContext&) = nullptr;
    /// Acts on Esc, B and the right button; null: the menu returns to the page
    /// before, as the last row "Back" does.
    void (*leave)(MenuState&, const Device&, const Rows&) = nullptr;
    /// Acts on a press of a control that has no meaning in menus; null: nothing happens.
    void (*other)(MenuState&, const MenuContext&, const Device&) = nullptr;
    bool seats = false;    ///< true: players take seats (places in the match) on the page, which shows them
    bool back_row = true;  ///< true: the last row is "Back"
};

/// Registers a page when the program starts. The linker must keep the object file: link to thaum_menu_pages.
using PageRegistration = Registration<Page>;

/// The page of a name, which must be registered.
const Page& page_of(std::string_view name);
inline const Page& shown_page(const MenuState& state) { return page_of(state.pages.back().page); }

/// Rows of the page that is shown.
Rows rows_of(const MenuState& state, const MenuContext& context);

// ---- What rows of several pages do ------------------------------------------------------------------------

/// Opens a page above the one that is shown.
void open_page(MenuState& state, std::string_view page);
/// A row that opens a page.
Row link_to(std::string_view page, std::string label, std::string help);
/// A row that opens a page about one player: the player whose device opens it.
Row link_for_player(std::string_view page, std::string label, std::string help);
/// Adds the rows "Controls" and "Settings", which open the pages "Controls" and "Settings".
void add_page_rows(Rows& rows);
/// A row that chooses the player whose values the page shows.
Row whose_row(const MenuState& state, std::string label);
/// Adds rows for all settings that belong to a page: those of the game, or of the page's player.
void add_settings(const MenuState& state, SettingPage page, Rows& rows);
void add_player_settings(const MenuState& state, SettingPage page, Rows& rows);
/// Sets the settings of the game that belong to a page to their defaults. Returns words for them, as
/// Page::reset does.
std::string reset_settings(MenuState& state, SettingPage page);

/// The next index (`way` 1) or the one before (`way` -1) in a list of `size` entries; past an end it goes on
/// at the other end.
std::size_t turned(std::size_t index, std::size_t size, int way);
template <class List>
void turn(std::size_t& index, const List& list, int way) {
    index = turned(index, list.size(), way);
}

/// The longest of the texts `words`; empty if there are none.
std::string longest(const std::vector<std::string_view>& words);

/// Sends a request to the running match, and ends the pause.
inline void ask_match(MenuState& state, const MatchRequest& request) {
    state.request = MenuRequest::ask_match;
    state.match_request = request;
}

/// Begins the typing of a text, which starts as `words`.
void type(MenuState& state, Typing what, std::string words);

/// The first fault of the joysticks, which several pages show; empty: none.
std::string pad_fault(const MenuContext& context);

// ---- Seats and joysticks ----------------------------------------------------------------------------------

/// Number of players who have joined.
std::size_t joined(const MenuState& state);
/// Seat of a device, which is the number of its player in the match; std::nullopt: it has not joined.
std::optional<std::size_t> seat_of(const MenuState& state, const Device& device);
/// Lets a device join the match: gives it the first seat (player number) that is free.
void join(MenuState& state, const Device& device);
/// Whether a press on the row starts the practice range, or the lessons there (the Apprentice), for the
/// player who presses, because nobody has joined.
inline bool starts_at_once(const MenuState& state, const Row& row) {
    return row.for_one && joined(state) == 0;
}

/// Name of a joystick by its number in MenuState::stick; empty: the joystick was unplugged.
std::string name_of_stick(const MenuContext& context, std::size_t stick);
/// Words of the pause's row that begins the match again: "Restart the match".
std::string label_of_restart(const MenuContext& context);
/// Word for the match that the pause belongs to: "match", "range" or "Apprentice".
std::string_view name_of_play(const MenuContext& context);

}  // namespace thaum::game::inline menu
