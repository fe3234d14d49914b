#include "game/app/settings.h"

#include <algorithm>
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
constexpr auto hands = {input::DeviceKind::keyboard_mouse, input::DeviceKind::keyboard_half,
                        input::DeviceKind::pad};

/// An XDG folder: an absolute path in the variable, else the usual place below the home folder.
std::filesystem::path base_folder(const char* variable, const char* usual) {
    const char* set = std::getenv(variable);
    if (set != nullptr && std::filesystem::path(set).is_absolute()) return set;
    const char* home = std::getenv("HOME");
    return std::filesystem::path(home != nullptr && *home != '\0' ? home : ".") / usual;
}

void read_bindings(const ConfigTable& root, Settings& settings) {
    for (const auto kind : hands) {
        auto& bindings = settings.bindings[static_cast<std::size_t>(kind)];
        const auto name = input::name_of(kind);
        if (root.has(name))
            bindings = input::read_bindings(root.table(name), std::move(bindings), key_code_of);
    }
}

std::optional<render::Quality> read_quality(const ConfigTable& root) {
    std::vector<std::string_view> names{"auto"};
    names.insert(names.end(), render::quality_names.begin(), render::quality_names.end());
    const auto chosen = root.choice("quality", names, 0);
    if (chosen == 0) return std::nullopt;
    return static_cast<render::Quality>(chosen - 1);
}

std::string two_digits(int n) { return text(n < 10 ? "0" : "", n); }

/// "2026-03-01_18-05-59": sorts as time goes.
std::string date_and_time() {
    const std::time_t now = std::time(nullptr);
    std::tm t{};
    ::localtime_r(&now, &t);
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

/// The date and counter, then the rematches by number: the tenth comes after the second.
bool is_older(const std::filesystem::path& a, const std::filesystem::path& b) {
    const auto key = [](const std::filesystem::path& path) {
        auto name = path.stem().string();
        const auto dated = name.substr(0, name.find('-', 20));
        return std::tuple(dated, name.size(), std::move(name));
    };
    return key(a) < key(b);
}

/// Another program may be recording into one of them.
void delete_oldest(const std::filesystem::path& folder, int kept) {
    std::vector<std::filesystem::path> logs;
    std::error_code error;
    for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end;
         it.increment(error)) {
        if (it->is_regular_file(error) && is_own_name(it->path().filename().string()))
            logs.push_back(it->path());
    }
    std::sort(logs.begin(), logs.end(), is_older);
    const auto room = static_cast<std::size_t>(std::max(kept - 1, 0));
    for (std::size_t i = 0; i + room < logs.size(); ++i) {
        if (!input::log_in_use(logs[i])) std::filesystem::remove(logs[i], error);
    }
}

}  // namespace

Settings::Settings() {
    for (std::size_t kind = 0; kind < input::device_kinds; ++kind)
        bindings[kind] = input::default_bindings(static_cast<input::DeviceKind>(kind), key_code_of);
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

Expected<Settings> parse_settings(std::string_view toml, std::string name) {
    const auto file = Config::parse(toml, std::move(name), 1);
    if (!file) return tl::unexpected(file.error());
    const auto root = file->root();
    Settings s;
    s.split = root.choice("split", {"top_bottom", "side_by_side"}, 0) == 0 ? render::Split::top_bottom
                                                                           : render::Split::side_by_side;
    s.fullscreen = root.boolean("fullscreen", s.fullscreen);
    s.fov = root.number("fov_deg", {60, 130}, s.fov);
    s.text_scale = root.number("text_scale", {0.5, 2.5}, s.text_scale);
    s.quality = read_quality(root);
    s.bloom = root.boolean("bloom", s.bloom);
    s.frames_per_second = root.number("frames_per_second", {10, 360}, s.frames_per_second);
    s.sensitivity = root.number("sensitivity", {0.05, 20}, s.sensitivity);
    s.turn_deg_per_s = root.number("turn_deg_per_s", {20, 1000}, s.turn_deg_per_s);
    s.invert_y = root.boolean("invert_y", s.invert_y);
    s.logs_kept = static_cast<int>(root.integer("logs_kept", {1, 100000}, s.logs_kept));
    read_bindings(root, s);
    if (const auto checked = file->check(); !checked) return tl::unexpected(checked.error());
    return s;
}

Expected<Settings> load_settings(const std::filesystem::path& file, const std::filesystem::path& assets) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) {
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

std::filesystem::path settings_file() {
    return base_folder("XDG_CONFIG_HOME", ".config") / "thaum" / "settings.toml";
}

std::filesystem::path matches_folder() {
    return base_folder("XDG_DATA_HOME", ".local/share") / "thaum" / "matches";
}

Expected<std::filesystem::path> new_match_log(const std::filesystem::path& folder, int kept) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) return fail(text(folder.string(), ": cannot be created: ", error.message()));
    delete_oldest(folder, kept);
    const auto now = date_and_time();
    for (int i = 1; i < 100; ++i) {
        const auto path = folder / text(now, "_", two_digits(i), log_ending);
        if (!std::filesystem::exists(path, error)) return path;
    }
    return fail(text(folder.string(), ": has 99 logs of this second already"));
}

}  // namespace thaum::app
