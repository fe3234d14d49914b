// Tests of settings files with wrong values: the correct values are used, and the file is kept.
#include "core/file.h"
#include "game/settings/settings.h"
#include "unit/live_rig.h"

namespace thaum::game {
namespace {

/// A settings file with every kind of wrong value, then the settings that result from its correct values.
constexpr const char* partly_wrong = R"(version = 1
fov_deg = 500
text_scale = 2.0
bloom = 1
logs_kept = "all"
quality = "low"
future = 3
bot_level = 99
match = 7
arena = "the_well"
cauldron_1 = 5
[player_1]
name = "0123456789abcdefg"
invert_y = true
prompts = "sometimes"
[player_2]
name = "Ada"
sensitivity = nan
[cauldron_2]
flow = 2
wall = 0.5
off = "flow, wind"
[keyboard_mouse]
fire = "mouse of_mine"
jump = 3
stir = "key r"
toggle = "stir, jump"
[pad]
trigger_press = 3
toggle = 1
fire = "pad b"
[session]
split = "mouse left"
pause = 5
leave = "key l"
)";

Settings good_part() {
    Settings s;
    s.text_scale = 2;
    s.quality = render::Quality::low;
    s.last.arena = "the_well";
    s.players[0].invert_y = true;
    s.players[1].name = "Ada";
    constexpr std::size_t wall = 4;
    s.cauldron[1][wall].share = 0.5;
    const auto put = [](input::Bindings& bindings, input::Action action, std::string_view control) {
        bindings.of(action) = input::parse_controls(control, key_code_of).value();
    };
    put(s.bindings_of(input::DeviceKind::keyboard_mouse), input::Action::stir, "key r");
    put(s.bindings_of(input::DeviceKind::pad), input::Action::fire, "pad b");
    s.session[static_cast<std::size_t>(SessionKey::leave)] =
        input::parse_controls("key l", key_code_of).value();
    return s;
}

TEST(Settings, AWrongValueCostsNoOther) {
    const auto read = read_settings(partly_wrong, "settings.toml").value();
    EXPECT_EQ(changes(good_part(), read.settings), std::vector<SettingEdit>{});
    EXPECT_EQ(changes(read.settings, good_part()), std::vector<SettingEdit>{});
    EXPECT_EQ(read.settings, good_part());
    EXPECT_EQ(read.fault->message, "settings.toml:2: 'fov_deg' is 500, must be from 60 to 130");
    EXPECT_FALSE(parse_settings(partly_wrong, "settings.toml"));
    EXPECT_FALSE(read_settings("version = 2\n", "s")) << "values of another version may mean something else";
    EXPECT_FALSE(read_settings("fov_deg = 100\n", "s"));
    EXPECT_FALSE(read_settings("version = 1\nversion = 1\n", "s"));
    const auto shipped = read_text_file(THAUM_SOURCE_DIR "/assets/settings.toml", 1U << 20U).value();
    EXPECT_FALSE(read_settings(shipped, "s")->fault);
}

TEST(SettingsWriter, AFileWithAWrongValueKeepsItUntilThePlayerChangesIt) {
    const rig::TestPath folder("partly_wrong");
    const std::filesystem::path assets = THAUM_SOURCE_DIR "/assets";
    const auto file = folder.path / "settings.toml";
    std::filesystem::create_directories(folder.path);
    const std::string source = "version = 1\nfov_deg = 100\n[player_1]\nname = \"0123456789abcdefg\"\n";
    ASSERT_TRUE(write_text_file(file, source));
    testing::internal::CaptureStderr();
    const auto [settings, fault] = settings_to_play_with(file, assets);
    const auto said = testing::internal::GetCapturedStderr();
    EXPECT_EQ(said, text(file.string(),
                         ":4: 'name': a name has at most 16 characters, not 17; it is kept as it is, ",
                         "and defaults replace wrong values\n"));
    EXPECT_EQ(fault,
              "settings.toml, line 4: 'name': a name has at most 16 characters, not 17; defaults replace "
              "wrong values");
    EXPECT_EQ(settings.fov, 100);
    EXPECT_EQ(settings.players[0].name, "");
    EXPECT_EQ(*read_text_file(file, 1U << 20U), source);
    auto wanted = settings;
    wanted.fov = 105;
    ASSERT_TRUE(save_changes(file, settings, wanted));
    EXPECT_EQ(*read_text_file(file, 1U << 20U),
              "version = 1\nfov_deg = 105\n[player_1]\nname = \"0123456789abcdefg\"\n");
    auto named = wanted;
    named.players[0].name = "Ada";
    ASSERT_TRUE(save_changes(file, wanted, named));
    EXPECT_EQ(load_settings(file, assets).value(), named);
}

}  // namespace
}  // namespace thaum::game
