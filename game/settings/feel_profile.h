// game/settings/feel_profile.h: all strengths that a player feels as one profile: the faders for forces,
// motors and jacket. The game has three preset profiles. Players save their own under a name, each in a file
// in the folder `feel` beside the settings file.
#pragma once
#include "game/settings/settings.h"

namespace thaum::game::inline settings {

struct FeelProfile {
    std::string name{};
    /// settings of the player; only those on the mixer's page of the menu, and the strengths of effects on
    /// the body, are used
    PlayerSettings felt{};
    Faders cauldron{};
};

/// Presets: "gentle" (the defaults), "full" (all that devices can do), "silent" (nothing is felt).
const std::vector<FeelProfile>& feel_presets();

/// Copies the values of a profile to a player's settings.
void use(const FeelProfile& profile, Settings& settings, std::size_t player);
/// The values of a player, as a profile without a name.
FeelProfile feel_of(const Settings& settings, std::size_t player);
/// Whether two profiles have the same values. Names are not compared.
bool feels_alike(const FeelProfile& a, const FeelProfile& b);

/// Text of a profile's file (`written`), and the profile that such a text contains (`parse_feel_profile`).
/// Missing keys get their defaults. `file`: name in messages.
std::string written(const FeelProfile& profile);
Expected<FeelProfile> parse_feel_profile(std::string_view toml, const std::string& file);

/// All profiles of a folder, sorted by name. Files that cannot be read are left out; `faults` receives
/// one line for each.
std::vector<FeelProfile> load_feel_profiles(const std::filesystem::path& folder,
                                            std::vector<std::string>& faults);
/// Writes a profile, replacing one of the same name.
Expected<void> save_feel_profile(const std::filesystem::path& folder, const FeelProfile& profile);

}  // namespace thaum::game::inline settings
