// game/menu/menu_rows.h: the rows of the menu's pages, with their words and values. menu.cpp acts on them, and
// menu_picture.cpp shows them.
#pragma once
#include "game/menu/menu.h"

namespace thaum::app {

enum class RowKind : std::uint8_t {
    duel,
    level,
    rules,
    arena,
    range,
    apprentice,
    skip_step,
    repeat_step,
    dummy,
    energy,
    brew,
    controls,
    settings,
    sound,
    quit,
    go_on,
    take_half,
    restart,
    leave,
    sheet,
    set_up_pad,
    forget_pad,
    skip_control,
    action,
    toggle,
    defaults,
    undo,
    setting,
    player_page,
    player,
    name,
    player_setting,
    jacket,
    mixer,
    preset,
    profile,
    save_profile,
    draw_gesture,
    stop_drawing,
    forget_gesture,
    find_force,
    body_fader,
    cauldron,
    fader,
    back,
};

struct Row {
    RowKind kind{};
    std::size_t index = 0;  ///< index of the setting, action, sheet, joystick, fader or tactile::Purpose
    game::MenuRow look;
    bool next_match = false;  ///< true: a change takes effect with the next match
};

/// Rows of the page that is shown.
std::vector<Row> rows_of(const MenuState& state, const MenuContext& context);

/// Words of the pause's row that begins the match again: "Restart the match".
std::string label_of_restart(const MenuContext& context);

/// Name of a joystick by its number in MenuState::stick; empty: it is gone.
std::string name_of_stick(const MenuContext& context, std::size_t stick);

/// Whether the player of the page can find the largest force by feel: it is the one who practises on the range.
bool can_find_force(const MenuState& state, const MenuContext& context);

/// Fader of the forces that a row sets and that can be felt on the range; none for other rows.
input::HandFader felt_fader_of(const Row& row);

/// Number of players who have joined.
std::size_t joined(const MenuState& state);

/// Whether a press on the row starts the range or the Apprentice for the player who presses, because nobody has joined.
bool starts_at_once(const MenuState& state, const Row& row);

}  // namespace thaum::app
