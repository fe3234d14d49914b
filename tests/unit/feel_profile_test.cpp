// Tests of profiles of haptic settings: their files, and which settings count as the same.
#include "game/settings/feel_profile.h"

#include <gtest/gtest.h>

#include "core/file.h"
#include "unit/live_rig.h"

namespace thaum::game {
namespace {

/// A profile of haptic settings in which every value differs from its default.
FeelProfile unlike_defaults(std::string name) {
    FeelProfile profile{.name = std::move(name)};
    for (const auto& setting : player_settings()) {
        if (setting.page != SettingPage::mixer) continue;
        const auto before = written(setting, profile.felt);
        change(setting, profile.felt, 1);
        if (written(setting, profile.felt) == before) change(setting, profile.felt, -1);
        EXPECT_NE(written(setting, profile.felt), before) << setting.key;
    }
    for (std::size_t i = 0; i < profile.felt.body.values.size(); ++i)
        profile.felt.body.values.at(i) = 0.05 * static_cast<double>(i + 1);
    for (std::size_t i = 0; i < profile.cauldron.size(); ++i)
        profile.cauldron.at(i) = {0.1 * static_cast<double>(i), i % 2 == 0};
    return profile;
}

TEST(FeelProfile, ItsFileHoldsEveryValue) {
    for (const auto* name : {"Zoë", "a \"q\" \\ name", "x"}) {
        const auto profile = unlike_defaults(name);
        const auto read = parse_feel_profile(written(profile), "p.toml").value();
        EXPECT_EQ(read.name, name);
        EXPECT_TRUE(feels_alike(read, profile));
    }
}

TEST(FeelProfile, IsGivenToOnePlayerAndTakenFromOne) {
    Settings settings;
    settings.players[1].name = "Zoë";
    settings.players[1].sensitivity = 3;
    const auto profile = unlike_defaults("x");
    use(profile, settings, 1);
    EXPECT_TRUE(feels_alike(feel_of(settings, 1), profile));
    EXPECT_TRUE(feels_alike(feel_of(settings, 0), feel_presets()[0])) << "gentle is the default";
    EXPECT_EQ(settings.players[1].name, "Zoë");
    EXPECT_EQ(settings.players[1].sensitivity, 3);
    use(feel_presets()[0], settings, 1);
    settings.players[1].name.clear();
    settings.players[1].sensitivity = 1;
    EXPECT_EQ(settings, Settings{});
}

TEST(FeelProfile, AFaultNamesFileAndKey) {
    const auto refused = [](const char* toml) {
        const auto read = parse_feel_profile(toml, "p.toml");
        EXPECT_FALSE(read) << toml;
        return read ? std::string() : read.error().message;
    };
    EXPECT_NE(refused("version = 1\nname = \"a\"\nrecoil = 2\n").find("p.toml:3"), std::string::npos);
    EXPECT_NE(refused("version = 1\nname = \"\"\n").find("name"), std::string::npos);
    EXPECT_NE(refused("version = 1\n").find("name"), std::string::npos);
    EXPECT_NE(refused("version = 1\nname = \"a\"\n[body]\nhead = 1\n").find("head"), std::string::npos);
    refused("version = 2\nname = \"a\"\n");
    refused("[[[");
}

TEST(FeelProfile, AFolderKeepsOneFileForEachName) {
    const rig::TestPath folder("feel");
    std::vector<std::string> faults;
    EXPECT_TRUE(load_feel_profiles(folder.path, faults).empty()) << "there is no folder yet";
    EXPECT_TRUE(faults.empty());
    for (const auto* name : {"b", "A", "a", "ä", "ö", "../up", "b"})
        ASSERT_TRUE(save_feel_profile(folder.path, unlike_defaults(name)));
    ASSERT_TRUE(write_text_file(folder.path / "broken.toml", "version = 1\nrecoil = 7\n"));
    const auto profiles = load_feel_profiles(folder.path, faults);
    std::vector<std::string> names;
    for (const auto& profile : profiles) names.push_back(profile.name);
    EXPECT_EQ(names, (std::vector<std::string>{"../up", "A", "a", "b", "ä", "ö"}));
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_NE(faults[0].find("broken.toml"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder.path.parent_path() / "up.toml"));
    EXPECT_FALSE(save_feel_profile({}, unlike_defaults("x"))) << "no folder";
    EXPECT_FALSE(save_feel_profile(folder.path / "broken.toml" / "x", unlike_defaults("x")))
        << "no such place";
}

}  // namespace
}  // namespace thaum::game
