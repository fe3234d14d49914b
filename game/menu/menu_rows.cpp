#include "game/menu/menu_rows.h"

#include <algorithm>

#include "core/text.h"
#include "game/hud/layout.h"
#include "game/range/dummy.h"
#include "game/range/range.h"

namespace thaum::app {

using input::Control;

std::size_t joined(const MenuState& s) {
    return static_cast<std::size_t>(
        std::count_if(s.seats.begin(), s.seats.end(), [](const auto& seat) { return seat.has_value(); }));
}

std::string name_of_stick(const MenuContext& context, std::size_t stick) {
    const auto unknown = context.sticks.size();
    if (stick < unknown) return context.sticks[stick];
    return stick - unknown < context.own_pads.size() ? context.own_pads[stick - unknown] : std::string();
}

bool can_find_force(const MenuState& s, const MenuContext& context) {
    return context.practice && !context.apprentice && s.player == game::practising;
}

namespace {

/// Whether a setting is about this value of a player.
template <class T>
bool is_about(const PlayerSetting& setting, T PlayerSettings::*value) {
    using Kind =
        std::conditional_t<std::is_same_v<T, int>, WholeOf<PlayerSettings>, NumberOf<PlayerSettings>>;
    const auto* kind = std::get_if<Kind>(&setting.kind);
    return kind != nullptr && kind->value == value;
}

}  // namespace

input::HandFader felt_fader_of(const Row& row) {
    if (row.kind != RowKind::player_setting) return input::HandFader::none;
    const auto& setting = player_settings()[row.index];
    if (is_about(setting, &PlayerSettings::carried_weight)) return input::HandFader::weight;
    if (is_about(setting, &PlayerSettings::carried_blows)) return input::HandFader::blows;
    return is_about(setting, &PlayerSettings::recoil) ? input::HandFader::recoil : input::HandFader::none;
}

bool starts_at_once(const MenuState& s, const Row& row) {
    const bool for_one = row.kind == RowKind::apprentice || row.kind == RowKind::range;
    return for_one && s.pages.back().page == Page::start && joined(s) == 0;
}

namespace {

using Rows = std::vector<Row>;

void add_back_row(Rows& rows) {
    rows.push_back({RowKind::back, 0, {.label = "Back", .help = "Returns to the page before."}});
}

void add_defaults_row(Rows& rows) {
    rows.push_back({RowKind::defaults,
                    0,
                    {.label = "Reset to defaults", .help = "Sets every value of this page to its default."}});
}

void add_page_rows(Rows& rows) {
    rows.push_back({RowKind::controls,
                    0,
                    {.label = "Controls", .help = "Shows and changes which key or button does what."}});
    rows.push_back(
        {RowKind::settings,
         0,
         {.label = "Settings", .help = "Changes picture, sound, words, look, forces and recordings."}});
}

template <class Words>
std::string longest(const Words& words) {
    const auto found = std::max_element(words.begin(), words.end(), [](const auto& a, const auto& b) {
        return game::width_of(a, 1) < game::width_of(b, 1);
    });
    return found == words.end() ? std::string() : std::string(*found);
}

std::string longest_label(const std::vector<MenuContext::Named>& list) {
    std::vector<std::string_view> labels;
    for (const auto& one : list) labels.emplace_back(one.label);
    return longest(labels);
}

// Start and pause -------------------------------------------------------------------------------------------

std::string duel_label(const MenuState& s) {
    switch (joined(s)) {
        case 0: return "Duel: press any button to join";
        case 1: return "Start against the bot";
        default: return "Start the duel";
    }
}

/// The row of a choice among data files. A broken file says what is wrong with it, and cannot be played.
game::MenuRow choice_row(std::string label, const std::string& help,
                         const std::vector<MenuContext::Named>& list, std::size_t chosen) {
    const auto& one = list[chosen];
    return {.label = std::move(label),
            .help = one.fault.empty() ? help : one.fault,
            .value = one.label,
            .longest_value = longest_label(list),
            .adjustable = true,
            .dim = !one.fault.empty()};
}

void add_choice_rows(const MenuState& s, const MenuContext& context, Rows& rows) {
    rows.push_back({RowKind::level,
                    0,
                    {.label = "Bot",
                     .help = context.level_fault.empty()
                                 ? "Sets how well the bot plays, which takes a seat that nobody joins."
                                 : context.level_fault,
                     .value = text("level ", context.levels[s.level]),
                     .adjustable = context.levels.size() > 1,
                     .dim = joined(s) == game::players}});
    if (context.rules.size() > 1) {
        rows.push_back({RowKind::rules, 0,
                        choice_row("Match", "Sets how many kills win, and how long a round lasts.",
                                   context.rules, s.rules)});
    }
    if (context.arenas.size() > 1) {
        rows.push_back({RowKind::arena, 0,
                        choice_row("Arena", "Sets the place of the duel, which is shown behind this menu.",
                                   context.arenas, s.arena)});
    }
}

void add_apprentice_row(Rows& rows) {
    rows.push_back({RowKind::apprentice,
                    0,
                    {.label = "Apprentice (3 min)",
                     .help = "Teaches one player everything, step by step. Leave it at any time."}});
}

void add_start_rows(const MenuState& s, const MenuContext& context, Rows& rows) {
    if (context.first_start) add_apprentice_row(rows);
    rows.push_back(
        {RowKind::duel,
         0,
         {.label = duel_label(s), .help = "The first press of a device joins, and the next one starts."}});
    add_choice_rows(s, context, rows);
    if (!context.first_start) add_apprentice_row(rows);
    rows.push_back({RowKind::range,
                    0,
                    {.label = "Range: practise on a dummy",
                     .help = "Plays alone, without an end and without a recording."}});
    add_page_rows(rows);
    rows.push_back({RowKind::quit, 0, {.label = "Quit", .help = "Ends the program."}});
}

void add_range_rows(const MenuState& s, Rows& rows) {
    rows.push_back({RowKind::dummy,
                    0,
                    {.label = "Dummy",
                     .help = "Lets the dummy stand still, walk to and fro, or shoot back.",
                     .value = std::string(game::dummy_names[s.dummy]),
                     .longest_value = longest(game::dummy_names),
                     .adjustable = true}});
    rows.push_back({RowKind::energy,
                    0,
                    {.label = "Energy of the wands",
                     .help = "Keeps every wand full, or lets shots use it up as in a match.",
                     .value = s.range.endless_energy ? "endless" : "as in a match",
                     .longest_value = "as in a match",
                     .adjustable = true}});
    rows.push_back({RowKind::brew,
                    0,
                    {.label = "Effects of the brew",
                     .help = "Lets the brew slow, lift and scald wizards, or leave them alone.",
                     .value = s.range.harmless_brew ? "off" : "as in a match",
                     .longest_value = "as in a match",
                     .adjustable = true}});
}

void add_gesture_rows(const MenuState& s, const MenuContext& context, Rows& rows) {
    if (context.gestures.empty()) return;
    std::vector<std::string> names;
    for (const auto& gesture : context.gestures) names.push_back(capitalised(gesture));
    const auto& name = names[s.gesture % names.size()];
    if (context.drawn_gesture > 0 && context.drawn_gesture <= names.size())
        rows.push_back({RowKind::stop_drawing,
                        0,
                        {.label = text("Give up drawing ", names[context.drawn_gesture - 1]),
                         .help = "Ends the drawing of an own gesture. Nothing is saved."}});
    else
        rows.push_back(
            {RowKind::draw_gesture,
             0,
             {.label = "Own gesture",
              .help = "Left and right choose a gesture. A press lets you draw it your way, three times.",
              .value = name,
              .longest_value = longest(names),
              .adjustable = true}});
    rows.push_back({RowKind::forget_gesture,
                    0,
                    {.label = text("Usual ", name, " again"),
                     .help = "Forgets your own strokes for this gesture, so that the game's count again."}});
}

void add_lesson_rows(Rows& rows) {
    rows.push_back({RowKind::skip_step,
                    0,
                    {.label = "Skip this step", .help = "Goes on to the next step of the Apprentice."}});
    rows.push_back({RowKind::repeat_step,
                    0,
                    {.label = "Repeat this step", .help = "Begins this step of the Apprentice again."}});
}

/// Calls what the pause belongs to: "match", "range" or "Apprentice".
std::string_view name_of_play(const MenuContext& context) {
    if (context.apprentice) return "Apprentice";
    return context.practice ? "range" : "match";
}

std::string_view help_of_go_on(const MenuContext& context) {
    if (!context.missing.empty()) return "Plays on once every player has a device.";
    if (context.apprentice || context.practice) return "Closes this menu and plays on for everybody.";
    return "Plays on for everybody. Hold Stir at the cauldron, at the orb below the violet light, or at a "
           "crystal below a blue light.";
}

void add_go_on_rows(const MenuContext& context, Rows& rows) {
    rows.push_back(
        {RowKind::go_on,
         0,
         {.label = "Go on", .help = std::string(help_of_go_on(context)), .dim = !context.missing.empty()}});
    if (context.half_for.empty()) return;
    rows.push_back({RowKind::take_half,
                    0,
                    {.label = text("Keypad and arrows for ", context.half_for),
                     .help = "Gives this player half of the keyboard until a button of a pad is pressed."}});
}

void add_pause_rows(const MenuState& s, const MenuContext& context, Rows& rows) {
    add_go_on_rows(context, rows);
    if (context.apprentice)
        add_lesson_rows(rows);
    else if (context.practice) {
        add_range_rows(s, rows);
        add_gesture_rows(s, context, rows);
    }
    add_page_rows(rows);
    rows.push_back(
        {RowKind::restart,
         0,
         {.label = label_of_restart(context),
          .help = context.practice ? "Puts the arena and the score back to their beginning."
                                   : "Gives up this match and begins another with the same players."}});
    const auto leave =
        context.practice ? text("Leave the ", name_of_play(context)) : std::string("End this match");
    rows.push_back({RowKind::leave,
                    0,
                    {.label = context.ends_match ? leave : std::string("Quit"),
                     .help = context.ends_match ? "Returns to the start screen." : "Ends the program."}});
}

// Controls --------------------------------------------------------------------------------------------------

void add_sheet_rows(const MenuContext& context, Rows& rows) {
    for (std::size_t i = 0; i < sheets; ++i) {
        const auto label = label_of_sheet(i);
        rows.push_back({RowKind::sheet,
                        i,
                        {.label = label,
                         .help = i == session_sheet ? "Shows and changes the keys that belong to no player."
                                                    : "Shows and changes what this device's controls do."}});
    }
    for (std::size_t i = 0; i < context.sticks.size(); ++i)
        rows.push_back(
            {RowKind::set_up_pad,
             i,
             {.label = text("Set up ", context.sticks[i]),
              .help = "Asks for one control after the other, so that this joystick plays as a pad."}});
    for (std::size_t i = 0; i < context.own_pads.size(); ++i) {
        const auto stick = context.sticks.size() + i;
        rows.push_back(
            {RowKind::set_up_pad,
             stick,
             {.label = text("Set up ", context.own_pads[i], " again"),
              .help = "Asks for all its controls anew. Until the last one the old answers stay."}});
        rows.push_back({RowKind::forget_pad,
                        stick,
                        {.label = text("Forget the set-up of ", context.own_pads[i]),
                         .help = "Takes it out of pads.txt. It plays again once it is set up anew, or if SDL "
                                 "knows it."}});
    }
    add_back_row(rows);
}

void add_setup_rows(const MenuContext& context, Rows& rows) {
    const bool needed = context.pad_needs_control;
    rows.push_back({RowKind::skip_control,
                    0,
                    {.label = "Skip this control",
                     .help = needed ? "A duel needs this one: both sticks, A, RT and Start must be set up."
                                    : "Leaves out a control that the joystick lacks.",
                     .dim = needed}});
    rows.push_back({RowKind::back, 0, {.label = "Cancel", .help = "Ends the set-up. Nothing is kept."}});
}

std::string labels_of(const std::vector<Control>& controls) {
    std::string labels;
    for (const auto& control : controls) labels += text(labels.empty() ? "" : ", ", label_of(control));
    return labels.empty() ? "none" : labels;
}

void add_toggle_rows(const MenuState& s, const MenuContext& context, Rows& rows) {
    const auto& toggled = s.settings.bindings_of(settings_hands[s.sheet]).toggled;
    for (const auto action : input::toggle_actions) {
        const auto index = static_cast<std::size_t>(action);
        rows.push_back({RowKind::toggle,
                        index,
                        {.label = text(label_of(Slot{s.sheet, index}, context.wands), ": hold or toggle"),
                         .help = "Hold: lasts while pressed. Toggle: one press begins, the next one ends.",
                         .value = toggled[index] ? "toggle" : "hold",
                         .adjustable = true}});
    }
}

void add_binding_rows(const MenuState& s, const MenuContext& context, Rows& rows) {
    for (std::size_t action = 0; action < size_of_sheet(s.sheet); ++action) {
        const Slot slot{s.sheet, action};
        if (!is_listed(slot, context.wands)) continue;
        const bool waits = s.waiting == slot;
        rows.push_back({RowKind::action,
                        action,
                        {.label = label_of(slot, context.wands),
                         .help = help_of(slot, context.wands),
                         .value = waits ? (is_pad_sheet(s.sheet) ? "press it on the pad ..." : "press it ...")
                                        : labels_of(controls_of(s.settings, slot))}});
    }
    if (s.sheet != session_sheet) add_toggle_rows(s, context, rows);
    rows.push_back({RowKind::undo,
                    0,
                    {.label = "Undo the last change",
                     .help = "Brings the controls back that the last change took away.",
                     .dim = !s.undo}});
    add_defaults_row(rows);
    add_back_row(rows);
}

// Settings --------------------------------------------------------------------------------------------------

template <class Of>
Row row_of(RowKind kind, std::size_t index, const SettingOf<Of>& setting, const Of& values) {
    const auto* choice = std::get_if<ChoiceOf<Of>>(&setting.kind);
    return {kind,
            index,
            {.label = std::string(setting.label),
             .help = std::string(setting.help),
             .value = shown(setting, values),
             .longest_value = choice != nullptr ? longest(choice->names) : std::string(),
             .adjustable = true},
            setting.next_match};
}

void add_settings(const MenuState& s, SettingPage page, Rows& rows) {
    const auto settings = all_settings();
    for (std::size_t i = 0; i < settings.size(); ++i)
        if (settings[i].page == page) rows.push_back(row_of(RowKind::setting, i, settings[i], s.settings));
}

void add_sound_rows(const MenuState& s, Rows& rows) {
    add_settings(s, SettingPage::sound, rows);
    add_defaults_row(rows);
    add_back_row(rows);
}

void add_setting_rows(const MenuState& s, Rows& rows) {
    add_settings(s, SettingPage::main, rows);
    rows.push_back(
        {RowKind::sound,
         0,
         {.label = "Sound", .help = "Changes how loud effects, music and menus are, and for whose ears."}});
    rows.push_back(
        {RowKind::player_page,
         0,
         {.label = "Each player's own settings", .help = "Changes a player's name, captions and look."}});
    rows.push_back({RowKind::mixer,
                    0,
                    {.label = "Forces and body",
                     .help = "Mixes what each player's hand and body feel, and keeps mixes as profiles."}});
    add_defaults_row(rows);
    add_back_row(rows);
}

void add_whose_row(const MenuState& s, std::string label, Rows& rows) {
    rows.push_back({RowKind::player,
                    0,
                    {.label = std::move(label),
                     .help = "Shows this page for the other player.",
                     .value = player_words(s.settings, s.player),
                     .adjustable = true}});
}

/// Words that fit a row.
std::string shortened(const std::string& words) {
    constexpr std::size_t most = 24;
    return words.size() <= most ? words : words.substr(0, most - 3) + "...";
}

void add_player_rows(const MenuState& s, Rows& rows) {
    const auto& player = s.settings.players[s.player];
    const auto& team = player.name.empty() ? std::string("none") : player.name;
    add_whose_row(s, "Whose settings", rows);
    rows.push_back({RowKind::name,
                    0,
                    {.label = "Name",
                     .help = "Stands on the screen instead of the team's name.",
                     .value = s.typing && s.typed == Typing::name ? text(*s.typing, "_") : team}});
    const auto settings = player_settings();
    for (std::size_t i = 0; i < settings.size(); ++i)
        if (settings[i].page == SettingPage::main)
            rows.push_back(row_of(RowKind::player_setting, i, settings[i], player));
    add_defaults_row(rows);
    add_back_row(rows);
}

// Forces and body -------------------------------------------------------------------------------------------

/// Name of the preset that feels like the player's values; "own" if none does.
std::string preset_of(const MenuState& s) {
    const auto own = feel_of(s.settings, s.player);
    for (const auto& preset : feel_presets())
        if (feels_alike(preset, own)) return preset.name;
    return "own";
}

void add_profile_rows(const MenuState& s, const MenuContext& context, Rows& rows) {
    const auto& profiles = context.profiles;
    rows.push_back({RowKind::preset,
                    0,
                    {.label = "Preset",
                     .help = "Sets forces, motors and body: gentle, all that devices can do, or nothing.",
                     .value = preset_of(s),
                     .longest_value = "gentle",
                     .adjustable = true}});
    rows.push_back(
        {RowKind::profile,
         0,
         {.label = "Load a profile",
          .help = "Sets all values of this page as they were saved under this name.",
          .value = s.profile < profiles.size() ? profiles[s.profile].name : std::string("none saved"),
          .adjustable = profiles.size() > 1,
          .dim = profiles.empty()}});
    const bool types = s.typing && s.typed == Typing::profile;
    rows.push_back({RowKind::save_profile,
                    0,
                    {.label = "Save as a profile",
                     .help = "Keeps all values of this page under a name.",
                     .value = types ? text(*s.typing, "_") : std::string()}});
}

/// State of the player's jacket, or how to name one.
std::string jacket_help(const MenuContext& context, std::size_t player) {
    const auto& state = context.jackets.at(player);
    return state.empty() ? std::string("Is changed in the settings file only; its comment says how.") : state;
}

void add_body_rows(const MenuState& s, const MenuContext& context, Rows& rows) {
    const auto& player = s.settings.players[s.player];
    for (const auto purpose : context.body) {
        rows.push_back({RowKind::body_fader,
                        static_cast<std::size_t>(purpose),
                        {.label = text("Body: ", label_of(purpose)),
                         .help = std::string(effect_of(purpose)),
                         .value = percent_words(player.body.of(purpose)),
                         .longest_value = "100 %",
                         .adjustable = true}});
    }
    rows.push_back({RowKind::jacket,
                    0,
                    {.label = "Jacket",
                     .help = jacket_help(context, s.player),
                     .value = player.jacket.empty() ? std::string("none") : shortened(player.jacket),
                     .dim = true}});
}

Row find_force_row(const MenuState& s, const MenuContext& context) {
    return {RowKind::find_force,
            0,
            {.label = "Find it by feel",
             .help = "Kicks the hand more and more until you press fire. Only on the range.",
             .dim = !can_find_force(s, context)}};
}

void add_mixer_rows(const MenuState& s, const MenuContext& context, Rows& rows) {
    add_whose_row(s, "Who feels it", rows);
    add_profile_rows(s, context, rows);
    const auto settings = player_settings();
    for (std::size_t i = 0; i < settings.size(); ++i)
        if (settings[i].page == SettingPage::mixer) {
            auto row = row_of(RowKind::player_setting, i, settings[i], s.settings.players[s.player]);
            const bool own = is_about(settings[i], &PlayerSettings::own_force_percent);
            row.look.dim = own && s.settings.players[s.player].force != own_force;
            rows.push_back(std::move(row));
            if (own) rows.push_back(find_force_row(s, context));
        }
    rows.push_back(
        {RowKind::cauldron,
         0,
         {.label = "Cauldron feedback", .help = "Changes what the player's hand feels of the brew."}});
    add_body_rows(s, context, rows);
    add_defaults_row(rows);
    add_back_row(rows);
}

void add_cauldron_rows(const MenuState& s, Rows& rows) {
    add_whose_row(s, "Whose hand", rows);
    const auto& faders = s.settings.cauldron[s.player];
    for (std::size_t i = 0; i < faders.size(); ++i) {
        rows.push_back({RowKind::fader,
                        i,
                        {.label = std::string(label_of_fader(i)),
                         .help = std::string(effect_of_fader(i)),
                         .value = shown(faders[i]),
                         .adjustable = true,
                         .dim = !faders[i].on}});
    }
    add_defaults_row(rows);
    add_back_row(rows);
}

}  // namespace

std::vector<Row> rows_of(const MenuState& s, const MenuContext& context) {
    Rows rows;
    switch (s.pages.back().page) {
        case Page::start: add_start_rows(s, context, rows); break;
        case Page::pause: add_pause_rows(s, context, rows); break;
        case Page::sheets: add_sheet_rows(context, rows); break;
        case Page::pad_setup: add_setup_rows(context, rows); break;
        case Page::bindings: add_binding_rows(s, context, rows); break;
        case Page::settings: add_setting_rows(s, rows); break;
        case Page::sound: add_sound_rows(s, rows); break;
        case Page::player: add_player_rows(s, rows); break;
        case Page::mixer: add_mixer_rows(s, context, rows); break;
        case Page::cauldron: add_cauldron_rows(s, rows); break;
    }
    return rows;
}

std::string label_of_restart(const MenuContext& context) {
    return text("Restart the ", name_of_play(context));
}

namespace {

/// A row's meaning, whatever number its joystick has at present.
struct Meaning {
    RowKind kind{};
    std::size_t index = 0;
    std::string stick{};
    bool operator==(const Meaning&) const = default;
};

Meaning meaning_of(const Row& row, const MenuContext& context) {
    if (row.kind == RowKind::set_up_pad || row.kind == RowKind::forget_pad)
        return {row.kind, 0, name_of_stick(context, row.index)};
    return {row.kind, row.index, {}};
}

}  // namespace

MenuState on_same_rows(MenuState state, const MenuContext& before, const MenuContext& context) {
    const auto pages = state.pages;
    for (state.pages.clear(); state.pages.size() < pages.size();) {
        const auto& page = pages[state.pages.size()];
        state.pages.push_back(page);
        const auto rows = rows_of(state, before);
        if (page.cursor >= rows.size()) continue;
        const auto now = rows_of(state, context);
        const auto same = std::find_if(now.begin(), now.end(), [&](const Row& row) {
            return meaning_of(row, context) == meaning_of(rows[page.cursor], before);
        });
        if (same == now.end()) continue;
        const auto place = static_cast<std::size_t>(same - now.begin());
        auto& open = state.pages.back();
        open.middle = open.middle + place > page.cursor ? open.middle + place - page.cursor : 0;
        open.cursor = place;
    }
    return state;
}

}  // namespace thaum::app
