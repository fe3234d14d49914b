// Settings and the names of logs.
#include "game/app/settings.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/file.h"
#include "core/text.h"
#include "input/log.h"
#include "render/context.h"

namespace thaum::app {
namespace {

const std::filesystem::path assets = THAUM_SOURCE_DIR "/assets";

std::filesystem::path fresh_folder(const std::string& name) {
    auto folder = std::filesystem::path(testing::TempDir()) / ("thaum_" + name);
    std::filesystem::remove_all(folder);
    return folder;
}

std::string refusal(const std::string& lines) {
    const auto settings = parse_settings("version = 1\n" + lines, "settings.toml");
    return settings ? "" : settings.error().message;
}

TEST(Settings, TheDocumentedFileSaysWhatTheDefaultsAre) {
    const auto source = read_text_file(assets / "settings.toml", 1U << 20U);
    ASSERT_TRUE(source);
    const auto read = parse_settings(*source, "settings.toml");
    ASSERT_TRUE(read) << read.error().message;
    const Settings defaults;
    EXPECT_EQ(read->split, defaults.split);
    EXPECT_EQ(read->fullscreen, defaults.fullscreen);
    EXPECT_EQ(read->fov, defaults.fov);
    EXPECT_EQ(read->text_scale, defaults.text_scale);
    EXPECT_EQ(read->quality, defaults.quality);
    EXPECT_EQ(read->bloom, defaults.bloom);
    EXPECT_EQ(read->frames_per_second, defaults.frames_per_second);
    EXPECT_EQ(read->sensitivity, defaults.sensitivity);
    EXPECT_EQ(read->turn_deg_per_s, defaults.turn_deg_per_s);
    EXPECT_EQ(read->invert_y, defaults.invert_y);
    EXPECT_EQ(read->logs_kept, defaults.logs_kept);
    for (std::size_t kind = 0; kind < input::device_kinds; ++kind) {
        EXPECT_EQ(read->bindings[kind].controls, defaults.bindings[kind].controls)
            << input::name_of(static_cast<input::DeviceKind>(kind));
        EXPECT_EQ(read->bindings[kind].stick_dead_zone, defaults.bindings[kind].stick_dead_zone);
        EXPECT_EQ(read->bindings[kind].trigger_press, defaults.bindings[kind].trigger_press);
    }
}

TEST(Settings, EveryKeyOfTheDefaultBindingsIsKnown) {
    for (const auto& name : input::default_key_names()) EXPECT_TRUE(key_code_of(name)) << name;
    EXPECT_FALSE(key_code_of("no_such_key"));
}

TEST(Settings, FaultsNameFileLineAndKey) {
    EXPECT_EQ(refusal(""), "");
    EXPECT_EQ(refusal("colour = 1"), "settings.toml:2: unknown key 'colour'");
    for (const auto* line : {"fov_deg = 5", "text_scale = 9.0", "logs_kept = 0", "split = \"diagonal\"",
                             "quality = \"ultra\"", "bloom = 1"}) {
        const auto message = refusal(line);
        const std::string key(line, std::string_view(line).find(' '));
        EXPECT_TRUE(message.starts_with("settings.toml:2:")) << message;
        EXPECT_NE(message.find(key), std::string::npos) << message;
    }
    EXPECT_NE(refusal("[pad]\nfire = \"pad nothing\"").find("settings.toml:3"), std::string::npos);
    EXPECT_NE(refusal("[keyboard_mouse]\nfly = \"key a\"").find("fly"), std::string::npos);
}

TEST(Settings, ChangedValuesAndBindingsAreRead) {
    const auto s = parse_settings(
        "version = 1\nquality = \"medium\"\nbloom = false\nsplit = \"side_by_side\"\nsensitivity = "
        "2.5\ninvert_y = true\n"
        "[keyboard_mouse]\nfire = \"key x\"\n",
        "settings.toml");
    ASSERT_TRUE(s) << s.error().message;
    EXPECT_EQ(s->split, render::Split::side_by_side);
    EXPECT_EQ(s->quality, render::Quality::medium);
    EXPECT_FALSE(s->bloom);
    EXPECT_EQ(s->sensitivity, 2.5);
    EXPECT_TRUE(s->invert_y);
    const auto& fire = s->bindings_of(input::DeviceKind::keyboard_mouse)
                           .controls[static_cast<std::size_t>(input::Action::fire)];
    ASSERT_EQ(fire.size(), 1U);
    EXPECT_EQ(fire[0].code, *render::key_code("x"));
}

TEST(Settings, AMissingFileIsMadeAndAnExistingOneIsLeftAlone) {
    const auto file = fresh_folder("settings") / "deep" / "settings.toml";
    ASSERT_TRUE(load_settings(file, assets));
    EXPECT_EQ(*read_text_file(file, 1U << 20U), *read_text_file(assets / "settings.toml", 1U << 20U));
    const std::string own = "version = 1\nfov_deg = 100\n";
    ASSERT_TRUE(write_text_file(file, own));
    const auto read = load_settings(file, assets);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->fov, 100);
    EXPECT_EQ(*read_text_file(file, 1U << 20U), own);
}

TEST(MatchLogs, NamesAreNewAndOnlyTheOldestOfThemAreDeleted) {
    const auto folder = fresh_folder("matches");
    std::filesystem::create_directories(folder);
    const auto touch = [](const std::filesystem::path& p) { std::ofstream(p) << "x"; };
    for (int i = 10; i < 20; ++i) touch(folder / text("2001-01-", i, "_00-00-00_01.thaumlog"));
    touch(folder / "mine.thaumlog");
    const auto first = new_match_log(folder, 5);
    ASSERT_TRUE(first);
    touch(*first);
    EXPECT_FALSE(std::filesystem::exists(folder / "2001-01-15_00-00-00_01.thaumlog"));
    EXPECT_TRUE(std::filesystem::exists(folder / "2001-01-16_00-00-00_01.thaumlog"));
    EXPECT_TRUE(std::filesystem::exists(folder / "mine.thaumlog"));
    const auto second = new_match_log(folder, 50);
    ASSERT_TRUE(second);
    EXPECT_NE(*first, *second);
}

TEST(MatchLogs, RematchesAreCountedAfterTheirMatchAndALogInUseStays) {
    const auto folder = fresh_folder("matches_in_use");
    std::filesystem::create_directories(folder);
    const auto name = [&](std::string_view rest) {
        return folder / text("2001-01-01_00-00-00_", rest, ".thaumlog");
    };
    const auto in_use = input::LogWriter::create(name("01"), {}).value();
    for (const auto* rest : {"01-2", "01-10", "02"}) std::ofstream(name(rest)) << "x";
    std::ofstream(name("01-x")) << "x";
    EXPECT_TRUE(input::log_in_use(name("01")));
    EXPECT_FALSE(input::log_in_use(name("02")));
    ASSERT_TRUE(new_match_log(folder, 3));  // of four two may stay
    EXPECT_TRUE(std::filesystem::exists(name("01"))) << "the oldest, but in use";
    EXPECT_FALSE(std::filesystem::exists(name("01-2")));
    EXPECT_TRUE(std::filesystem::exists(name("01-10")));
    EXPECT_TRUE(std::filesystem::exists(name("02")));
    EXPECT_TRUE(std::filesystem::exists(name("01-x"))) << "not a name of ours";
}

}  // namespace
}  // namespace thaum::app
