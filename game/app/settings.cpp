#include "game/app/settings.h"

#include <pwd.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <tuple>

#include "core/config.h"
#include "core/file.h"
#include "core/text.h"
#include "game/app/jacket.h"
#include "game/app/player_name.h"
#include "game/hud/figures.h"
#include "input/log.h"
#include "render/context.h"

namespace thaum::app {
namespace {

std::vector<std::string_view> force_names() {
    std::vector<std::string_view> names;
    for (const auto& choice : force_choices) names.push_back(choice.name);
    return names;
}

constexpr std::size_t max_settings_file = 1U << 20U;
constexpr std::string_view log_ending = ".thaumlog";
constexpr std::array<std::string_view, session_keys> session_names{"pause",      "again", "leave", "split",
                                                                   "fullscreen", "mark",  "forces"};
constexpr std::array<std::string_view, session_keys> session_defaults{
    "key escape", "key enter, key kp_enter", "key q", "key f6", "key f11", "key f10", "key f3"};

/// The user's home folder; empty if there is none. A relative HOME is ignored, because its meaning would
/// change with the working folder.
std::filesystem::path home_folder() {
    const char* home = std::getenv("HOME");
    if (home != nullptr && std::filesystem::path(home).is_absolute()) return home;
    const auto* user = ::getpwuid(::getuid());
    if (user == nullptr || user->pw_dir == nullptr) return {};
    std::filesystem::path listed = user->pw_dir;
    return listed.is_absolute() ? listed : std::filesystem::path();
}

/// An XDG folder: the absolute path in the variable, else the usual place below the home folder. The
/// specification says that relative paths are ignored. Empty if there is no home folder.
std::filesystem::path base_folder(const char* variable, const char* usual) {
    const char* set = std::getenv(variable);
    if (set != nullptr && std::filesystem::path(set).is_absolute()) return set;
    const auto home = home_folder();
    return home.empty() ? home : home / usual;
}

std::filesystem::path below(const std::filesystem::path& base, const char* way) {
    return base.empty() ? base : base / way;
}

void read_session(const ConfigTable& table, Settings& settings) {
    for (std::size_t i = 0; i < session_keys; ++i) {
        const auto key = session_names[i];
        if (!table.has(key)) continue;
        auto controls = input::parse_controls(table.string(key, input::no_control), key_code_of);
        const bool only_keys = controls && std::all_of(controls->begin(), controls->end(), [](const auto& c) {
                                   return c.source == input::Control::Source::key;
                               });
        if (only_keys)
            settings.session[i] = std::move(*controls);
        else
            table.report(
                key, text("'", key, "': ", controls ? "only keys can do this" : controls.error().message));
    }
}

void read_bindings(const ConfigTable& root, Settings& settings) {
    for (const auto kind : settings_hands) {
        auto& bindings = settings.bindings_of(kind);
        const auto name = input::name_of(kind);
        if (root.has(name))
            bindings = input::read_bindings(root.table(name), std::move(bindings), key_code_of);
    }
    if (root.has("session")) read_session(root.table("session"), settings);
}

template <class Of>
void read(const ConfigTable& table, const SettingOf<Of>& setting, Of& values) {
    if (const auto* n = std::get_if<NumberOf<Of>>(&setting.kind))
        values.*n->value = table.number(setting.key, {n->low, n->high}, values.*n->value);
    if (const auto* w = std::get_if<WholeOf<Of>>(&setting.kind)) {
        const Range range{static_cast<double>(w->low), static_cast<double>(w->high)};
        values.*w->value = static_cast<int>(table.integer(setting.key, range, values.*w->value));
    }
    if (const auto* f = std::get_if<FlagOf<Of>>(&setting.kind))
        values.*f->value = table.boolean(setting.key, values.*f->value);
    if (const auto* c = std::get_if<ChoiceOf<Of>>(&setting.kind))
        c->set(values, table.choice(setting.key, c->names, c->get(values)));
}

void read_name(const ConfigTable& table, PlayerSettings& player) {
    auto name = player_name(table.string("name", player.name));
    if (name)
        player.name = std::move(*name);
    else
        table.report("name", text("'name': ", name.error().message));
}

void read_jacket(const ConfigTable& table, PlayerSettings& player) {
    auto words = table.string("jacket", player.jacket);
    if (const auto jacket = parse_jacket(words); !jacket)
        table.report("jacket", text("'jacket': ", jacket.error().message));
    else
        player.jacket = std::move(words);
}

/// Takes a jacket that both players have from the second one.
void divide_jackets(const ConfigTable& root, Settings& s) {
    const auto first = parse_jacket(s.players[0].jacket), second = parse_jacket(s.players[1].jacket);
    if (!first || !second || first->link == Jacket::Link::none) return;
    if (first->link != second->link || first->address != second->address) return;
    root.table(player_tables[1]).report("jacket", "'jacket': it is player 1's; give each player another");
    s.players[1].jacket.clear();
}

/// Reads the largest force of each player from its place in files of earlier versions.
void read_former_forces(const ConfigTable& root, Settings& s) {
    const auto names = force_names();
    for (const auto& [key, player] : {std::pair("force_1", &s.players[0]), {"force_2", &s.players[1]}})
        player->force = root.choice(key, names, player->force);
}

/// Reads the dead zone of both players' sticks from its place in files of earlier versions, which had one with each
/// device's controls. Only a pad has sticks.
void read_former_dead_zone(const ConfigTable& root, Settings& s) {
    for (const auto kind : settings_hands) {
        const auto name = input::name_of(kind);
        if (!root.has(name)) continue;
        const auto read = root.table(name).number("stick_dead_zone", {0, 0.9}, s.players[0].stick_dead_zone);
        if (kind != input::DeviceKind::pad) continue;
        for (auto& player : s.players) player.stick_dead_zone = read;
    }
}

/// Reads the players' own settings. In files of earlier versions they are at the top and count for both players.
void read_players(const ConfigTable& root, Settings& s) {
    read_former_forces(root, s);
    read_former_dead_zone(root, s);
    for (std::size_t p = 0; p < s.players.size(); ++p) {
        auto& player = s.players[p];
        const bool own = root.has(player_tables[p]);
        for (const auto& setting : player_settings()) {
            if (root.has(setting.key)) read(root, setting, player);
            if (own) read(root.table(player_tables[p]), setting, player);
        }
        if (own) read_name(root.table(player_tables[p]), player);
        if (own) read_jacket(root.table(player_tables[p]), player);
    }
    divide_jackets(root, s);
}

void read_last_choice(const ConfigTable& root, LastChoice& last) {
    last.bot_level = static_cast<int>(root.integer("bot_level", {0, 7}, last.bot_level));
    last.match = root.string("match", last.match);
    last.arena = root.string("arena", last.arena);
}

std::string two_digits(int n) { return text(n < 10 ? "0" : "", n); }

/// Date and time in a form that sorts by time: "2026-03-01_18-05-59".
std::string date_and_time(std::time_t when) {
    std::tm t{};
    ::localtime_r(&when, &t);
    return text(t.tm_year + 1900, "-", two_digits(t.tm_mon + 1), "-", two_digits(t.tm_mday), "_",
                two_digits(t.tm_hour), "-", two_digits(t.tm_min), "-", two_digits(t.tm_sec));
}

bool is_number(std::string_view word) {
    return !word.empty() &&
           std::all_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// Length of the pattern if `name` begins with it, else 0. In the pattern, d stands for a digit.
std::size_t fitted(std::string_view name, std::string_view pattern) {
    const bool fits = name.size() >= pattern.size() &&
                      std::equal(pattern.begin(), pattern.end(), name.begin(),
                                 [](char p, char c) { return p == 'd' ? c >= '0' && c <= '9' : c == p; });
    return fits ? pattern.size() : 0;
}

/// A recorded match with a name of this program. Names contain a counter, because clocks may run backwards.
struct MatchLog {
    std::uint64_t number{};  ///< 0: the name is from an earlier version and has only the date
    std::string name;        ///< file name without ".thaumlog"
    std::filesystem::path path;

    /// Sort key, oldest first. Of two names with the same beginning the shorter comes first: "-2" before
    /// "-10".
    auto key() const {
        return std::tuple(number, std::string_view(name).substr(0, dated), name.size(), name);
    }

private:
    static constexpr std::size_t dated = std::string_view("dddd-dd-dd_dd-dd-dd_dd").size();
};

/// Counter in the name of a log; std::nullopt if this program did not give the name. Names look like
/// "000012_2026-03-01_18-05-59.thaumlog", in earlier versions like "2026-03-01_18-05-59_01.thaumlog". A
/// suffix "-2" follows if the name was taken. Only files with such names are ever deleted.
std::optional<std::uint64_t> number_of_own(std::string_view name) {
    const auto digits = std::min(name.find('_'), name.size());
    const bool numbered = digits >= 6 && digits <= 18 && is_number(name.substr(0, digits));
    const auto matched = numbered ? fitted(name.substr(digits), "_dddd-dd-dd_dd-dd-dd") + digits
                                  : fitted(name, "dddd-dd-dd_dd-dd-dd_dd");
    if (matched <= (numbered ? digits : 0)) return std::nullopt;
    const auto rest = name.substr(matched);
    if (!rest.empty() && (rest[0] != '-' || !is_number(rest.substr(1)))) return std::nullopt;
    return numbered ? std::stoull(std::string(name.substr(0, digits))) : 0;
}

/// Logs in the folder with names of this program, oldest first.
std::vector<MatchLog> match_logs(const std::filesystem::path& folder) {
    std::vector<MatchLog> logs;
    std::error_code error;
    for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end;
         it.increment(error)) {
        const auto& path = it->path();
        if (path.extension() != log_ending || !it->is_regular_file(error)) continue;
        const auto name = path.stem().string();
        if (const auto number = number_of_own(name)) logs.push_back({*number, name, path});
    }
    std::sort(logs.begin(), logs.end(), [](const auto& a, const auto& b) { return a.key() < b.key(); });
    return logs;
}

/// Deletes the oldest logs until there is room for one more. Keeps logs that a program is recording.
void delete_oldest(const std::vector<MatchLog>& logs, int kept) {
    const auto room = static_cast<std::size_t>(std::max(kept - 1, 0));
    std::error_code error;
    for (std::size_t i = 0; i + room < logs.size(); ++i) {
        if (!input::log_in_use(logs[i].path)) std::filesystem::remove(logs[i].path, error);
    }
}

}  // namespace

Settings::Settings() {
    for (std::size_t kind = 0; kind < input::device_kinds; ++kind)
        bindings[kind] = input::default_bindings(static_cast<input::DeviceKind>(kind), key_code_of);
    for (std::size_t i = 0; i < session_keys; ++i)
        session[i] =
            input::parse_controls(session_defaults[i], key_code_of).value_or(std::vector<input::Control>{});
}

std::optional<std::uint32_t> force_percent_of(const PlayerSettings& player) {
    if (player.force == own_force) return static_cast<std::uint32_t>(player.own_force_percent);
    return force_choices[player.force].percent;
}

std::string_view name_of(SessionKey key) { return session_names[static_cast<std::size_t>(key)]; }

namespace {

ChoiceOf<Settings> quality_setting() {
    std::vector<std::string_view> names{"auto"};
    names.insert(names.end(), render::quality_names.begin(), render::quality_names.end());
    return {std::move(names),
            [](const Settings& s) { return s.quality ? static_cast<std::size_t>(*s.quality) + 1 : 0; },
            [](Settings& s, std::size_t i) {
                s.quality.reset();
                if (i > 0) s.quality = static_cast<render::Quality>(i - 1);
            }};
}

ChoiceOf<PlayerSettings> heard_setting() {
    return {{"off", "important", "all"},
            [](const PlayerSettings& p) { return static_cast<std::size_t>(p.heard); },
            [](PlayerSettings& p, std::size_t i) { p.heard = static_cast<game::HeardWish>(i); }};
}

ChoiceOf<PlayerSettings> prompts_setting() {
    return {{game::prompt_wishes.begin(), game::prompt_wishes.end()},
            [](const PlayerSettings& p) { return static_cast<std::size_t>(p.prompts); },
            [](PlayerSettings& p, std::size_t i) { p.prompts = static_cast<game::PromptWish>(i); }};
}

ChoiceOf<PlayerSettings> force_setting() {
    return {force_names(), [](const PlayerSettings& p) { return p.force; },
            [](PlayerSettings& p, std::size_t i) { p.force = i; }};
}

std::vector<Setting> general_settings() {
    using Number = NumberOf<Settings>;
    using Flag = FlagOf<Settings>;
    return {
        {"split", "Split", "Puts the two views one above the other, or side by side.",
         ChoiceOf<Settings>{
             {"top_bottom", "side_by_side"},
             [](const Settings& s) { return s.split == render::Split::top_bottom ? 0UL : 1UL; },
             [](Settings& s, std::size_t i) {
                 s.split = i == 0 ? render::Split::top_bottom : render::Split::side_by_side;
             }}},
        {"fullscreen", "Full screen", "Fills the whole screen, or plays in a window.",
         Flag{&Settings::fullscreen}},
        {"fov_deg", "Field of view", "Shows more to the sides, and all of it smaller.",
         Number{&Settings::fov, 60, 130, 5, 1, "\u00B0"}},
        {"text_scale", "Text size", "Makes words and signs larger.",
         Number{&Settings::text_scale, 1, 2.5, 0.25, 100, " %"}},
        {"quality", "Picture quality", "Draws finer pictures; auto takes what this computer draws in time.",
         quality_setting()},
        {"bloom", "Bloom at high quality", "Lets bright light shine beyond its edges.",
         Flag{&Settings::bloom}},
        {"frames_per_second", "Frame rate limit", "Draws at most this many pictures a second.",
         Number{&Settings::frames_per_second, 10, 360, 5, 1, ""}},
        {"countdown_s", "Countdown", "Counts down these seconds before a match begins.",
         WholeOf<Settings>{&Settings::countdown_s, 0, 10, 1, " s"}, true},
        {"logs_kept", "Recordings to keep", "Keeps this many recorded matches, and deletes older ones.",
         WholeOf<Settings>{&Settings::logs_kept, 1, 100000, 10, ""}},
    };
}

std::vector<Setting> sound_settings() {
    using Number = NumberOf<Settings>;
    using Flag = FlagOf<Settings>;
    return {
        {"sound_master", "All sounds", "Makes everything louder or softer.",
         Number{&Settings::sound_master, 0, 1, 0.1, 100, " %"}, false, true},
        {"sound_effects", "Effects", "Makes the sounds of the match louder or softer.",
         Number{&Settings::sound_effects, 0, 1, 0.1, 100, " %"}, false, true},
        {"sound_music", "Music", "Makes the music louder or softer.",
         Number{&Settings::sound_music, 0, 1, 0.1, 100, " %"}, false, true},
        {"sound_interface", "Menus and signals",
         "Makes the sounds of menus and of the clock louder or softer.",
         Number{&Settings::sound_interface, 0, 1, 0.1, 100, " %"}, false, true},
        {"headphones", "Headphones", "Lets one player hear above, below and behind; for headphones only.",
         Flag{&Settings::headphones}, false, true},
        {"ears_apart", "Players apart", "Gives player 1 the left loudspeaker and player 2 the right one.",
         Flag{&Settings::ears_apart}, false, true},
    };
}

}  // namespace

std::span<const Setting> all_settings() {
    static const std::vector<Setting> settings = [] {
        auto all = general_settings();
        const auto sounds = sound_settings();
        all.insert(all.end(), sounds.begin(), sounds.end());
        return all;
    }();
    return settings;
}

namespace {

std::vector<PlayerSetting> seen_and_aimed_settings() {
    using Number = NumberOf<PlayerSettings>;
    using Flag = FlagOf<PlayerSettings>;
    return {
        {"captions", "Captions", "Tells in words what the hand feels, the brew does and gifts give.",
         Flag{&PlayerSettings::captions}},
        {"heard", "Sounds in words", "Tells in words what is heard and from where.", heard_setting()},
        {"figure", "Figure of the body", "Shows where a hit, a fall or the heart is felt.",
         Flag{&PlayerSettings::figure}},
        {"prompts", "Control prompts", "Names the control for what can be done at this place.",
         prompts_setting()},
        {"sensitivity", "Mouse speed", "Turns the view further for the same way of the mouse.",
         Number{&PlayerSettings::sensitivity, 0.05, 20, 0.05, 1, ""}},
        {"invert_y", "Invert look (vertical)", "Looks down when mouse or stick are pushed away.",
         Flag{&PlayerSettings::invert_y}},
        {"turn_deg_per_s", "Stick and arrow speed", "Turns the view faster with a stick or the arrow keys.",
         Number{&PlayerSettings::turn_deg_per_s, 20, 1000, 10, 1, "\u00B0/s"}, true},
        {"turn_ramp_s", "Slow start of turns",
         "Begins a turn by stick or arrows slowly, so that a short press turns a little.",
         Number{&PlayerSettings::turn_ramp_s, 0, 0.5, 0.05, 1, " s"}},
        {"stick_dead_zone", "Stick dead zone", "Ignores small pushes of a pad's sticks.",
         Number{&PlayerSettings::stick_dead_zone, 0, 0.9, 0.05, 100, " %"}},
        {"stick_curve", "Stick curve", "Turns finer near the stick's middle, or evenly at 0 %.",
         Number{&PlayerSettings::stick_curve, 0, 1, 0.1, 100, " %"}},
        {"aim_assist_pad", "Aim assist: pad", "Slows turns at the foe, and turns near misses into hits.",
         Number{&PlayerSettings::aim_assist_pad, 0, 1, 0.1, 100, " %"}, true},
        {"aim_assist_keys", "Aim assist: keypad",
         "Slows turns by keypad and arrows at the foe, and turns near misses into hits.",
         Number{&PlayerSettings::aim_assist_keys, 0, 1, 0.1, 100, " %"}, true},
        {"aim_assist_mouse", "Aim assist: mouse",
         "Slows turns by mouse at the foe, and turns near misses into hits.",
         Number{&PlayerSettings::aim_assist_mouse, 0, 1, 0.1, 100, " %"}, true},
    };
}

std::vector<PlayerSetting> felt_settings() {
    using Number = NumberOf<PlayerSettings>;
    return {
        {"rumble", "Rumble", "Makes a pad's motors stronger or weaker; the match stays the same.",
         Number{&PlayerSettings::rumble, 0, 1, 0.1, 100, " %"}},
        {"force", "Force on the hand", "Sets the largest force that the hand feels.", force_setting()},
        {"own_force_percent", "Own largest force",
         "Sets what \"own\" means, of the most that the device can do.",
         WholeOf<PlayerSettings>{&PlayerSettings::own_force_percent, 5, 100, 5, " %"}},
        {"carried_weight", "Carried weight",
         "Lets the hand feel less of the weight; the match stays the same.",
         Number{&PlayerSettings::carried_weight, 0, 1, 0.25, 100, " %"}},
        {"carried_blows", "Carried blows", "Lets the hand feel less of the blows; the match stays the same.",
         Number{&PlayerSettings::carried_blows, 0, 1, 0.25, 100, " %"}},
        {"recoil", "Recoil of the wands",
         "Lets the hand feel less of the kick of each shot; the match stays the same.",
         Number{&PlayerSettings::recoil, 0, 1, 0.25, 100, " %"}},
        {"roughness", "Roughness of touched things",
         "Lets the wand's tip slide more easily over what it touches.",
         Number{&PlayerSettings::roughness, 0, 1, 0.25, 100, " %"}},
    };
}

}  // namespace

std::span<const PlayerSetting> player_settings() {
    static const std::vector<PlayerSetting> settings = [] {
        auto all = seen_and_aimed_settings();
        const auto felt = felt_settings();
        all.insert(all.end(), felt.begin(), felt.end());
        return all;
    }();
    return settings;
}

template <class Of>
std::string written(const SettingOf<Of>& setting, const Of& values) {
    if (const auto* n = std::get_if<NumberOf<Of>>(&setting.kind)) return text(values.*n->value);
    if (const auto* w = std::get_if<WholeOf<Of>>(&setting.kind)) return text(values.*w->value);
    if (const auto* f = std::get_if<FlagOf<Of>>(&setting.kind)) return text(values.*f->value);
    const auto& c = std::get<ChoiceOf<Of>>(setting.kind);
    return text('"', c.names[c.get(values)], '"');
}

template <class Of>
std::string shown(const SettingOf<Of>& setting, const Of& values) {
    if (const auto* n = std::get_if<NumberOf<Of>>(&setting.kind)) {
        const double value = std::round(values.*n->value * n->shown_times * 100) / 100;
        return text(value, n->unit);
    }
    if (const auto* w = std::get_if<WholeOf<Of>>(&setting.kind)) return text(values.*w->value, w->unit);
    if (const auto* f = std::get_if<FlagOf<Of>>(&setting.kind)) return values.*f->value ? "yes" : "no";
    if (const auto* c = std::get_if<ChoiceOf<Of>>(&setting.kind)) {
        std::string name(c->names[c->get(values)]);
        std::replace(name.begin(), name.end(), '_', ' ');
        return name;
    }
    return written(setting, values);
}

template <class Of>
void change(const SettingOf<Of>& setting, Of& values, int steps) {
    if (const auto* n = std::get_if<NumberOf<Of>>(&setting.kind)) {
        // Rounds to a whole number of steps. Dividing instead of multiplying gives 0.3 and not
        // 0.30000000000000004.
        const double per_unit = std::round(1 / n->step);
        const double whole = std::round(values.*n->value / n->step) + steps;
        const double value = n->step < 1 ? whole / per_unit : whole * n->step;
        values.*n->value = std::clamp(value, n->low, n->high);
    }
    if (const auto* w = std::get_if<WholeOf<Of>>(&setting.kind))
        values.*w->value = std::clamp(values.*w->value + steps * w->step, w->low, w->high);
    if (const auto* f = std::get_if<FlagOf<Of>>(&setting.kind))
        values.*f->value = (steps % 2 != 0) != values.*f->value;
    if (const auto* c = std::get_if<ChoiceOf<Of>>(&setting.kind)) {
        const auto count = static_cast<int>(c->names.size());
        const int at = static_cast<int>(c->get(values)) + steps % count + count;
        c->set(values, static_cast<std::size_t>(at % count));
    }
}

template <class Of>
void reset(const SettingOf<Of>& setting, Of& values) {
    const Of fresh;
    if (const auto* n = std::get_if<NumberOf<Of>>(&setting.kind)) values.*n->value = fresh.*n->value;
    if (const auto* w = std::get_if<WholeOf<Of>>(&setting.kind)) values.*w->value = fresh.*w->value;
    if (const auto* f = std::get_if<FlagOf<Of>>(&setting.kind)) values.*f->value = fresh.*f->value;
    if (const auto* c = std::get_if<ChoiceOf<Of>>(&setting.kind)) c->set(values, c->get(fresh));
}

template std::string written(const Setting&, const Settings&);
template std::string written(const PlayerSetting&, const PlayerSettings&);
template std::string shown(const Setting&, const Settings&);
template std::string shown(const PlayerSetting&, const PlayerSettings&);
template void change(const Setting&, Settings&, int);
template void change(const PlayerSetting&, PlayerSettings&, int);
template void reset(const Setting&, Settings&);
template void reset(const PlayerSetting&, PlayerSettings&);

std::string player_words(const Settings& settings, std::size_t player) {
    const auto& name = settings.players[player].name;
    return name.empty() ? std::string(game::team_name(static_cast<std::uint32_t>(player))) : name;
}

std::optional<int> key_code_of(std::string_view name) {
    if (name == "escape") return render::key_code("esc");
    if (const auto code = render::key_code(name)) return code;
    // The window layer's names differ: "LeftAlt" for "left_alt", and "LeftCtrl" for "left_control".
    std::string plain(name);
    std::erase(plain, '_');
    if (plain.ends_with("control")) plain.replace(plain.size() - 7, 7, "ctrl");
    return render::key_code(plain);
}

std::string key_name_of(int code) {
    const auto name = render::key_name(code);
    if (name == "Esc") return "escape";
    std::string words;
    for (const char c : name) {
        const bool upper = c >= 'A' && c <= 'Z';
        const bool after_lower = !words.empty() && words.back() >= 'a' && words.back() <= 'z';
        if (upper && after_lower && !name.starts_with("KP_")) words += '_';
        words += upper ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return words;
}

Expected<ReadSettings> read_settings(std::string_view toml, std::string name) {
    const auto file = Config::parse(toml, std::move(name), 1);
    if (!file) return tl::unexpected(file.error());
    const auto root = file->root();
    Settings s;
    for (const auto& setting : all_settings()) read(root, setting, s);
    read_last_choice(root, s.last);
    read_players(root, s);
    for (std::size_t p = 0; p < s.cauldron.size(); ++p) {
        if (root.has(cauldron_tables[p]))
            s.cauldron[p] = read_faders(root.table(cauldron_tables[p]), s.cauldron[p]);
    }
    read_bindings(root, s);
    const auto checked = file->check();
    return ReadSettings{std::move(s), checked ? std::nullopt : std::optional(checked.error())};
}

namespace {

Expected<Settings> without_fault(Expected<ReadSettings> read) {
    if (!read) return tl::unexpected(read.error());
    if (read->fault) return tl::unexpected(*read->fault);
    return std::move(read->settings);
}

Expected<ReadSettings> read_settings_file(const std::filesystem::path& file,
                                          const std::filesystem::path& assets) {
    if (file.empty()) return ReadSettings{};
    std::error_code error;
    // symlink_status: a dangling link counts as an existing file.
    if (!std::filesystem::exists(std::filesystem::symlink_status(file, error))) {
        const auto defaults = read_text_file(assets / "settings.toml", max_settings_file);
        if (!defaults) return tl::unexpected(defaults.error());
        std::filesystem::create_directories(file.parent_path(), error);
        // Players can play even if the home folder is not writable.
        if (!write_text_file(file, *defaults)) return ReadSettings{};
    }
    const auto source = read_text_file(file, max_settings_file);
    if (!source) return tl::unexpected(source.error());
    return read_settings(*source, file.string());
}

/// Words for the start screen, which has no room for the path: "settings.toml, line 5: 'fov_deg' is 5, ...".
std::string short_fault(const Error& fault, const std::filesystem::path& file) {
    const auto folder = file.parent_path().string() + '/';
    auto words = fault.message.starts_with(folder) ? fault.message.substr(folder.size()) : fault.message;
    const auto place = file.filename().string() + ':';
    const bool has_line =
        words.starts_with(place) && is_number(std::string_view(words).substr(place.size(), 1));
    if (has_line) words.replace(place.size() - 1, 1, ", line ");
    return words;
}

}  // namespace

Expected<Settings> parse_settings(std::string_view toml, std::string name) {
    return without_fault(read_settings(toml, std::move(name)));
}

Expected<Settings> load_settings(const std::filesystem::path& file, const std::filesystem::path& assets) {
    return without_fault(read_settings_file(file, assets));
}

PlaySettings settings_to_play_with(const std::filesystem::path& file, const std::filesystem::path& assets) {
    auto read = read_settings_file(file, assets);
    const auto* fault = !read ? &read.error() : read->fault ? &*read->fault : nullptr;
    if (fault == nullptr) return {std::move(read->settings)};
    const std::string hold = read ? "defaults replace wrong values" : "the defaults hold";
    std::fprintf(stderr, "%s; it is kept as it is, and %s\n", fault->message.c_str(), hold.c_str());
    auto words = text(short_fault(*fault, file), "; ", hold);
    return {read ? std::move(read->settings) : Settings{}, std::move(words)};
}

std::filesystem::path settings_file() {
    return below(base_folder("XDG_CONFIG_HOME", ".config"), "thaum/settings.toml");
}

std::filesystem::path matches_folder() {
    return below(base_folder("XDG_DATA_HOME", ".local/share"), "thaum/matches");
}

Expected<std::filesystem::path> new_match_log(const std::filesystem::path& folder, int kept) {
    if (auto made = make_folder(folder); !made) return tl::unexpected(made.error());
    const auto logs = match_logs(folder);
    delete_oldest(logs, kept);
    const auto number = text(logs.empty() ? 1 : logs.back().number + 1);
    const auto padding = std::string(number.size() < 6 ? 6 - number.size() : 0, '0');
    return folder / text(padding, number, "_", date_and_time(std::time(nullptr)), log_ending);
}

}  // namespace thaum::app
