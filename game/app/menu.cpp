#include "game/app/menu.h"

#include <algorithm>

#include "core/text.h"
#include "game/bots/dummy.h"

namespace thaum::app {

using input::Control;
using input::DeviceKind;
using Kind = MenuEvent::Kind;

std::string name_of(const Device& device, const MenuContext& context) {
    if (device.kind == DeviceKind::keyboard_mouse)
        return context.arms[0].empty() ? "Mouse and keyboard" : text("Mouse, keys and ", context.arms[0]);
    if (device.kind == DeviceKind::keyboard_half) return "Keypad and arrows";
    const auto& name = context.pads.at(static_cast<std::size_t>(device.pad));
    return name.empty() ? text("Pad ", device.pad + 1) : text("Pad ", device.pad + 1, " (", name, ")");
}

bool esc_ends_waiting(const MenuState& state) {
    if (!state.waiting) return false;
    return is_pad_sheet(state.waiting->sheet) || !pauses(*state.waiting);
}

// Rows ------------------------------------------------------------------------------------------------------

namespace {

enum class RowKind : std::uint8_t {
    duel,
    level,
    rules,
    arena,
    range,
    dummy,
    controls,
    settings,
    quit,
    go_on,
    leave,
    sheet,
    action,
    toggle,
    defaults,
    undo,
    setting,
    cauldron,
    fader_player,
    fader,
    all_felt,
    back,
};

struct Row {
    RowKind kind{};
    std::size_t index = 0;
    game::MenuRow look;
};

std::size_t joined(const MenuState& s) {
    return static_cast<std::size_t>(
        std::count_if(s.seats.begin(), s.seats.end(), [](const auto& seat) { return seat.has_value(); }));
}

std::string duel_label(const MenuState& s) {
    switch (joined(s)) {
        case 0: return "Duel: press any button to join";
        case 1: return "Start against the bot";
        default: return "Start the duel";
    }
}

void add_start_rows(const MenuState& s, const MenuContext& context, std::vector<Row>& rows) {
    rows.push_back({RowKind::duel, 0, {.label = duel_label(s)}});
    const bool alone = joined(s) < game::players;
    rows.push_back({RowKind::level,
                    0,
                    {.label = "Bot",
                     .value = text("level ", context.levels[s.level]),
                     .adjustable = context.levels.size() > 1,
                     .dim = !alone}});
    if (context.rules.size() > 1) {
        rows.push_back({RowKind::rules,
                        0,
                        {.label = "Match", .value = context.rules[s.rules].label, .adjustable = true}});
    }
    if (context.arenas.size() > 1) {
        rows.push_back({RowKind::arena,
                        0,
                        {.label = "Arena", .value = context.arenas[s.arena].label, .adjustable = true}});
    }
    rows.push_back({RowKind::range, 0, {.label = "Range: practise on a dummy"}});
    rows.push_back({RowKind::controls, 0, {.label = "Controls"}});
    rows.push_back({RowKind::settings, 0, {.label = "Settings"}});
    rows.push_back({RowKind::quit, 0, {.label = "Quit"}});
}

void add_pause_rows(const MenuState& s, const MenuContext& context, std::vector<Row>& rows) {
    rows.push_back({RowKind::go_on, 0, {.label = "Go on"}});
    if (context.practice) {
        rows.push_back(
            {RowKind::dummy,
             0,
             {.label = "Dummy", .value = std::string(game::dummy_names[s.dummy]), .adjustable = true}});
    }
    rows.push_back({RowKind::controls, 0, {.label = "Controls"}});
    rows.push_back({RowKind::settings, 0, {.label = "Settings"}});
    const auto* leave = context.practice ? "Leave the range" : "End this match";
    rows.push_back({RowKind::leave, 0, {.label = context.ends_match ? leave : "Quit"}});
}

std::string labels_of(const std::vector<Control>& controls) {
    std::string labels;
    for (const auto& control : controls) labels += text(labels.empty() ? "" : ", ", label_of(control));
    return labels.empty() ? "none" : labels;
}

void add_binding_rows(const MenuState& s, const MenuContext& context, std::vector<Row>& rows) {
    for (std::size_t action = 0; action < size_of_sheet(s.sheet); ++action) {
        const Slot slot{s.sheet, action};
        if (!is_listed(slot, context.wands)) continue;
        const bool waits = s.waiting == slot;
        rows.push_back({RowKind::action,
                        action,
                        {.label = label_of(slot, context.wands),
                         .value = waits ? (is_pad_sheet(s.sheet) ? "press it on the pad ..." : "press it ...")
                                        : labels_of(controls_of(s.settings, slot))}});
    }
    if (s.sheet != session_sheet) {
        const auto& toggled = s.settings.bindings_of(settings_hands[s.sheet]).toggled;
        for (const auto action : input::toggle_actions) {
            const auto index = static_cast<std::size_t>(action);
            rows.push_back({RowKind::toggle,
                            index,
                            {.label = text(label_of(Slot{s.sheet, index}, context.wands), ": hold or toggle"),
                             .value = toggled[index] ? "toggle" : "hold",
                             .adjustable = true}});
        }
    }
    rows.push_back({RowKind::undo, 0, {.label = "Undo the last change", .dim = !s.undo}});
    rows.push_back({RowKind::defaults, 0, {.label = "Reset to defaults"}});
    rows.push_back({RowKind::back, 0, {.label = "Back"}});
}

void add_setting_rows(const MenuState& s, std::vector<Row>& rows) {
    const auto settings = all_settings();
    for (std::size_t i = 0; i < settings.size(); ++i) {
        const auto& one = settings[i];
        rows.push_back(
            {RowKind::setting,
             i,
             {.label = std::string(one.label), .value = shown(one, s.settings), .adjustable = true}});
    }
    rows.push_back({RowKind::cauldron, 0, {.label = "Cauldron feedback"}});
    rows.push_back({RowKind::back, 0, {.label = "Back"}});
}

void add_cauldron_rows(const MenuState& s, std::vector<Row>& rows) {
    rows.push_back(
        {RowKind::fader_player,
         0,
         {.label = "Whose hand", .value = text("player ", s.fader_player + 1), .adjustable = true}});
    const auto& faders = s.settings.cauldron[s.fader_player];
    for (std::size_t i = 0; i < faders.size(); ++i) {
        rows.push_back({RowKind::fader,
                        i,
                        {.label = std::string(label_of_fader(i)),
                         .value = shown(faders[i]),
                         .adjustable = true,
                         .dim = !faders[i].on}});
    }
    rows.push_back({RowKind::all_felt, 0, {.label = "Reset to defaults"}});
    rows.push_back({RowKind::back, 0, {.label = "Back"}});
}

std::vector<Row> rows_of(const MenuState& s, const MenuContext& context) {
    std::vector<Row> rows;
    switch (s.pages.back().page) {
        case Page::start: add_start_rows(s, context, rows); break;
        case Page::pause: add_pause_rows(s, context, rows); break;
        case Page::sheets:
            for (std::size_t i = 0; i < sheets; ++i)
                rows.push_back({RowKind::sheet, i, {.label = label_of_sheet(i)}});
            rows.push_back({RowKind::back, 0, {.label = "Back"}});
            break;
        case Page::bindings: add_binding_rows(s, context, rows); break;
        case Page::settings: add_setting_rows(s, rows); break;
        case Page::cauldron: add_cauldron_rows(s, rows); break;
    }
    return rows;
}

// Steps -----------------------------------------------------------------------------------------------------

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

/// Joins with a device's first press, and starts the match with its second one.
void join_or_start(MenuState& s, const Device& device) {
    if (seat_of(s, device))
        s.request = MenuRequest::start;
    else
        join(s, device);
}

/// Requests the range for one player; the other seat stays empty.
void practise(MenuState& s, const Device& device) {
    s.seats = {device};
    s.request = MenuRequest::range;
}

void leave_seat(MenuState& s, const Device& device) {
    if (const auto seat = seat_of(s, device)) s.seats[*seat].reset();
}

void open(MenuState& s, Page page) { s.pages.push_back({page, 0}); }

template <class List>
void turn(std::size_t& index, const List& list, int way) {
    const auto size = list.size();
    index = (index + size + static_cast<std::size_t>(way + static_cast<int>(size))) % size;
}

void adjust(MenuState& s, const Row& row, const MenuContext& context, int way) {
    switch (row.kind) {
        case RowKind::level: turn(s.level, context.levels, way); break;
        case RowKind::rules: turn(s.rules, context.rules, way); break;
        case RowKind::arena: turn(s.arena, context.arenas, way); break;
        case RowKind::dummy: turn(s.dummy, game::dummy_names, way); break;
        case RowKind::setting: change(all_settings()[row.index], s.settings, way); break;
        case RowKind::fader_player: turn(s.fader_player, s.settings.cauldron, way); break;
        case RowKind::fader: change(s.settings.cauldron[s.fader_player][row.index], way); break;
        case RowKind::toggle: {
            auto& toggled = s.settings.bindings_of(settings_hands[s.sheet]).toggled[row.index];
            toggled = !toggled;
            break;
        }
        default: break;
    }
}

void set_defaults(MenuState& s) {
    s.undo = s.settings;
    const Settings fresh;
    if (s.sheet == session_sheet)
        s.settings.session = fresh.session;
    else
        s.settings.bindings_of(settings_hands[s.sheet]) = fresh.bindings_of(settings_hands[s.sheet]);
    s.note = text(label_of_sheet(s.sheet), ": controls reset to defaults");
}

/// Opens the cauldron's page with the faders of the player whose device asked for it.
void open_cauldron(MenuState& s, const Device& device) {
    s.fader_player = seat_of(s, device).value_or(s.fader_player);
    open(s, Page::cauldron);
}

void switch_fader(MenuState& s, std::size_t source) {
    auto& fader = s.settings.cauldron[s.fader_player][source];
    fader.on = !fader.on;
}

/// Restores the bindings before their last change. Other settings keep their newest values.
void undo(MenuState& s) {
    if (!s.undo) return;
    s.settings.bindings = s.undo->bindings;
    s.settings.session = s.undo->session;
    s.undo.reset();
    s.note = "undone";
}

void confirm(MenuState& s, const Row& row, const MenuEvent& event, const MenuContext& context) {
    switch (row.kind) {
        case RowKind::duel: join_or_start(s, event.device); break;
        case RowKind::range: practise(s, event.device); break;
        case RowKind::controls: open(s, Page::sheets); break;
        case RowKind::settings: open(s, Page::settings); break;
        case RowKind::quit: s.request = MenuRequest::quit; break;
        case RowKind::go_on: s.request = MenuRequest::go_on; break;
        case RowKind::leave: s.request = MenuRequest::leave; break;
        case RowKind::sheet:
            s.sheet = row.index;
            open(s, Page::bindings);
            break;
        case RowKind::action: s.waiting = Slot{s.sheet, row.index}; break;
        case RowKind::defaults: set_defaults(s); break;
        case RowKind::undo: undo(s); break;
        case RowKind::cauldron: open_cauldron(s, event.device); break;
        case RowKind::fader: switch_fader(s, row.index); break;
        case RowKind::all_felt: s.settings.cauldron[s.fader_player] = {}; break;
        case RowKind::back: s.pages.pop_back(); break;
        default: adjust(s, row, context, 1);
    }
}

void go_back(MenuState& s, const MenuEvent& event, const std::vector<Row>& rows) {
    if (s.pages.back().page == Page::pause) {
        s.request = MenuRequest::go_on;
    } else if (s.pages.back().page != Page::start) {
        s.pages.pop_back();
    } else if (seat_of(s, event.device)) {
        leave_seat(s, event.device);
    } else if (event.device.kind == DeviceKind::pad) {
        join(s, event.device);  // any button of a pad joins
    } else {
        s.pages.back().cursor = rows.size() - 1;  // Quit is the last row
    }
}

void take_control(MenuState& s, const MenuEvent& event, const MenuContext& context) {
    const Slot slot = *s.waiting;
    if (!fits(slot.sheet, event.control)) {
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

void act(MenuState& s, const MenuEvent& event, const MenuContext& context) {
    const auto rows = rows_of(s, context);
    auto& cursor = s.pages.back().cursor;
    cursor = std::min(event.row.value_or(cursor), rows.size() - 1);
    const auto& row = rows[cursor];
    switch (event.kind) {
        case Kind::left: adjust(s, row, context, -1); break;
        case Kind::right: adjust(s, row, context, 1); break;
        case Kind::confirm: confirm(s, row, event, context); break;
        case Kind::back: go_back(s, event, rows); break;
        case Kind::other:
            if (s.pages.back().page == Page::start) join_or_start(s, event.device);
            break;
        default: move(cursor, rows.size(), event.kind);
    }
}

}  // namespace

MenuState opened(MenuState state, Page page) {
    state.pages = {{page, 0}};
    state.note.clear();
    state.request = MenuRequest::none;
    return state;
}

MenuState step(MenuState state, const MenuEvent& event, const MenuContext& context) {
    state.request = MenuRequest::none;
    // Mouse movements must not hide a note before it was read.
    if (event.kind != Kind::point && event.kind != Kind::gone) state.note.clear();
    if (event.kind == Kind::gone) {
        leave_seat(state, event.device);
    } else if (state.pages.empty()) {
        return state;
    } else if (state.waiting) {
        wait_for_control(state, event, context);
    } else {
        act(state, event, context);
    }
    return state;
}

// Looks -----------------------------------------------------------------------------------------------------

namespace {

std::string title_of(const MenuState& s) {
    switch (s.pages.back().page) {
        case Page::start: return "Thaum";
        case Page::pause: return s.head;
        case Page::sheets: return "Controls";
        case Page::bindings: return text("Controls: ", label_of_sheet(s.sheet));
        case Page::settings: return "Settings";
        case Page::cauldron: return "The cauldron";
    }
    return {};
}

std::string start_line(const MenuState& s) {
    switch (joined(s)) {
        case 0: return "press to join";
        case 1: return "press again to start, or a second player joins";
        default: return "press again to start";
    }
}

/// Line about the chosen fader, or about the whole page.
std::string cauldron_line(const MenuState& s, const Row& row) {
    if (row.kind == RowKind::fader) return std::string(effect_of_fader(row.index));
    return text("what player ", s.fader_player + 1, "'s hand feels while it stirs");
}

std::string hint_of(const MenuState& s) {
    if (s.waiting) {
        return esc_ends_waiting(s) ? "press the new key or button    Esc: leave it as it is"
                                   : "press the new key or button";
    }
    const auto& open = s.pages.back();
    const auto settings = all_settings();
    if (open.page == Page::settings && open.cursor < settings.size() && settings[open.cursor].next_match)
        return "applies from the next match";
    switch (open.page) {
        case Page::start:
            return "join: any key, mouse or pad button; keypad 0    give up a seat: Esc, B, keypad *";
        case Page::pause: return "choose: arrows, mouse or pad    go on: Esc, Start";
        case Page::cauldron:
            return "less, more: arrows    off, on: Enter, A, click on its name    applies from the next "
                   "match";
        default: return "choose: arrows, mouse or pad    back: Esc, B, right button";
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

std::vector<game::MenuSeat> seats_of(const MenuState& s, const MenuContext& context) {
    std::vector<game::MenuSeat> seats;
    for (std::size_t i = 0; i < s.seats.size(); ++i) {
        const auto& seat = s.seats[i];
        const bool bot = !seat && joined(s) == 1;
        seats.push_back({.head = text("Player ", i + 1, seat ? ": joined" : ""),
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
    const auto page = s.pages.back().page;
    picture.title = title_of(s);
    if (page == Page::start) {
        picture.line = start_line(s);
        picture.seats = seats_of(s, context);
    }
    if (page == Page::pause) picture.line = s.line;
    auto rows = rows_of(s, context);
    picture.cursor = std::min(s.pages.back().cursor, rows.size() - 1);
    if (page == Page::cauldron) picture.line = cauldron_line(s, rows[picture.cursor]);
    for (auto& row : rows) picture.rows.push_back(std::move(row.look));
    picture.note = s.note;
    picture.hint = hint_of(s);
    return picture;
}

}  // namespace thaum::app
