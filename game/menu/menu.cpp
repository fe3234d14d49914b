#include "game/menu/menu.h"

#include <algorithm>
#include <utility>

#include "core/text.h"
#include "game/menu/menu_rows.h"
#include "game/range/dummy.h"
#include "game/settings/player_name.h"

namespace thaum::app {

using input::DeviceKind;
using Kind = MenuEvent::Kind;

bool esc_ends_waiting(const MenuState& state) {
    if (!state.waiting) return false;
    return is_pad_sheet(state.waiting->sheet) || !pauses(*state.waiting);
}

namespace {

// Seats -----------------------------------------------------------------------------------------------------

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

/// What is wrong with a chosen file; empty: all can be played.
std::string fault_of_choice(const MenuState& s, const MenuContext& context) {
    const auto& rules = context.rules[s.rules].fault;
    return rules.empty() ? context.arenas[s.arena].fault : rules;
}

/// Requests a match, unless a file that was chosen for it is broken.
void start(MenuState& s, MenuRequest request, const MenuContext& context) {
    s.note = fault_of_choice(s, context);
    if (s.note.empty()) s.request = request;
}

/// Joins with a device's first press, and starts the match with its second one.
void join_or_start(MenuState& s, const Device& device, const MenuContext& context) {
    if (seat_of(s, device))
        start(s, MenuRequest::start, context);
    else
        join(s, device);
}

/// Whether this confirmation joins, whatever row is chosen. The device has not chosen that row: somebody else has, or
/// nobody. A row for one player needs no second press: it starts at once if nobody has joined.
bool only_joins(const MenuState& s, const Row& row, const MenuEvent& event) {
    return s.pages.back().page == Page::start && !event.row && s.chooser != event.device &&
           joined(s) < game::players && !seat_of(s, event.device) && !starts_at_once(s, row);
}

/// Requests the range or the Apprentice for one player; the other seat stays empty.
void practise(MenuState& s, const Device& device, MenuRequest request, const MenuContext& context) {
    s.seats = {device};
    start(s, request, context);
}

void leave_seat(MenuState& s, const Device& device) {
    if (const auto seat = seat_of(s, device)) s.seats[*seat].reset();
}

// Values ----------------------------------------------------------------------------------------------------

void open(MenuState& s, Page page) { s.pages.push_back({page, 0, 0}); }

template <class List>
void turn(std::size_t& index, const List& list, int way) {
    const auto size = list.size();
    index = (index + size + static_cast<std::size_t>(way + static_cast<int>(size))) % size;
}

/// Changes a choice for the next match, which the settings remember.
void choose(MenuState& s, RowKind kind, const MenuContext& context, int way) {
    auto& last = s.settings.last;
    if (kind == RowKind::level) {
        turn(s.level, context.levels, way);
        last.bot_level = context.levels[s.level];
    }
    if (kind == RowKind::rules) {
        turn(s.rules, context.rules, way);
        if (context.rules[s.rules].fault.empty()) last.match = context.rules[s.rules].name;
    }
    if (kind == RowKind::arena) {
        turn(s.arena, context.arenas, way);
        if (context.arenas[s.arena].fault.empty()) last.arena = context.arenas[s.arena].name;
    }
}

void turn_toggle(MenuState& s, std::size_t action) {
    auto& toggled = s.settings.bindings_of(settings_hands[s.sheet]).toggled[action];
    toggled = !toggled;
}

/// Chooses the preset after or before the present one. Own values come before the first one.
void turn_preset(MenuState& s, int way) {
    const auto own = feel_of(s.settings, s.player);
    const auto& presets = feel_presets();
    const auto same = std::find_if(presets.begin(), presets.end(),
                                   [&](const auto& preset) { return feels_alike(preset, own); });
    auto index = static_cast<std::size_t>(same - presets.begin());
    if (same == presets.end())
        index = way > 0 ? 0 : presets.size() - 1;
    else
        turn(index, presets, way);
    use(presets[index], s.settings, s.player);
}

void change_body(MenuState& s, std::size_t purpose, int way) {
    constexpr int steps = 10;
    auto& value = s.settings.players[s.player].body.values.at(purpose);
    value = moved_share(value, way, steps);
}

void adjust(MenuState& s, const Row& row, const MenuContext& context, int way) {
    auto& player = s.settings.players[s.player];
    switch (row.kind) {
        case RowKind::level:
        case RowKind::rules:
        case RowKind::arena: choose(s, row.kind, context, way); break;
        case RowKind::dummy: turn(s.dummy, game::dummy_names, way); break;
        case RowKind::energy: s.range.endless_energy = !s.range.endless_energy; break;
        case RowKind::draw_gesture: turn(s.gesture, context.gestures, way); break;
        case RowKind::brew: s.range.harmless_brew = !s.range.harmless_brew; break;
        case RowKind::setting: change(all_settings()[row.index], s.settings, way); break;
        case RowKind::player: turn(s.player, s.settings.players, way); break;
        case RowKind::player_setting: change(player_settings()[row.index], player, way); break;
        case RowKind::fader: change(s.settings.cauldron[s.player][row.index], way); break;
        case RowKind::preset: turn_preset(s, way); break;
        case RowKind::profile:
            if (!context.profiles.empty()) turn(s.profile, context.profiles, way);
            break;
        case RowKind::body_fader: change_body(s, row.index, way); break;
        case RowKind::toggle: turn_toggle(s, row.index); break;
        default: break;
    }
}

void reset_sheet(MenuState& s) {
    s.undo = s.settings;
    const Settings fresh;
    if (s.sheet == session_sheet)
        s.settings.session = fresh.session;
    else
        s.settings.bindings_of(settings_hands[s.sheet]) = fresh.bindings_of(settings_hands[s.sheet]);
}

/// Resets a player's page. The menu cannot name a jacket or a layout, so the player keeps both. What the player feels
/// has a page of its own.
void reset_player(Settings& settings, std::size_t player) {
    const auto felt = feel_of(settings, player);
    auto& own = settings.players[player];
    own = PlayerSettings{.jacket = std::move(own.jacket), .jacket_layout = std::move(own.jacket_layout)};
    use(felt, settings, player);
}

void load_profile(MenuState& s, const MenuContext& context) {
    if (s.profile >= context.profiles.size()) {
        s.note = "no profile was saved yet";
        return;
    }
    use(context.profiles[s.profile], s.settings, s.player);
    s.note = text("loaded ", context.profiles[s.profile].name);
}

/// Sets all values of the page that is shown to their defaults.
void reset_page(MenuState& s) {
    std::string what;
    switch (s.pages.back().page) {
        case Page::bindings:
            reset_sheet(s);
            what = text(label_of_sheet(s.sheet), ": controls");
            break;
        case Page::settings:
        case Page::sound: {
            const auto page = s.pages.back().page == Page::sound ? SettingPage::sound : SettingPage::main;
            for (const auto& setting : all_settings())
                if (setting.page == page) reset(setting, s.settings);
            what = "settings of this page";
            break;
        }
        case Page::player:
            reset_player(s.settings, s.player);
            what = text(player_words(s.settings, s.player), ": settings");
            break;
        case Page::mixer:
            use(feel_presets().front(), s.settings, s.player);
            what = text(player_words(s.settings, s.player), ": forces and body");
            break;
        case Page::cauldron:
            s.settings.cauldron[s.player] = {};
            what = text(player_words(s.settings, s.player), ": cauldron feedback");
            break;
        case Page::start:
        case Page::pause:
        case Page::sheets:
        case Page::pad_setup: return;
    }
    s.note = text(what, " reset to defaults");
}

/// Opens a page about one player, who is the one whose device asks for the page.
void open_for_player(MenuState& s, Page page, const Device& device) {
    s.player = seat_of(s, device).value_or(s.player);
    open(s, page);
}

void switch_fader(MenuState& s, std::size_t source) {
    auto& fader = s.settings.cauldron[s.player][source];
    fader.on = !fader.on;
}

void type(MenuState& s, Typing what, std::string words) {
    s.typing = std::move(words);
    s.typed = what;
}

/// Asks something of the match of the range, which goes on with it.
template <class T>
void ask_range(MenuState& s, T request) {
    s.request = MenuRequest::ask_range;
    s.range_request = RangeRequest(request);
}

/// Lets the player of the range feel a fader of the forces.
void feel_force(MenuState& s, const Row& row, const MenuContext& context) {
    if (can_find_force(s, context)) {
        ask_range(s, FeelForce{felt_fader_of(row)});
    } else {
        s.note = "in the pause of the range a press lets you feel it";
    }
}

void feel_or_adjust(MenuState& s, const Row& row, const MenuContext& context) {
    if (felt_fader_of(row) == input::HandFader::none)
        adjust(s, row, context, 1);
    else
        feel_force(s, row, context);
}

void find_force(MenuState& s, const MenuContext& context) {
    if (can_find_force(s, context))
        ask_range(s, FindForce{});
    else
        s.note = "open this page in the pause of the range";
}

void try_body(MenuState& s, tactile::Purpose purpose) {
    s.tries = {s.player, purpose};
    if (s.settings.players[s.player].body.of(purpose) == 0) s.note = "at 0 % nothing is felt";
}

/// Takes the words that were typed.
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

/// Restores the bindings before their last change. Other settings keep their newest values.
void undo(MenuState& s) {
    if (!s.undo) return;
    s.settings.bindings = s.undo->bindings;
    s.settings.session = s.undo->session;
    s.undo.reset();
    s.note = "undone";
}

// Events ----------------------------------------------------------------------------------------------------

/// Asks something about own gestures. The next pause opens at this row.
void ask_about_gestures(MenuState& s, RowKind row) {
    s.pause_row = s.pages.back().cursor;
    if (row == RowKind::draw_gesture) ask_range(s, DrawGesture{static_cast<std::uint32_t>(s.gesture)});
    if (row == RowKind::stop_drawing) ask_range(s, StopDrawing{});
    if (row == RowKind::forget_gesture) s.request = MenuRequest::forget_gesture;
}

void open_sheet(MenuState& s, std::size_t sheet) {
    s.sheet = sheet;
    open(s, Page::bindings);
}

/// Opens the page that asks for the controls of a joystick.
void set_up_pad(MenuState& s, std::size_t stick) {
    s.stick = stick;
    s.request = MenuRequest::set_up_pad;
    open(s, Page::pad_setup);
}

void skip_control(MenuState& s, const MenuContext& context) {
    if (context.pad_needs_control)
        s.note = "a duel cannot be played without this control";
    else
        s.request = MenuRequest::skip_control;
}

void forget_pad(MenuState& s, std::size_t stick) {
    s.stick = stick;
    s.request = MenuRequest::forget_pad;
}

void confirm(MenuState& s, const Row& row, const MenuEvent& event, const MenuContext& context) {
    if (only_joins(s, row, event)) return join(s, event.device);
    switch (row.kind) {
        case RowKind::duel: join_or_start(s, event.device, context); break;
        case RowKind::range: practise(s, event.device, MenuRequest::range, context); break;
        case RowKind::apprentice: practise(s, event.device, MenuRequest::apprentice, context); break;
        case RowKind::skip_step: ask_range(s, SkipStep{}); break;
        case RowKind::repeat_step: ask_range(s, RepeatStep{}); break;
        case RowKind::controls: open(s, Page::sheets); break;
        case RowKind::settings: open(s, Page::settings); break;
        case RowKind::sound: open(s, Page::sound); break;
        case RowKind::quit: s.request = MenuRequest::quit; break;
        case RowKind::go_on: s.request = MenuRequest::go_on; break;
        case RowKind::take_half: s.request = MenuRequest::take_half; break;
        case RowKind::restart: s.request = MenuRequest::restart; break;
        case RowKind::leave: s.request = MenuRequest::leave; break;
        case RowKind::sheet: open_sheet(s, row.index); break;
        case RowKind::set_up_pad: set_up_pad(s, row.index); break;
        case RowKind::skip_control: skip_control(s, context); break;
        case RowKind::forget_pad: forget_pad(s, row.index); break;
        case RowKind::action: s.waiting = Slot{s.sheet, row.index}; break;
        case RowKind::defaults: reset_page(s); break;
        case RowKind::undo: undo(s); break;
        case RowKind::player_page: open_for_player(s, Page::player, event.device); break;
        case RowKind::name: type(s, Typing::name, s.settings.players[s.player].name); break;
        case RowKind::mixer: open_for_player(s, Page::mixer, event.device); break;
        case RowKind::profile: load_profile(s, context); break;
        case RowKind::save_profile: type(s, Typing::profile, player_words(s.settings, s.player)); break;
        case RowKind::draw_gesture:
        case RowKind::stop_drawing:
        case RowKind::forget_gesture: ask_about_gestures(s, row.kind); break;
        case RowKind::find_force: find_force(s, context); break;
        case RowKind::body_fader: try_body(s, static_cast<tactile::Purpose>(row.index)); break;
        case RowKind::cauldron: open(s, Page::cauldron); break;
        case RowKind::fader: switch_fader(s, row.index); break;
        case RowKind::back: s.pages.pop_back(); break;
        default: feel_or_adjust(s, row, context);
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
        s.pages.back().cursor = s.pages.back().middle = rows.size() - 1;  // Quit is the last row
        s.chooser = event.device;
    }
}

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
    const auto& row = rows[cursor];
    switch (event.kind) {
        case Kind::left: adjust(s, row, context, -1); break;
        case Kind::right: adjust(s, row, context, 1); break;
        case Kind::confirm: confirm(s, row, event, context); break;
        case Kind::back: go_back(s, event, rows); break;
        case Kind::other:
            if (s.pages.back().page == Page::start) join_or_start(s, event.device, context);
            break;
        case Kind::point: break;
        default: move(cursor, rows.size(), event.kind); s.pages.back().middle = cursor;
    }
}

/// Whether a request also ends the pause.
bool ends_pause(MenuRequest request) {
    switch (request) {
        case MenuRequest::go_on:
        case MenuRequest::ask_range:
        case MenuRequest::forget_gesture: return true;
        default: return false;
    }
}

/// Refuses a request that would end the pause while a player has no device.
void keep_pause(MenuState& s, const MenuContext& context) {
    if (context.missing.empty() || !ends_pause(s.request)) return;
    s.request = MenuRequest::none;
    s.note = words_of_refusal(context);
}

}  // namespace

std::string words_of_refusal(const MenuContext& context) { return text("cannot go on: ", context.missing); }

MenuState opened(MenuState state, Page page) {
    const auto last_row = std::exchange(state.pause_row, 0);
    const auto row = page == Page::pause ? last_row : 0;
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
        leave_seat(state, event.device);
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

}  // namespace thaum::app
