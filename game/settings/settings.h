// game/settings/settings.h: a player's preferences, kept in one file in the user's configuration folder, and
// the folder and names of recorded matches.
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
#include "game/data/control_names.h"
#include "game/senses/sound/heard.h"
#include "game/senses/tactile/felt_sound.h"
#include "game/settings/body_faders.h"
#include "game/settings/faders.h"
#include "input/bindings.h"
#include "input/stick.h"
#include "render/scene.h"

namespace thaum::game::inline settings {

/// Keys that control the session, whatever devices the players use.
enum class SessionKey : std::uint8_t { pause, again, leave, split, fullscreen, mark, forces };
inline constexpr std::size_t session_keys = 7;
/// Name of a key in the table [session] of the file: "pause", "again", ...
std::string_view name_of(SessionKey key);

/// A choice in the menu for the largest force (% of the device's peak force).
struct ForceChoice {
    std::string_view name;
    std::optional<std::uint32_t> percent{};  ///< the force; std::nullopt: the value in the data files
};
inline constexpr std::array<ForceChoice, 6> force_choices{
    {{"off", 0}, {"soft", 25}, {"gentle", std::nullopt}, {"firm", 70}, {"full", 100}, {"own", std::nullopt}}};
inline constexpr std::size_t gentle_force = 2, full_force = 4, own_force = 5;

/// Settings that belong to one person. The file has a table for each player, [player_1] and [player_2].
struct PlayerSettings {
    std::string name{};                      ///< display name (player_name.h); empty: the name of the team
    bool captions = true;                    ///< true: the view has captions of what happens to the player
    HeardWish heard = HeardWish::important;  ///< which sounds and effects are also shown in words
    bool figure = true;                      ///< true: a figure in the view shows what the body feels
    double sensitivity = 1;
    double turn_deg_per_s = 200;
    /// time over which a turn by stick or keys grows to its full speed (s)
    double turn_ramp_s = 0.15;
    /// dead zone and response curve of the sticks of a pad (input/stick.h)
    double stick_dead_zone = input::StickResponse{}.dead_zone, stick_curve = input::StickResponse{}.curve;
    bool invert_y = false;
    double rumble = 0.7;  ///< strength of the motors of a pad (0 to 1)
    /// help with aiming for each kind of device (0 to 1; game/context/aim_assist.h)
    double aim_assist_pad = 0.4, aim_assist_keys = 0.6, aim_assist_mouse = 0;
    bool free_casting = false;         ///< true: hand gestures cast spells without a button
    std::size_t force = gentle_force;  ///< largest force, as an index into force_choices
    int own_force_percent = 45;        ///< largest force of the choice "own" (% of the device's peak)
    /// felt share of a carried thing's weight, as a multiple of the data files' value (0 to 1)
    double carried_weight = 1;
    /// felt share of the blows on a carried thing, as a multiple of the data files' value (0 to 1)
    double carried_blows = 1;
    double recoil = 1;        ///< felt share of the wands' recoil (0 to 1)
    double roughness = 1;     ///< felt share of the friction of touched things (0 to 1)
    PromptWish prompts{};     ///< when the screen shows which control does what
    double jacket_sound = 0;  ///< strength of sounds on the jacket (0 to 1); 0: none
    FeltGroups jacket_sound_of = FeltGroups::music;  ///< kinds of sound that the jacket plays
    std::string jacket{};                            ///< the player's jacket (jacket.h); empty: none
    std::string
        jacket_layout{};  ///< layout of the jacket (load_own_layout); empty: the usual layout of its kind
    /// strengths of the effects on jacket and motors, one fader for each kind of effect
    tactile::Faders body{};

    bool operator==(const PlayerSettings&) const = default;
};

/// Largest force that a player has chosen (% of the device's peak); std::nullopt: the value in the data
/// files.
std::optional<std::uint32_t> force_percent_of(const PlayerSettings& player);

/// The last choices on the start screen. If the data folder no longer has a chosen name, the default is used.
struct LastChoice {
    std::string bot = "level_0", match = "quick", arena = "boiling_court";
    std::vector<std::string> mutators{};
    bool operator==(const LastChoice&) const = default;
};

struct Settings {
    render::Split split = render::Split::top_bottom;
    bool fullscreen = false;
    double fov = 90;  ///< field of view (degrees)
    double text_scale = 1;
    /// quality of the picture; std::nullopt: chosen by the OpenGL renderer and by measured times
    std::optional<render::Quality> quality{};
    bool bloom = true;
    double frames_per_second = 60;
    /// Loudness of all sounds and of each group (0 to 1).
    double sound_master = 0.8, sound_effects = 1, sound_music = 0.5, sound_interface = 0.7;
    /// True: headphones; the sound for a single listener has directions as heard by two ears (HRTF)
    bool headphones = false;
    /// True: with two players, the first hears only the left loudspeaker, the second only the right.
    bool ears_apart = false;
    std::array<PlayerSettings, 2> players{};
    std::array<Faders, 2> cauldron{};  ///< strengths of the cauldron's forces on each player's hand
    int countdown_s = 3;               ///< time from the start screen to the start of a match (s)
    int logs_kept = 50;
    LastChoice last{};
    /// Bindings of each kind of device, indexed by input::DeviceKind.
    std::array<input::Bindings, input::device_kinds> bindings;
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

/// Names of the settings file's tables with each player's own settings, strengths of the cauldron's forces on
/// the hand, and strengths of effects on the body.
inline constexpr std::array<std::string_view, 2> player_tables{"player_1", "player_2"};
inline constexpr std::array<std::string_view, 2> cauldron_tables{"cauldron_1", "cauldron_2"};
inline constexpr std::array<std::string_view, 2> body_tables{"body_1", "body_2"};

/// Devices that have bindings, in the order of the file.
inline constexpr std::array settings_hands{input::DeviceKind::keyboard_mouse,
                                           input::DeviceKind::keyboard_half, input::DeviceKind::pad};

/// Code of a key by its name in bindings ("left_alt", "escape", "kp_8"); std::nullopt if no key has that
/// name.
std::optional<int> key_code_of(std::string_view name);
/// Name of a key in bindings; empty for a code without a key.
std::string key_name_of(int code);

// Tables of the settings at the top level of the file, and of those that each player has. Reader, writer and
// settings pages all use these tables. A new setting needs a member of Settings or PlayerSettings, a row in a
// table and a line in assets/settings.toml.

template <class Of>
struct NumberOf {
    double Of::*value{};
    double low{}, high{};
    double step{};         ///< change by one key press on the settings page
    double shown_times{};  ///< factor from the stored value to the number on the settings page
    std::string_view unit{};
};
template <class Of>
struct WholeOf {
    int Of::*value{};
    int low{}, high{}, step{};
    std::string_view unit{};  ///< unit on the settings page
};
template <class Of>
struct FlagOf {
    bool Of::*value{};
};
template <class Of>
struct ChoiceOf {
    /// Names of the choices in the file; the settings page shows them with spaces.
    std::vector<std::string_view> names;
    std::size_t (*get)(const Of&){};
    void (*set)(Of&, std::size_t){};
};
/// Page of the menu on which a setting is. Settings of one player are on that player's page or on the
/// mixer's, the page for the strengths of what the player feels.
enum class SettingPage : std::uint8_t { main, sound, mixer };
template <class Of>
struct SettingOf {
    std::string_view key;
    std::string_view label;  ///< name on the settings page
    std::string_view help;   ///< one sentence about what the setting changes
    std::variant<NumberOf<Of>, WholeOf<Of>, FlagOf<Of>, ChoiceOf<Of>> kind;
    bool next_match = false;  ///< true: a change takes effect only in the next match
    SettingPage page{};
};
using Setting = SettingOf<Settings>;
using PlayerSetting = SettingOf<PlayerSettings>;
std::span<const Setting> all_settings();
/// All settings of one player, except the name, the jacket, and the strengths of effects on the body and of
/// the brew's forces.
std::span<const PlayerSetting> player_settings();

/// Names of the choices for the largest force (force_choices).
const std::vector<std::string_view>& force_names();

// In these templates, the type Of is Settings or PlayerSettings.

/// Reads a value from its key in a table of the file. Without the key the value is not changed.
template <class Of>
void read(const ConfigTable& table, const SettingOf<Of>& setting, Of& values);
/// Text of a value: `written` gives it as in the file, `shown` as on the settings page.
template <class Of>
std::string written(const SettingOf<Of>& setting, const Of& values);
template <class Of>
std::string shown(const SettingOf<Of>& setting, const Of& values);
/// Changes a value by `steps`, within its range. An odd number of steps toggles a flag. After the last
/// choice comes the first.
template <class Of>
void change(const SettingOf<Of>& setting, Of& values, int steps);
/// Copies the value of one setting from some settings to others.
template <class Of>
void copy_value(const SettingOf<Of>& setting, const Of& from, Of& to);
/// Sets a setting to its default value.
template <class Of>
void reset(const SettingOf<Of>& setting, Of& values);

/// Name of a player on every page: the chosen name, or the team's ("Ember", "Tide").
std::string player_words(const Settings& settings, std::size_t player);

/// Settings read from a file in which single values may be wrong.
struct ReadSettings {
    Settings settings;
    /// First fault, with file, line and key. Wrong values are replaced by their defaults, and unknown keys
    /// are ignored.
    std::optional<Error> fault{};
};
/// Reads as much of a settings file as possible. `name`: file name in messages. Fails if the file is not
/// TOML, or is of another version, in which values may have another meaning.
Expected<ReadSettings> read_settings(std::string_view toml, std::string name);

/// Parses a settings file that must have no fault. `name`: file name in messages. An error names file, line
/// and key.
Expected<Settings> parse_settings(std::string_view toml, std::string name);

/// Reads the settings file. If there is none, first writes the documented defaults of assets/settings.toml
/// there. Returns the defaults if the file cannot be written. Never changes an existing file.
Expected<Settings> load_settings(const std::filesystem::path& file, const std::filesystem::path& assets);

/// Settings for a session of play.
struct PlaySettings {
    Settings settings;
    std::string fault{};  ///< message for the player about a fault in the file; empty: no fault
};
/// Reads the settings for a session of play, as load_settings does. Wrong values are replaced by their
/// defaults; if the file cannot be read at all, all values are. A fault is reported in one line on standard
/// error, and the file is not changed.
PlaySettings settings_to_play_with(const std::filesystem::path& file, const std::filesystem::path& assets);

/// One value of the file to be changed. `table` is empty for values at the top level; `value` is written as
/// TOML.
struct SettingEdit {
    std::string table, key, value;
    bool operator==(const SettingEdit&) const = default;
};
/// Edits that turn a file with the values `before` into one with the values `after`.
std::vector<SettingEdit> changes(const Settings& before, const Settings& after);

/// Returns the file's text with changed values. Everything else, such as comments and order, is kept. The
/// returned text is checked to parse to the requested values. The error says why a value could not be
/// changed: the text has a fault, or a line-by-line edit cannot change it.
Expected<std::string> edit_settings(std::string_view toml, const std::string& name,
                                    const std::vector<SettingEdit>& edits);

/// Writes the changes into the file, all or none. A file that cannot be read, or is of another version, is
/// not changed and gives an error of one line.
Expected<void> save_changes(const std::filesystem::path& file, const Settings& before, const Settings& after);

/// Path of the settings file: $XDG_CONFIG_HOME/thaum/settings.toml, or below ~/.config.
std::filesystem::path settings_file();
/// Folder of recorded matches: $XDG_DATA_HOME/thaum/matches, or below ~/.local/share.
std::filesystem::path matches_folder();

/// Path for the log of a match that starts now: a counter, date and time, in a folder that is created if
/// necessary. Deletes the oldest logs with such names, rematches included, until `kept` - 1 are left, but
/// never a log that is being recorded. Another program may use the name first: see create_beside in
/// live/recording.cpp.
Expected<std::filesystem::path> new_match_log(const std::filesystem::path& folder, int kept);

}  // namespace thaum::game::inline settings
