// game/app/settings.h: what people like to have their way, from one file in their configuration folder, and where the
// logs of their matches go.
#pragma once
#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/error.h"
#include "game/app/faders.h"
#include "input/bindings.h"
#include "render/scene.h"

namespace thaum::app {

/// Keys that act on the session, whoever plays with what.
enum class SessionKey : std::uint8_t { pause, again, leave, split, fullscreen, mark, forces };
inline constexpr std::size_t session_keys = 7;
/// "pause", "again", ...: the keys of the table [session].
std::string_view name_of(SessionKey key);

/// How much of a device's force a player wants, at most; %.
struct ForceWish {
    std::string_view name;
    std::optional<std::uint32_t> percent{};  ///< nothing: what the data files say
};
inline constexpr std::array<ForceWish, 5> force_wishes{
    {{"off", 0}, {"soft", 25}, {"gentle", std::nullopt}, {"firm", 70}, {"full", 100}}};
inline constexpr std::size_t gentle_force = 2;

struct Settings {
    render::Split split = render::Split::top_bottom;
    bool fullscreen = false;
    double fov = 90;  ///< degrees
    double text_scale = 1;
    std::optional<render::Quality> quality{};  ///< nothing: chosen by what draws and by measured times
    bool bloom = true;
    double frames_per_second = 60;
    double sensitivity = 1;
    double turn_deg_per_s = 200;
    bool invert_y = false;
    std::array<std::size_t, 2> force{gentle_force, gentle_force};  ///< of each player, into force_wishes
    double carried_weight = 1;  ///< of a carried thing's weight, as the data files have it: what hands feel
    double carried_blows = 1;   ///< likewise of the blows that it takes
    std::array<Faders, 2> cauldron{};  ///< of each player
    int logs_kept = 50;
    std::array<input::Bindings, input::device_kinds> bindings;  ///< by input::DeviceKind
    std::array<std::vector<input::Control>, session_keys> session;

    Settings();
    bool operator==(const Settings&) const = default;
    const input::Bindings& bindings_of(input::DeviceKind kind) const {
        return bindings[static_cast<std::size_t>(kind)];
    }
    input::Bindings& bindings_of(input::DeviceKind kind) { return bindings[static_cast<std::size_t>(kind)]; }
    const std::vector<input::Control>& of(SessionKey key) const {
        return session[static_cast<std::size_t>(key)];
    }
};

/// The tables of the players' faders.
inline constexpr std::array<std::string_view, 2> cauldron_tables{"cauldron_1", "cauldron_2"};

/// The hands that have bindings, in the order of the file.
inline constexpr std::array settings_hands{input::DeviceKind::keyboard_mouse,
                                           input::DeviceKind::keyboard_half, input::DeviceKind::pad};

/// Codes of keys by the names that bindings use ("left_alt", "escape", "kp_8").
std::optional<int> key_code_of(std::string_view name);
/// Such a name; empty for a code that is no key.
std::string key_name_of(int code);

// All values at the top of the file, as a table: the reader, the writer and the settings screen go by it, so a new setting is a
// member of Settings, a row here and a line in assets/settings.toml.

struct NumberSetting {
    double Settings::*value{};
    double low{}, high{};
    double step{};         ///< of the screen
    double shown_times{};  ///< the screen shows so many times the value ...
    std::string_view unit{};
};
struct WholeSetting {
    int Settings::*value{};
    int low{}, high{}, step{};
};
struct FlagSetting {
    bool Settings::*value{};
};
struct ChoiceSetting {
    std::vector<std::string_view> names;  ///< in the file; the screen shows them with spaces
    std::size_t (*get)(const Settings&){};
    void (*set)(Settings&, std::size_t){};
};
struct Setting {
    std::string_view key;
    std::string_view label;  ///< for people
    std::variant<NumberSetting, WholeSetting, FlagSetting, ChoiceSetting> kind;
    bool next_match = false;  ///< a change counts from the next match on
};
std::span<const Setting> all_settings();

/// The value as the file has it, and as people read it.
std::string written(const Setting& setting, const Settings& settings);
std::string shown(const Setting& setting, const Settings& settings);
/// `steps` up or down, within the range; flags and choices go round.
void change(const Setting& setting, Settings& settings, int steps);

/// `name` is used in messages. An error names file, line and key.
Expected<Settings> parse_settings(std::string_view toml, std::string name);

/// Reads the file. Where there is none, it writes the documented defaults of assets/settings.toml there first, and goes
/// on with the defaults if it cannot. A file that is there is never written.
Expected<Settings> load_settings(const std::filesystem::path& file, const std::filesystem::path& assets);

/// As load_settings, for playing: a file that cannot be read is told of in one line on standard error, kept as it is,
/// and the defaults hold.
Settings settings_to_play_with(const std::filesystem::path& file, const std::filesystem::path& assets);

/// One value of the file; `table` is empty at the top. `value` is written as TOML.
struct SettingEdit {
    std::string table, key, value;
    bool operator==(const SettingEdit&) const = default;
};
/// What must be written so that a file that says `before` says `after`.
std::vector<SettingEdit> changes(const Settings& before, const Settings& after);

/// The file's text with other values; comments, order and all else stay. The error says why a value could not be put there: the
/// text is faulty, or written in a way that line by line cannot be changed. What is returned reads back as asked for.
Expected<std::string> edit_settings(std::string_view toml, const std::string& name,
                                    const std::vector<SettingEdit>& edits);

/// Puts what changed into the file, whole or not at all. A file that cannot be read, or is of another version, is kept
/// as it is; that is an error, in one line.
Expected<void> save_changes(const std::filesystem::path& file, const Settings& before, const Settings& after);

/// $XDG_CONFIG_HOME/thaum/settings.toml, or below ~/.config.
std::filesystem::path settings_file();
/// $XDG_DATA_HOME/thaum/matches, or below ~/.local/share.
std::filesystem::path matches_folder();

/// A name for the log of a match that starts now, in a folder that is made if need be: date, time and a counter. Of the
/// logs that were named so, and of their rematches', the oldest are deleted until `kept` - 1 are left; never one that is
/// being recorded. Another program may take the name before it is used: see LivePlan::next_free_name.
Expected<std::filesystem::path> new_match_log(const std::filesystem::path& folder, int kept);

}  // namespace thaum::app
