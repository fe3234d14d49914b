#include "game/app/settings.h"

#include <pwd.h>
#include <sys/stat.h>
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
#include "input/log.h"
#include "render/context.h"

namespace thaum::app {
namespace {

constexpr std::size_t max_settings_file = 1U << 20U;
constexpr std::string_view log_ending = ".thaumlog";
constexpr std::array<std::string_view, session_keys> session_names{"pause",      "again", "leave", "split",
                                                                   "fullscreen", "mark",  "forces"};
constexpr std::array<std::string_view, session_keys> session_defaults{
    "key escape", "key enter, key kp_enter", "key q", "key f6", "key f11", "key f10", "key f3"};

/// The user's home folder; empty: there is none. A relative HOME would lead to another folder in each place.
std::filesystem::path home_folder() {
    const char* home = std::getenv("HOME");
    if (home != nullptr && std::filesystem::path(home).is_absolute()) return home;
    const auto* user = ::getpwuid(::getuid());
    if (user == nullptr || user->pw_dir == nullptr) return {};
    std::filesystem::path listed = user->pw_dir;
    return listed.is_absolute() ? listed : std::filesystem::path();
}

/// An XDG folder: an absolute path in the variable (the specification says that others are ignored), else the usual place
/// below the home folder; empty where there is none.
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
        auto controls = input::parse_controls(table.string(key), key_code_of);
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

void read(const ConfigTable& root, const Setting& setting, Settings& s) {
    if (const auto* n = std::get_if<NumberSetting>(&setting.kind))
        s.*n->value = root.number(setting.key, {n->low, n->high}, s.*n->value);
    if (const auto* w = std::get_if<WholeSetting>(&setting.kind)) {
        const Range range{static_cast<double>(w->low), static_cast<double>(w->high)};
        s.*w->value = static_cast<int>(root.integer(setting.key, range, s.*w->value));
    }
    if (const auto* f = std::get_if<FlagSetting>(&setting.kind))
        s.*f->value = root.boolean(setting.key, s.*f->value);
    if (const auto* c = std::get_if<ChoiceSetting>(&setting.kind))
        c->set(s, root.choice(setting.key, c->names, c->get(s)));
}

std::string two_digits(int n) { return text(n < 10 ? "0" : "", n); }

/// "2026-03-01_18-05-59": sorts as time goes.
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

/// Is it a name that new_match_log or a rematch made ("..._01.thaumlog", "..._01-2.thaumlog")? Only such files are ever deleted.
bool is_own_name(std::string_view name) {
    constexpr std::string_view pattern = "dddd-dd-dd_dd-dd-dd_dd";
    if (!name.ends_with(log_ending) || name.size() < pattern.size() + log_ending.size()) return false;
    name.remove_suffix(log_ending.size());
    const auto dated = name.substr(0, pattern.size()), rest = name.substr(pattern.size());
    return std::equal(dated.begin(), dated.end(), pattern.begin(),
                      [](char c, char p) { return p == 'd' ? c >= '0' && c <= '9' : c == p; }) &&
           (rest.empty() || (rest[0] == '-' && is_number(rest.substr(1))));
}

/// A recorded match as it sorts: the oldest first.
struct AgedLog {
    bool after_now;  ///< recorded before the clock was set back, so before all that is dated in the past
    std::string dated, name;  ///< date and counter; with the number of a rematch
    std::filesystem::path path;

    /// Rematches go by number: the tenth comes after the second.
    auto key() const {
        return std::tuple(!after_now, std::string_view(dated), name.size(), std::string_view(name));
    }
};

/// Names are in local time, which summer time and journeys move by up to a day, and a clock that is kept right steps by
/// seconds: what is further ahead than that was recorded under another clock.
AgedLog aged(const std::filesystem::path& path, std::time_t now) {
    constexpr std::time_t journeys_s = 26 * 3600, steps_s = 120;
    AgedLog log{false, {}, path.stem().string(), path};
    log.dated = log.name.substr(0, log.name.find('-', 20));
    struct stat info {};
    const bool written_later = ::stat(path.c_str(), &info) == 0 && info.st_mtime > now + steps_s;
    log.after_now = written_later || log.dated > date_and_time(now + journeys_s);
    return log;
}

/// Another program may be recording into one of them.
void delete_oldest(const std::filesystem::path& folder, int kept) {
    std::vector<AgedLog> logs;
    const auto now = std::time(nullptr);
    std::error_code error;
    for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end;
         it.increment(error)) {
        if (it->is_regular_file(error) && is_own_name(it->path().filename().string()))
            logs.push_back(aged(it->path(), now));
    }
    std::sort(logs.begin(), logs.end(), [](const auto& a, const auto& b) { return a.key() < b.key(); });
    const auto room = static_cast<std::size_t>(std::max(kept - 1, 0));
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

std::string_view name_of(SessionKey key) { return session_names[static_cast<std::size_t>(key)]; }

namespace {

ChoiceSetting quality_setting() {
    std::vector<std::string_view> names{"auto"};
    names.insert(names.end(), render::quality_names.begin(), render::quality_names.end());
    return {std::move(names),
            [](const Settings& s) { return s.quality ? static_cast<std::size_t>(*s.quality) + 1 : 0; },
            [](Settings& s, std::size_t i) {
                s.quality.reset();
                if (i > 0) s.quality = static_cast<render::Quality>(i - 1);
            }};
}

template <std::size_t Player>
ChoiceSetting force_setting() {
    std::vector<std::string_view> names;
    for (const auto& wish : force_wishes) names.push_back(wish.name);
    return {std::move(names), [](const Settings& s) { return s.force[Player]; },
            [](Settings& s, std::size_t i) { s.force[Player] = i; }};
}

}  // namespace

std::span<const Setting> all_settings() {
    static const std::vector<Setting> settings{
        {"split", "Split",
         ChoiceSetting{{"top_bottom", "side_by_side"},
                       [](const Settings& s) { return s.split == render::Split::top_bottom ? 0UL : 1UL; },
                       [](Settings& s, std::size_t i) {
                           s.split = i == 0 ? render::Split::top_bottom : render::Split::side_by_side;
                       }}},
        {"fullscreen", "Full screen", FlagSetting{&Settings::fullscreen}},
        {"fov_deg", "Field of view", NumberSetting{&Settings::fov, 60, 130, 5, 1, "\u00B0"}},
        {"text_scale", "Text size", NumberSetting{&Settings::text_scale, 1, 2.5, 0.25, 100, " %"}},
        {"sensitivity", "Mouse speed", NumberSetting{&Settings::sensitivity, 0.05, 20, 0.05, 1, ""}},
        {"invert_y", "Up is down", FlagSetting{&Settings::invert_y}},
        {"turn_deg_per_s", "Stick and arrow speed",
         NumberSetting{&Settings::turn_deg_per_s, 20, 1000, 10, 1, "\u00B0/s"}, true},
        {"force_1", "Force on player 1's hand", force_setting<0>(), true},
        {"force_2", "Force on player 2's hand", force_setting<1>(), true},
        {"carried_weight", "Weight of what is carried",
         NumberSetting{&Settings::carried_weight, 0, 1, 0.25, 100, " %"}, true},
        {"carried_blows", "Blows on what is carried",
         NumberSetting{&Settings::carried_blows, 0, 1, 0.25, 100, " %"}, true},
        {"quality", "Picture quality", quality_setting()},
        {"bloom", "Bloom at high quality", FlagSetting{&Settings::bloom}},
        {"frames_per_second", "Pictures a second",
         NumberSetting{&Settings::frames_per_second, 10, 360, 5, 1, ""}},
        {"logs_kept", "Matches kept", WholeSetting{&Settings::logs_kept, 1, 100000, 10}},
    };
    return settings;
}

std::string written(const Setting& setting, const Settings& s) {
    if (const auto* n = std::get_if<NumberSetting>(&setting.kind)) return text(s.*n->value);
    if (const auto* w = std::get_if<WholeSetting>(&setting.kind)) return text(s.*w->value);
    if (const auto* f = std::get_if<FlagSetting>(&setting.kind)) return text(s.*f->value);
    const auto& c = std::get<ChoiceSetting>(setting.kind);
    return text('"', c.names[c.get(s)], '"');
}

std::string shown(const Setting& setting, const Settings& s) {
    if (const auto* n = std::get_if<NumberSetting>(&setting.kind)) {
        const double value = std::round(s.*n->value * n->shown_times * 100) / 100;
        return text(value, n->unit);
    }
    if (const auto* f = std::get_if<FlagSetting>(&setting.kind)) return s.*f->value ? "yes" : "no";
    if (const auto* c = std::get_if<ChoiceSetting>(&setting.kind)) {
        std::string name(c->names[c->get(s)]);
        std::replace(name.begin(), name.end(), '_', ' ');
        return name;
    }
    return written(setting, s);
}

void change(const Setting& setting, Settings& s, int steps) {
    if (const auto* n = std::get_if<NumberSetting>(&setting.kind)) {
        // To a whole number of steps, divided and not multiplied: 0.3, not 0.30000000000000004.
        const double per_unit = std::round(1 / n->step);
        const double whole = std::round(s.*n->value / n->step) + steps;
        const double value = n->step < 1 ? whole / per_unit : whole * n->step;
        s.*n->value = std::clamp(value, n->low, n->high);
    }
    if (const auto* w = std::get_if<WholeSetting>(&setting.kind))
        s.*w->value = std::clamp(s.*w->value + steps * w->step, w->low, w->high);
    if (const auto* f = std::get_if<FlagSetting>(&setting.kind))
        s.*f->value = (steps % 2 != 0) != s.*f->value;
    if (const auto* c = std::get_if<ChoiceSetting>(&setting.kind)) {
        const auto count = static_cast<int>(c->names.size());
        const int at = static_cast<int>(c->get(s)) + steps % count + count;
        c->set(s, static_cast<std::size_t>(at % count));
    }
}

std::optional<int> key_code_of(std::string_view name) {
    if (name == "escape") return render::key_code("esc");
    if (const auto code = render::key_code(name)) return code;
    // The window layer writes "LeftAlt", settings "left_alt"; "left_control" is its "LeftCtrl".
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

Expected<Settings> parse_settings(std::string_view toml, std::string name) {
    const auto file = Config::parse(toml, std::move(name), 1);
    if (!file) return tl::unexpected(file.error());
    const auto root = file->root();
    Settings s;
    for (const auto& setting : all_settings()) read(root, setting, s);
    for (std::size_t p = 0; p < s.cauldron.size(); ++p) {
        if (root.has(cauldron_tables[p]))
            s.cauldron[p] = read_faders(root.table(cauldron_tables[p]), s.cauldron[p]);
    }
    read_bindings(root, s);
    if (const auto checked = file->check(); !checked) return tl::unexpected(checked.error());
    return s;
}

Expected<Settings> load_settings(const std::filesystem::path& file, const std::filesystem::path& assets) {
    if (file.empty()) return Settings{};
    std::error_code error;
    // A link that leads nowhere is there as well.
    if (!std::filesystem::exists(std::filesystem::symlink_status(file, error))) {
        const auto defaults = read_text_file(assets / "settings.toml", max_settings_file);
        if (!defaults) return tl::unexpected(defaults.error());
        std::filesystem::create_directories(file.parent_path(), error);
        // A home folder that cannot be written to is no reason not to play.
        if (!write_text_file(file, *defaults)) return Settings{};
    }
    const auto source = read_text_file(file, max_settings_file);
    if (!source) return tl::unexpected(source.error());
    return parse_settings(*source, file.string());
}

Settings settings_to_play_with(const std::filesystem::path& file, const std::filesystem::path& assets) {
    auto settings = load_settings(file, assets);
    if (settings) return std::move(*settings);
    std::fprintf(stderr, "%s; it is kept as it is, and the defaults hold\n",
                 settings.error().message.c_str());
    return {};
}

std::filesystem::path settings_file() {
    return below(base_folder("XDG_CONFIG_HOME", ".config"), "thaum/settings.toml");
}

std::filesystem::path matches_folder() {
    return below(base_folder("XDG_DATA_HOME", ".local/share"), "thaum/matches");
}

Expected<std::filesystem::path> new_match_log(const std::filesystem::path& folder, int kept) {
    if (auto made = make_folder(folder); !made) return tl::unexpected(made.error());
    delete_oldest(folder, kept);
    std::error_code error;
    const auto now = date_and_time(std::time(nullptr));
    for (int i = 1; i < 100; ++i) {
        const auto path = folder / text(now, "_", two_digits(i), log_ending);
        if (!std::filesystem::exists(path, error)) return path;
    }
    return fail(text(folder.string(), ": has 99 logs of this second already"));
}

}  // namespace thaum::app
