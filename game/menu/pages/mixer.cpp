// Menu page: what one player feels, as faders for forces, motors and jacket, with presets and profiles.
#include <algorithm>

#include "core/text.h"
#include "game/menu/page.h"

namespace thaum::game::inline menu {
namespace {

// Presets and profiles --------------------------------------------------------------------------------------

/// Index of the preset (a fixed set of strengths) that feels like the player's values; the number of presets
/// if none does.
std::size_t preset_of(const MenuState& s) {
    const auto own = feel_of(s.settings, s.player);
    const auto& presets = feel_presets();
    const auto same = std::find_if(presets.begin(), presets.end(),
                                   [&](const auto& preset) { return feels_alike(preset, own); });
    return static_cast<std::size_t>(same - presets.begin());
}

/// Chooses the preset (a fixed set of strengths) after or before the present one. Values of no preset count
/// as between the last and the first one.
void turn_preset(const RowPress& press, int way) {
    auto& s = press.state;
    const auto& presets = feel_presets();
    auto index = preset_of(s);
    if (index == presets.size())
        index = way > 0 ? 0 : presets.size() - 1;
    else
        turn(index, presets, way);
    use(presets[index], s.settings, s.player);
}

void turn_profile(const RowPress& press, int way) {
    if (!press.context.profiles.empty()) turn(press.state.profile, press.context.profiles, way);
}

void load_profile(const RowPress& press) {
    auto& s = press.state;
    const auto& profiles = press.context.profiles;
    if (s.profile >= profiles.size()) {
        s.note = "no profile was saved yet";
        return;
    }
    use(profiles[s.profile], s.settings, s.player);
    s.note = text("loaded ", profiles[s.profile].name);
}

void type_name_of_profile(const RowPress& press) {
    type(press.state, Typing::profile, player_words(press.state.settings, press.state.player));
}

void add_profile_rows(const MenuState& s, const MenuContext& context, Rows& rows) {
    const auto& profiles = context.profiles;
    const auto& presets = feel_presets();
    const auto preset = preset_of(s);
    rows.push_back(
        {.look = {.label = "Preset",
                  .help = "Sets forces, motors and body: gentle, all that devices can do, or nothing.",
                  .value = preset < presets.size() ? presets[preset].name : std::string("own"),
                  .longest_value = "gentle",
                  .adjustable = true},
         .turn = turn_preset});
    rows.push_back(
        {.look = {.label = "Load a profile",
                  .help = "Sets all values of this page as they were saved under this name.",
                  .value = s.profile < profiles.size() ? profiles[s.profile].name : std::string("none saved"),
                  .adjustable = profiles.size() > 1,
                  .dim = profiles.empty()},
         .confirm = load_profile,
         .turn = turn_profile});
    const bool types = s.typing && s.typed == Typing::profile;
    rows.push_back({.look = {.label = "Save as a profile",
                             .help = "Keeps all values of this page under a name.",
                             .value = types ? text(*s.typing, "_") : std::string()},
                    .confirm = type_name_of_profile});
}

// Forces ----------------------------------------------------------------------------------------------------

/// Whether a setting sets the member `value` of a player's settings.
template <class T>
bool is_about(const PlayerSetting& setting, T PlayerSettings::*value) {
    using Kind =
        std::conditional_t<std::is_same_v<T, int>, WholeOf<PlayerSettings>, NumberOf<PlayerSettings>>;
    const auto* kind = std::get_if<Kind>(&setting.kind);
    return kind != nullptr && kind->value == value;
}

/// The strength of a force at the hand (fader) that a setting sets, if that force can be felt on the practice
/// range; none for other settings.
input::HandFader felt_fader_of(const PlayerSetting& setting) {
    if (is_about(setting, &PlayerSettings::carried_weight)) return input::HandFader::weight;
    if (is_about(setting, &PlayerSettings::carried_blows)) return input::HandFader::blows;
    return is_about(setting, &PlayerSettings::recoil) ? input::HandFader::recoil : input::HandFader::none;
}

/// Whether the player of the page can feel forces at once. Only the player who practises on the range can.
bool can_feel_forces(const MenuState& s, const MenuContext& context) {
    return context.practice && !context.apprentice && s.player == practising;
}

void feel_force(const RowPress& press) {
    if (can_feel_forces(press.state, press.context))
        ask_match(press.state, FeelForce{felt_fader_of(player_settings()[press.row.index])});
    else
        press.state.note = "in the pause of the range a press lets you feel it";
}

void find_force(const RowPress& press) {
    if (can_feel_forces(press.state, press.context))
        ask_match(press.state, FindForce{});
    else
        press.state.note = "open this page in the pause of the range";
}

/// The row that finds the player's own largest force by feel, below the row that sets it.
Row find_force_row(const MenuState& s, const MenuContext& context) {
    return {.look = {.label = "Find it by feel",
                     .help = "Kicks the hand more and more until you press fire. Only on the range.",
                     .dim = !can_feel_forces(s, context)},
            .confirm = find_force};
}

void add_force_rows(const MenuState& s, const MenuContext& context, Rows& rows) {
    Rows settings;
    add_player_settings(s, SettingPage::mixer, settings);
    for (auto& row : settings) {
        const auto& setting = player_settings()[row.index];
        const bool own = is_about(setting, &PlayerSettings::own_force_percent);
        row.look.dim = own && s.settings.players[s.player].force != own_force;
        row.felt = felt_fader_of(setting) != input::HandFader::none;
        if (row.felt) row.confirm = feel_force;
        rows.push_back(std::move(row));
        if (own) rows.push_back(find_force_row(s, context));
    }
}

// The body --------------------------------------------------------------------------------------------------

/// A text cut to the width of a row.
std::string shortened(const std::string& words) {
    constexpr std::size_t most = 24;
    return words.size() <= most ? words : words.substr(0, most - 3) + "...";
}

/// State of the player's jacket, or where a jacket can be chosen.
std::string jacket_help(const MenuContext& context, std::size_t player) {
    const auto& state = context.jackets.at(player);
    return state.empty() ? std::string("Is changed in the settings file only; its comment says how.") : state;
}

void turn_body_fader(const RowPress& press, int way) {
    constexpr int steps = 10;
    auto& s = press.state;
    auto& value = s.settings.players[s.player].body.values.at(press.row.index);
    value = moved_share(value, way, steps);
}

void try_body(const RowPress& press) {
    auto& s = press.state;
    const auto purpose = static_cast<tactile::Purpose>(press.row.index);
    s.tries = {s.player, purpose};
    if (s.settings.players[s.player].body.of(purpose) == 0) s.note = "at 0 % nothing is felt";
}

void add_body_rows(const MenuState& s, const MenuContext& context, Rows& rows) {
    const auto& player = s.settings.players[s.player];
    for (const auto purpose : context.body)
        rows.push_back({.look = {.label = text("Body: ", label_of(purpose)),
                                 .help = std::string(effect_of(purpose)),
                                 .value = percent_words(player.body.of(purpose)),
                                 .longest_value = "100 %",
                                 .adjustable = true},
                        .confirm = try_body,
                        .turn = turn_body_fader,
                        .index = static_cast<std::size_t>(purpose),
                        .felt = true});
    rows.push_back({.look = {.label = "Jacket",
                             .help = jacket_help(context, s.player),
                             .value = player.jacket.empty() ? std::string("none") : shortened(player.jacket),
                             .dim = true}});
}

// The page --------------------------------------------------------------------------------------------------

void add_mixer_rows(const MenuState& s, const MenuContext& context, Rows& rows) {
    rows.push_back(whose_row(s, "Who feels it"));
    add_profile_rows(s, context, rows);
    add_force_rows(s, context, rows);
    rows.push_back(
        link_to("cauldron", "Cauldron feedback", "Changes what the player's hand feels of the brew."));
    add_body_rows(s, context, rows);
}

std::string reset_mixer(MenuState& s) {
    use(feel_presets().front(), s.settings, s.player);
    return text(player_words(s.settings, s.player), ": forces and body");
}

std::string mixer_line(const MenuState& s, const MenuContext&, const Row&) {
    return text("what ", player_words(s.settings, s.player), " feels");
}

std::string mixer_hint(const MenuState&, const MenuContext&, const Row& row) {
    return row.felt
               ? "less, more: arrows    feel it: Enter, A, click on its name    back: Esc, B, right button"
               : "less, more: arrows    confirm: Enter, A, click    back: Esc, B, right button";
}

const PageRegistration mixer_page{{
    .name = page_name::mixer,
    .title = [](const MenuState&, const MenuContext&) { return std::string("Forces and body"); },
    .add_rows = add_mixer_rows,
    .reset = reset_mixer,
    .line = mixer_line,
    .hint = mixer_hint,
}};

}  // namespace
}  // namespace thaum::game::inline menu
