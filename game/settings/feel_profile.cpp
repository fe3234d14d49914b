#include "game/settings/feel_profile.h"

#include <algorithm>

#include "core/file.h"
#include "core/text.h"
#include "game/settings/player_name.h"

namespace thaum::game::inline settings {
namespace {

constexpr std::size_t max_profiles = 100, max_faults = 10;
constexpr std::size_t max_file = 1U << 16U;
constexpr std::string_view ending = ".toml";

template <class Do>
void each_felt(Do act) {
    for (const auto& setting : player_settings())
        if (setting.page == SettingPage::mixer) act(setting);
}

FeelProfile full_preset() {
    FeelProfile full{.name = "full"};
    full.felt.force = full_force;
    full.felt.rumble = 1;
    full.felt.body.values.fill(1);
    return full;
}

FeelProfile silent_preset() {
    FeelProfile silent{.name = "silent"};
    silent.felt.force = 0;
    silent.felt.rumble = 0;
    silent.felt.body.values.fill(0);
    return silent;
}

}  // namespace

const std::vector<FeelProfile>& feel_presets() {
    static const std::vector<FeelProfile> presets{{.name = "gentle"}, full_preset(), silent_preset()};
    return presets;
}

void use(const FeelProfile& profile, Settings& settings, std::size_t player) {
    auto& own = settings.players.at(player);
    each_felt([&](const PlayerSetting& setting) { copy_value(setting, profile.felt, own); });
    own.body = profile.felt.body;
    settings.cauldron.at(player) = profile.cauldron;
}

FeelProfile feel_of(const Settings& settings, std::size_t player) {
    FeelProfile profile{.cauldron = settings.cauldron.at(player)};
    each_felt([&](const PlayerSetting& setting) {
        copy_value(setting, settings.players.at(player), profile.felt);
    });
    profile.felt.body = settings.players.at(player).body;
    return profile;
}

bool feels_alike(const FeelProfile& a, const FeelProfile& b) {
    return a.felt == b.felt && a.cauldron == b.cauldron;
}

std::string written(const FeelProfile& profile) {
    std::string toml =
        text("# What a player feels in Thaum. The settings file explains the values.\nversion = 1\n",
             "name = ", in_quotes(profile.name), "\n");
    each_felt([&](const PlayerSetting& setting) {
        toml += text(setting.key, " = ", written(setting, profile.felt), "\n");
    });
    toml += "\n[body]\n";
    for (std::size_t i = 0; i < tactile::purpose_count; ++i)
        toml += text(tactile::purpose_names()[i], " = ", profile.felt.body.values.at(i), "\n");
    toml += "\n[cauldron]\n";
    for (std::size_t i = 0; i < profile.cauldron.size(); ++i)
        toml += text(haptics::fluid_modes.at(i).name, " = ", profile.cauldron.at(i).share, "\n");
    return toml + text("off = ", in_quotes(off_words(profile.cauldron)), "\n");
}

Expected<FeelProfile> parse_feel_profile(std::string_view toml, const std::string& file) {
    const auto config = Config::parse(toml, file, 1);
    if (!config) return config.error();
    const auto root = config->root();
    FeelProfile profile;
    auto name = player_name(root.string("name"));
    if (name && !name->empty())
        profile.name = std::move(*name);
    else
        root.report("name", text("'name': ", name ? "it is empty" : name.error().message));
    each_felt([&](const PlayerSetting& setting) { read(root, setting, profile.felt); });
    profile.felt.body = read_body_faders(root.table("body"), profile.felt.body);
    profile.cauldron = read_faders(root.table("cauldron"), profile.cauldron);
    if (const auto checked = config->check(); !checked) return checked.error();
    return profile;
}

std::vector<FeelProfile> load_feel_profiles(const std::filesystem::path& folder,
                                            std::vector<std::string>& faults) {
    std::vector<FeelProfile> profiles;
    std::error_code error;
    for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end;
         it.increment(error)) {
        if (it->path().extension() != ending || profiles.size() >= max_profiles) continue;
        const auto source = read_own_text_file(it->path(), max_file);
        auto profile =
            source ? parse_feel_profile(*source, it->path().string()) : Expected<FeelProfile>(source.error());
        if (profile)
            profiles.push_back(std::move(*profile));
        else if (faults.size() < max_faults)
            faults.push_back(profile.error().message);
    }
    std::sort(profiles.begin(), profiles.end(),
              [](const FeelProfile& a, const FeelProfile& b) { return a.name < b.name; });
    return profiles;
}

Expected<void> save_feel_profile(const std::filesystem::path& folder, const FeelProfile& profile) {
    if (folder.empty()) return fail("there is no home folder to save it in");
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    return write_text_file(folder / (file_name_of(profile.name) + std::string(ending)), written(profile));
}

}  // namespace thaum::game::inline settings
