#include "game/settings/settings.h"

#include <pwd.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <tuple>

#include "core/config.h"
#include "core/environment.h"
#include "core/file.h"
#include "core/tell_user.h"
#include "core/text.h"
#include "game/data/teams.h"
#include "game/settings/jacket_settings.h"
#include "game/settings/player_name.h"
#include "input/log.h"
#include "render/context.h"

namespace thaum::game::inline settings {
namespace {

constexpr std::size_t max_settings_file = 1U << 20U;
constexpr std::string_view log_ending = ".thaumlog";
constexpr std::array<std::string_view, session_keys> session_names{"pause",      "again", "leave", "split",
                                                                   "fullscreen", "mark",  "forces"};
constexpr std::array<std::string_view, session_keys> session_defaults{
    "key escape", "key enter, key kp_enter", "key q", "key f6", "key f11", "key f10", "key f3"};

/// The user's home folder; empty if there is none. A relative HOME is ignored, because its meaning would
/// change with the working folder.
std::filesystem::path home_folder() {
    const auto home = environment_value("HOME");
    if (home && std::filesystem::path(*home).is_absolute()) return *home;
    const auto* user = ::getpwuid(::getuid());
    if (user == nullptr || user->pw_dir == nullptr) return {};
    std::filesystem::path listed = user->pw_dir;
    return listed.is_absolute() ? listed : std::filesystem::path();
}

/// An XDG folder: the absolute path in the variable, else the usual place below the home folder. The
/// specification says that relative paths are ignored. Empty if there is no home folder.
std::filesystem::path base_folder(const char* variable, const char* usual) {
    const auto set = environment_value(variable);
    if (set && std::filesystem::path(*set).is_absolute()) return *set;
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

void read_name(const ConfigTable& table, PlayerSettings& player) {
    auto name = player_name(table.string("name", player.name));
    if (name)
        player.name = std::move(*name);
    else
        table.report("name", text("'name': ", name.error().message));
}

/// Reads the largest force of each player from its place in the files of earlier versions.
void read_former_forces(const ConfigTable& root, Settings& s) {
    const auto& names = force_names();
    for (const auto& [key, player] : {std::pair("force_1", &s.players[0]), {"force_2", &s.players[1]}})
        player->force = root.choice(key, names, player->force);
}

/// Reads the dead zone of both players' sticks from its place in the files of earlier versions, which had one
/// for each device's controls. Only a pad has sticks.
void read_former_dead_zone(const ConfigTable& root, Settings& s) {
    for (const auto kind : settings_hands) {
        const auto name = input::name_of(kind);
        if (!root.has(name)) continue;
        const auto read = root.table(name).number("stick_dead_zone", {0, 0.9}, s.players[0].stick_dead_zone);
        if (kind != input::DeviceKind::pad) continue;
        for (auto& player : s.players) player.stick_dead_zone = read;
    }
}

/// Reads the players' own settings. In files of earlier versions they are at the top level and apply to both
/// players.
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

/// The names in a list such as "fog, low_gravity".
std::vector<std::string> names_in_list(std::string_view list) {
    std::vector<std::string> names;
    while (!list.empty()) {
        const auto end = std::min(list.find(','), list.size());
        auto name = list.substr(0, end);
        list.remove_prefix(std::min(end + 1, list.size()));
        while (name.starts_with(' ')) name.remove_prefix(1);
        while (name.ends_with(' ')) name.remove_suffix(1);
        if (!name.empty()) names.emplace_back(name);
    }
    return names;
}

void read_last_choice(const ConfigTable& root, LastChoice& last) {
    // Files of earlier versions have a level, when bots had no other names.
    if (root.has("bot_level")) last.bot = text("level_", root.integer("bot_level", {0, 7}, 0));
    last.bot = root.string("bot", last.bot);
    if (root.has("mutators")) last.mutators = names_in_list(root.string("mutators"));
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

/// Length of the pattern if `name` begins with it, else 0. A d in the pattern matches any digit.
std::size_t fitted(std::string_view name, std::string_view pattern) {
    const bool fits = name.size() >= pattern.size() &&
                      std::equal(pattern.begin(), pattern.end(), name.begin(),
                                 [](char p, char c) { return p == 'd' ? c >= '0' && c <= '9' : c == p; });
    return fits ? pattern.size() : 0;
}

/// A recorded match whose file name was made by this program. Names contain a counter, because clocks may run
/// backwards.
struct MatchLog {
    /// Counter in the name; 0: a name of an earlier version, which has only the date.
    std::uint64_t number{};
    std::string name;  ///< file name without ".thaumlog"
    std::filesystem::path path;

    /// Sort key, oldest first. Of two names with the same beginning the shorter comes first: "-2" before
    /// "-10".
    auto key() const {
        return std::tuple(number, std::string_view(name).substr(0, dated), name.size(), name);
    }

private:
    static constexpr std::size_t dated = std::string_view("dddd-dd-dd_dd-dd-dd_dd").size();
};

/// Counter in the name of a log; std::nullopt if the name was not made by this program. Names look like
/// "000012_2026-03-01_18-05-59.thaumlog", in earlier versions like "2026-03-01_18-05-59_01.thaumlog". A
/// suffix "-2" follows if the name was taken. Only files with such names are ever deleted.
std::optional<std::uint64_t> number_of_own(std::string_view name) {
    const auto digits = std::min(name.find('_'), name.size());
    const bool numbered = digits >= 6 && digits <= 18 && is_number(name.substr(0, digits));
    const auto matched = numbered ? fitted(name.substr(digits), "_dddd-dd-dd_dd-dd-dd") + digits
                                  : fitted(name, "dddd-dd-dd_dd-dd-dd_dd");
    if (matched <= (numbered ? digits : 0)) return std::nullopt;
    const auto remaining = name.substr(matched);
    if (!remaining.empty() && (remaining[0] != '-' || !is_number(remaining.substr(1)))) return std::nullopt;
    return numbered ? std::stoull(std::string(name.substr(0, digits))) : 0;
}

/// Logs in the folder whose names were made by this program, oldest first.
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

/// Deletes the oldest logs until there is room for one more. Logs that a program is recording are not
/// deleted.
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

std::string player_words(const Settings& settings, std::size_t player) {
    const auto& name = settings.players[player].name;
    return name.empty() ? std::string(team_name(static_cast<std::uint32_t>(player))) : name;
}

std::optional<int> key_code_of(std::string_view name) {
    if (name == "escape") return render::key_code("esc");
    if (const auto code = render::key_code(name)) return code;
    // The window library uses other names: "LeftAlt" for "left_alt", and "LeftCtrl" for "left_control".
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
    if (!file) return file.error();
    const auto root = file->root();
    Settings s;
    for (const auto& setting : all_settings()) read(root, setting, s);
    read_last_choice(root, s.last);
    read_players(root, s);
    for (std::size_t p = 0; p < s.cauldron.size(); ++p) {
        if (root.has(cauldron_tables[p]))
            s.cauldron[p] = read_faders(root.table(cauldron_tables[p]), s.cauldron[p]);
        if (root.has(body_tables[p]))
            s.players[p].body = read_body_faders(root.table(body_tables[p]), s.players[p].body);
    }
    read_bindings(root, s);
    const auto checked = file->check();
    return ReadSettings{std::move(s), checked ? std::nullopt : std::optional(checked.error())};
}

namespace {

Expected<Settings> without_fault(Expected<ReadSettings> read) {
    if (!read) return read.error();
    if (read->fault) return *read->fault;
    return std::move(read->settings);
}

Expected<ReadSettings> read_settings_file(const std::filesystem::path& file,
                                          const std::filesystem::path& assets) {
    if (file.empty()) return ReadSettings{};
    std::error_code error;
    // symlink_status is used so that a dangling link counts as an existing file.
    if (!std::filesystem::exists(std::filesystem::symlink_status(file, error))) {
        const auto defaults = read_text_file(assets / "settings.toml", max_settings_file);
        if (!defaults) return defaults.error();
        std::filesystem::create_directories(file.parent_path(), error);
        // A home folder that is not writable must not keep players from playing.
        if (!write_text_file(file, *defaults)) return ReadSettings{};
    }
    const auto source = read_own_text_file(file, max_settings_file);
    if (!source) return source.error();
    return read_settings(*source, file.string());
}

/// Message for the start screen, which has no room for the path: "settings.toml, line 5: 'fov_deg' is 5,
/// ...".
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
    tell_user(text(fault->message, "; it is kept as it is, and ", hold));
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
    if (auto made = make_folder(folder); !made) return made.error();
    const auto logs = match_logs(folder);
    delete_oldest(logs, kept);
    const auto number = text(logs.empty() ? 1 : logs.back().number + 1);
    const auto padding = std::string(number.size() < 6 ? 6 - number.size() : 0, '0');
    return folder / text(padding, number, "_", date_and_time(std::time(nullptr)), log_ending);
}

}  // namespace thaum::game::inline settings
