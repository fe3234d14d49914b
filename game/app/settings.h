// game/app/settings.h: what people like to have their way, from one file in their configuration folder, and where the
// logs of their matches go.
#pragma once
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/error.h"
#include "input/bindings.h"
#include "render/scene.h"

namespace thaum::app {

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
    int logs_kept = 50;
    std::array<input::Bindings, input::device_kinds> bindings;  ///< by input::DeviceKind

    Settings();
    const input::Bindings& bindings_of(input::DeviceKind kind) const {
        return bindings[static_cast<std::size_t>(kind)];
    }
};

/// Codes of keys by the names that bindings use ("left_alt", "escape", "kp_8").
std::optional<int> key_code_of(std::string_view name);

/// `name` is used in messages. An error names file, line and key.
Expected<Settings> parse_settings(std::string_view toml, std::string name);

/// Reads the file. Where there is none, it writes the documented defaults of assets/settings.toml there first, and goes
/// on with the defaults if it cannot. A file that is there is never written.
Expected<Settings> load_settings(const std::filesystem::path& file, const std::filesystem::path& assets);

/// $XDG_CONFIG_HOME/thaum/settings.toml, or below ~/.config.
std::filesystem::path settings_file();
/// $XDG_DATA_HOME/thaum/matches, or below ~/.local/share.
std::filesystem::path matches_folder();

/// A name for the log of a match that starts now, in a folder that is made if need be: date, time and a counter. Of the
/// logs that were named so, and of their rematches', the oldest are deleted until `kept` - 1 are left; never one that is
/// being recorded. Another program may take the name before it is used: see LivePlan::next_free_name.
Expected<std::filesystem::path> new_match_log(const std::filesystem::path& folder, int kept);

}  // namespace thaum::app
