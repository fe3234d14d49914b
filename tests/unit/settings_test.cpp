// Tests of the settings file and of the names of logs.
#include "game/settings/settings.h"
#include "core/utf8.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "core/file.h"
#include "core/text.h"
#include "game/settings/player_name.h"
#include "input/log.h"
#include "render/context.h"
#include "render/font.h"
#include "unit/message_of.h"

namespace thaum::game {
namespace {

const std::filesystem::path assets = THAUM_SOURCE_DIR "/assets";

std::filesystem::path fresh_folder(const std::string& name) {
    auto folder = std::filesystem::path(testing::TempDir()) / ("thaum_" + name);
    std::filesystem::remove_all(folder);
    return folder;
}

std::string refusal(const std::string& lines) {
    return message_of(parse_settings("version = 1\n" + lines, "settings.toml"));
}

TEST(Settings, TheDocumentedFileHoldsTheDefaults) {
    const auto source = read_text_file(assets / "settings.toml", 1U << 20U).value();
    const auto read = parse_settings(source, "settings.toml").value();
    const Settings defaults;
    EXPECT_EQ(changes(defaults, read), std::vector<SettingEdit>{});
    EXPECT_EQ(read, defaults);
}

TEST(Settings, EveryKeyOfTheDefaultBindingsIsKnown) {
    for (const auto& name : input::default_key_names()) EXPECT_TRUE(key_code_of(name)) << name;
    EXPECT_FALSE(key_code_of("no_such_key"));
    const Settings defaults;
    for (std::size_t i = 0; i < session_keys; ++i) EXPECT_FALSE(defaults.session[i].empty()) << i;
}

TEST(Settings, EveryKeyHasANameThatIsReadBack) {
    int keys = 0;
    for (int code = 0; code < 512; ++code) {
        const auto name = key_name_of(code);
        if (name.empty()) continue;
        ++keys;
        EXPECT_EQ(key_code_of(name), code) << name;
        EXPECT_EQ(name.find_first_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ \""), std::string::npos) << name;
    }
    EXPECT_GT(keys, 100);
    EXPECT_EQ(key_name_of(*key_code_of("left_alt")), "left_alt");
    EXPECT_EQ(key_name_of(*key_code_of("kp_add")), "kp_add");
    EXPECT_EQ(key_name_of(*key_code_of("escape")), "escape");
}

TEST(Settings, FaultsNameFileLineAndKey) {
    EXPECT_EQ(refusal(""), "");
    EXPECT_EQ(refusal("colour = 1"), "settings.toml:2: unknown key 'colour'");
    for (const auto* line : {"fov_deg = 5", "text_scale = 9.0", "text_scale = 0.9", "logs_kept = 0",
                             "split = \"diagonal\"", "quality = \"ultra\"", "bloom = 1", "cauldron_1 = 1"}) {
        const auto message = refusal(line);
        const std::string key(line, std::string_view(line).find(' '));
        EXPECT_TRUE(message.starts_with("settings.toml:2:")) << message;
        EXPECT_NE(message.find(key), std::string::npos) << message;
    }
    EXPECT_NE(refusal("[pad]\nfire = \"pad nothing\"").find("settings.toml:3"), std::string::npos);
    for (const auto* line :
         {"flow = 1.01", "flow = -0.1", "flow = nan", "flow = inf", "flow = \"all\"", "flow = true",
          "recoil = 1e300", "off = \"flow, wind\"", "off = \"flow,, wall\"", "off = 0", "taste = 1"}) {
        const auto message = refusal(text("[cauldron_2]\n", line));
        EXPECT_TRUE(message.starts_with("settings.toml:3:")) << line << ": " << message;
    }
    EXPECT_NE(refusal("[cauldron_3]\nflow = 1.0"), "");
    EXPECT_NE(refusal("[keyboard_mouse]\nfly = \"key a\"").find("fly"), std::string::npos);
}

TEST(Settings, ChangedValuesAndBindingsAreRead) {
    const auto s =
        parse_settings(
            "version = 1\nquality = \"medium\"\nbloom = false\nsplit = \"side_by_side\"\nsensitivity = "
            "2.5\ninvert_y = true\n"
            "[keyboard_mouse]\nfire = \"key x\"\n",
            "settings.toml")
            .value();
    EXPECT_EQ(s.split, render::Split::side_by_side);
    EXPECT_EQ(s.quality, render::Quality::medium);
    EXPECT_FALSE(s.bloom);
    for (const auto& player : s.players) {
        EXPECT_EQ(player.sensitivity, 2.5) << "a value at the top counts for both players";
        EXPECT_TRUE(player.invert_y);
    }
    const auto& fire = s.bindings_of(input::DeviceKind::keyboard_mouse)
                           .controls[static_cast<std::size_t>(input::Action::fire)];
    ASSERT_EQ(fire.size(), 1U);
    EXPECT_EQ(fire[0].code, *render::key_code("x"));
}

TEST(Settings, EachPlayerHasFadersAndSwitchingOffKeepsTheirValues) {
    const auto s = parse_settings(
                       "version = 1\n[cauldron_1]\nflow = 0.4\nwall = 0\noff = \" flow "
                       ",recoil\"\n[cauldron_2]\nviscosity = "
                       "1\n",
                       "s")
                       .value();
    Faders wanted;
    wanted[1] = {.share = 0.4, .on = false};
    wanted[4].share = 0;
    wanted[6].on = false;
    EXPECT_EQ(s.cauldron[0], wanted);
    EXPECT_EQ(s.cauldron[1], Faders{});
    EXPECT_EQ(off_words(wanted), "flow, recoil");
    input::DeviceSpec device;
    ask_for(wanted, device);
    EXPECT_EQ(device.fluid_reduction, (std::array<std::uint8_t, 7>{0, 100, 0, 0, 100, 0, 100}));
    ask_for(s.cauldron[1], device);
    EXPECT_EQ(device.fluid_reduction, (std::array<std::uint8_t, 7>{}));
}

TEST(Settings, AMissingFileIsMadeAndAnExistingOneIsLeftAlone) {
    const auto file = fresh_folder("settings") / "deep" / "settings.toml";
    ASSERT_TRUE(load_settings(file, assets));
    EXPECT_EQ(*read_text_file(file, 1U << 20U), *read_text_file(assets / "settings.toml", 1U << 20U));
    const std::string own = "version = 1\nfov_deg = 100\n";
    ASSERT_TRUE(write_text_file(file, own));
    const auto read = load_settings(file, assets).value();
    EXPECT_EQ(read.fov, 100);
    EXPECT_EQ(*read_text_file(file, 1U << 20U), own);
}

TEST(Settings, EachPlayerHasATableAndOldFilesHaveTheValuesAtTheTop) {
    const auto s = parse_settings(
        "version = 1\nsensitivity = 2\nforce_1 = \"soft\"\nforce_2 = \"full\"\nprompts = \"never\"\n"
        "[player_2]\nname = \"  Ann \"\nsensitivity = 3\nforce = \"off\"\ncaptions = false\n",
        "s");
    ASSERT_TRUE(s) << s.error().message;
    EXPECT_EQ(s->players[0],
              (PlayerSettings{.sensitivity = 2, .force = 1, .prompts = game::PromptWish::never}));
    EXPECT_EQ(s->players[1], (PlayerSettings{.name = "Ann",
                                             .captions = false,
                                             .sensitivity = 3,
                                             .force = 0,
                                             .prompts = game::PromptWish::never}));
    // The value for both players stands above in the file. After a change of one player's own value, it must
    // still apply to the other player.
    auto wanted = *s;
    wanted.players[1].sensitivity = 1;
    const std::string old = "version = 1\nsensitivity = 2\n";
    const auto edited = edit_settings(old, "s", {{"player_2", "sensitivity", "1"}}).value();
    EXPECT_EQ(edited, old + "\n[player_2]\nsensitivity = 1\n");
    EXPECT_EQ(parse_settings(edited, "s")->players[0].sensitivity, 2);
}

TEST(Settings, ABotIsRememberedByNameAndOldFilesHaveItsLevel) {
    EXPECT_EQ(parse_settings("version = 1\nbot_level = 2\n", "old").value().last.bot, "level_2");
    EXPECT_EQ(parse_settings("version = 1\nbot_level = 2\nbot = \"rival\"\n", "new").value().last.bot,
              "rival");
    EXPECT_EQ(parse_settings("version = 1\nmutators = \" fog,low_gravity, \"\n", "new").value().last.mutators,
              (std::vector<std::string>{"fog", "low_gravity"}));
}

TEST(Settings, EachPlayerHasSticksAndOldFilesHaveOneDeadZoneForBoth) {
    const auto own = parse_settings(
        "version = 1\n[player_1]\nstick_dead_zone = 0.05\nstick_curve = 0\n"
        "[player_2]\nstick_dead_zone = 0.9\nstick_curve = 1\n",
        "s");
    ASSERT_TRUE(own) << own.error().message;
    EXPECT_EQ(own->players[0], (PlayerSettings{.stick_dead_zone = 0.05, .stick_curve = 0}));
    EXPECT_EQ(own->players[1], (PlayerSettings{.stick_dead_zone = 0.9, .stick_curve = 1}));
    const std::string old = "version = 1\n[pad]\nfire = \"pad b\"\nstick_dead_zone = 0.3 # worn\n";
    const auto former = parse_settings(old, "s").value();
    for (const auto& player : former.players) EXPECT_EQ(player, PlayerSettings{.stick_dead_zone = 0.3});
    // The value for all pads applies to both players. If one player gets another value, that of the other
    // player must stay the same.
    auto wanted = former;
    wanted.players[1].stick_dead_zone = PlayerSettings{}.stick_dead_zone;
    const auto edited = edit_settings(old, "s", changes(former, wanted)).value();
    EXPECT_EQ(edited, old + "\n[player_2]\nstick_dead_zone = 0.15\n");
    EXPECT_EQ(parse_settings(edited, "s").value(), wanted);
    EXPECT_EQ(parse_settings("version = 1\n[keyboard_half]\nstick_dead_zone = 0.3\n", "s").value(),
              Settings{})
        << "a line that old files may have, and that means nothing: keys have no dead zone";
}

TEST(Settings, SticksOutOfRangeAreRefused) {
    for (const auto* table : {"player_1", "player_2"}) {
        for (const auto* line : {"stick_dead_zone = 0.91", "stick_dead_zone = -0.01", "stick_dead_zone = nan",
                                 "stick_dead_zone = \"none\"", "stick_curve = 1.01", "stick_curve = -0.1",
                                 "stick_curve = inf", "stick_curve = \"linear\""}) {
            const auto message = refusal(text("[", table, "]\n", line));
            const std::string key(line, std::string_view(line).find(' '));
            EXPECT_TRUE(message.starts_with("settings.toml:3:")) << line << ": " << message;
            EXPECT_NE(message.find(key), std::string::npos) << message;
        }
    }
    EXPECT_TRUE(refusal("[pad]\nstick_dead_zone = 0.91").starts_with("settings.toml:3:"));
    EXPECT_NE(refusal("[pad]\nstick_curve = 0.5").find("stick_curve"), std::string::npos);
}

std::string name_line(std::string_view name) { return text("[player_1]\nname = \"", name, '"'); }

TEST(Settings, ANameHasUpToSixteenCharactersThatCanBeShown) {
    for (const auto* good : {"", "A", "Zoë", "0123456789abcdef", "ΣΟΦΙΑ", "Жук 7", "Łukasz-Ø_{by}"}) {
        const auto s = parse_settings(text("version = 1\n", name_line(good)), "s").value();
        EXPECT_EQ(s.players[0].name, good);
    }
    const std::string many(10'000, 'x');
    EXPECT_EQ(refusal(name_line(many)),
              "settings.toml:3: 'name': a name has at most 16 characters, not 10000");
    EXPECT_EQ(refusal(name_line("0123456789abcdefg")),
              "settings.toml:3: 'name': a name has at most 16 characters, not 17");
    const std::string odd =
        "settings.toml:3: 'name': character 2 cannot be shown; use Latin, Greek or Cyrillic letters, digits "
        "and "
        "signs";
    // Control characters, Hebrew, Arabic, a combining mark, a mark for writing from right to left, an emoji,
    // a character without width, and a soft hyphen.
    for (const auto* bad : {"a\\u0000", "a\\u0007", "a\\n", "a\\u007F", "aא", "aش", "a\\u0301", "a\\u202E",
                            "a😀", "a\\u200B", "a\\u00AD"})
        EXPECT_EQ(refusal(name_line(bad)), odd) << bad;
    for (const auto* bytes : {"a\xFF", "a\xC3", "\xE2\x82", "a\x07"})
        EXPECT_TRUE(refusal(name_line(bytes)).starts_with("settings.toml:3")) << refusal(name_line(bytes));
    EXPECT_NE(refusal("[player_1]\nname = 7"), "");
}

TEST(Settings, EveryCharacterOfANameHasAGlyph) {
    auto font = render::Font::load();
    if (!font) GTEST_SKIP() << font.error().message;
    const auto none = font->glyph(0x10FFFF, 40).coverage;
    int fitting = 0;
    for (char32_t c = 1; c < 0x3000; ++c) {
        if (!fits_name(c)) continue;
        ++fitting;
        EXPECT_NE(font->glyph(c, 40).coverage, none) << static_cast<std::uint32_t>(c);
    }
    EXPECT_GT(fitting, 900);
}

TEST(Settings, ATypedNameGrowsAndShrinksByCharacters) {
    std::string name;
    for (const char32_t c : std::u32string(U" Zo\u00EB\n \u05D0x")) name = with_character(name, c);
    EXPECT_EQ(name, "Zoë x");
    for (int i = 0; i < 30; ++i) name = with_character(name, U'\u0416');
    EXPECT_EQ(decode_utf8(name).size(), longest_name);
    EXPECT_TRUE(player_name(name));
    for (std::size_t i = 0; i < longest_name; ++i) name = without_last(name);
    EXPECT_EQ(without_last(name), "");
}

// ---- writing changed settings -----------------------------------------------------------------------------

template <class Of>
void change_all(std::span<const SettingOf<Of>> settings, Of& values) {
    for (const auto& setting : settings) {
        const auto before = written(setting, values);
        change(setting, values, 1);
        if (written(setting, values) == before) change(setting, values, -1);
    }
}

/// Settings in which every value differs from its default.
Settings all_different() {
    Settings s;
    change_all(all_settings(), s);
    for (auto& player : s.players) change_all(player_settings(), player);
    s.players[0].name = "Zoë \"\\\" # ]";
    s.players[1].name = "Two";
    s.players[0].jacket = "osc:vest.local:1027";
    s.players[1].jacket = "osc16:[fe80::1%eth0]:1";
    s.last = {
        .bot = "level_3", .match = "standard", .arena = "the \"well\"", .mutators = {"fog", "low_gravity"}};
    for (std::size_t p = 0; p < s.cauldron.size(); ++p) {
        for (std::size_t i = 0; i < s.cauldron[p].size(); ++i)
            s.cauldron[p][i] = {.share = static_cast<double>(i + p) / 20, .on = (i + p) % 2 == 0};
    }
    for (const auto kind : settings_hands) {
        auto& b = s.bindings_of(kind);
        // Each action gets the controls of the next action.
        std::rotate(b.controls.begin(), b.controls.begin() + 1, b.controls.end());
        b.controls[3].push_back({input::Control::Source::key, *render::key_code("F9"), 0});
        for (const auto action : input::toggle_actions) b.toggled[static_cast<std::size_t>(action)] = true;
        b.trigger_press = 0.5;
    }
    std::rotate(s.session.begin(), s.session.begin() + 1, s.session.end());
    return s;
}

std::string documented() { return read_text_file(assets / "settings.toml", 1U << 20U).value(); }

TEST(SettingsWriter, EveryValueIsReadBackAsItWasWritten) {
    const auto wanted = all_different();
    for (const auto& source : {documented(), std::string("version = 1\n"), std::string("version = 1")}) {
        const auto edited = edit_settings(source, "settings.toml", changes({}, wanted)).value();
        const auto read = parse_settings(edited, "settings.toml").value();
        EXPECT_EQ(changes(read, wanted), std::vector<SettingEdit>{});
        // Changing all values back restores the first text, because it already had a line for each value.
        const auto back = edit_settings(edited, "settings.toml", changes(wanted, {})).value();
        EXPECT_EQ(parse_settings(back, "settings.toml").value(), Settings{});
    }
}

TEST(SettingsWriter, CommentsAndOrderStay) {
    const std::string source =
        "# mine\nversion = 1\n\nfov_deg   = 100 # wide, as I like it\r\n"
        "split = 'top_bottom'      # for two\n"
        "[pad]  # ours\n# fire = \"pad b\"\n  jump = \"pad a\"   # not \"pad b\"\n\n# end\n";
    auto wanted = parse_settings(source, "s").value();
    wanted.fov = 75.5;
    wanted.split = render::Split::side_by_side;
    wanted.bindings_of(input::DeviceKind::pad).of(input::Action::jump) = {
        {input::Control::Source::pad_axis, 1, -1}};
    wanted.bindings_of(input::DeviceKind::pad).of(input::Action::fire) = {};
    const auto edited =
        edit_settings(source, "s", changes(parse_settings(source, "s").value(), wanted)).value();
    EXPECT_EQ(edited,
              "# mine\nversion = 1\n\nfov_deg   = 75.5 # wide, as I like it\r\n"
              "split = \"side_by_side\"    # for two\n"
              "[pad]  # ours\n# fire = \"pad b\"\n  jump = \"pad left_y -\" # not \"pad b\"\n"
              "fire = \"\"\n\n# end\n");
}

TEST(SettingsWriter, FilesThatCannotBeEditedLineByLineAreRefused) {
    for (const auto* source : {
             "version = 1\nfov_deg = \"\"\"\n90\"\"\"\n",
             "version = 1\npad = { fire = \"pad b\" }\n",
             "version = 1\npad.fire = \"pad b\"\n",
             "version = 2\n",
             "version = ",
             "",
             "fov_deg = 90\n",
             "version = 1\n[pad]\n\"fire\" = \"pad b\"\n",
         }) {
        auto wanted = Settings{};
        wanted.fov = 100;
        wanted.bindings_of(input::DeviceKind::pad).of(input::Action::fire) = {};
        const auto edited = edit_settings(source, "s", changes({}, wanted));
        EXPECT_FALSE(edited) << source << "->" << *edited;
        if (!edited) {
            EXPECT_EQ(edited.error().message.find('\n'), std::string::npos);
        }
    }
}

TEST(SettingsWriter, AFileThatCannotBeReadIsKept) {
    const auto file = fresh_folder("kept") / "settings.toml";
    std::filesystem::create_directories(file.parent_path());
    auto wanted = Settings{};
    wanted.fov = 100;
    for (const auto* source : {"version = 2\nnew_key = 7\n", "version = 1\nfov_deg = \n", "what is this"}) {
        ASSERT_TRUE(write_text_file(file, source));
        testing::internal::CaptureStderr();
        const auto [settings, fault] = settings_to_play_with(file, assets);
        EXPECT_EQ(settings, Settings{});
        EXPECT_TRUE(fault.starts_with("settings.toml") && fault.ends_with("; the defaults hold")) << fault;
        const auto said = testing::internal::GetCapturedStderr();
        EXPECT_NE(said.find("kept as it is"), std::string::npos) << said;
        EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
        EXPECT_FALSE(save_changes(file, {}, wanted));
        EXPECT_EQ(*read_text_file(file, 1U << 20U), source);
    }
    EXPECT_FALSE(save_changes(file.parent_path(), {}, wanted));
    EXPECT_FALSE(save_changes(file.parent_path() / "none", {}, wanted));
}

TEST(SettingsWriter, ALinkStaysALink) {
    const auto folder = fresh_folder("link");
    std::filesystem::create_directories(folder);
    ASSERT_TRUE(write_text_file(folder / "real.toml", documented()));
    std::filesystem::create_symlink("real.toml", folder / "settings.toml");
    auto wanted = Settings{};
    wanted.players[1].invert_y = true;
    ASSERT_TRUE(save_changes(folder / "settings.toml", {}, wanted));
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "settings.toml"));
    EXPECT_TRUE(load_settings(folder / "real.toml", assets)->players[1].invert_y);
}

/// Bytes of the documented file are removed, doubled or changed. The editor must refuse the result, or change
/// exactly what was requested.
TEST(SettingsWriter, SpoiltFilesAreRefusedOrChangedAsAsked) {
    const auto good = documented();
    const auto wanted = all_different();
    std::uint32_t dice = 12345;
    const auto roll = [&](std::size_t n) {
        dice = dice * 1664525U + 1013904223U;
        return (dice >> 8U) % n;
    };
    int refused = 0, changed = 0;
    for (int round = 0; round < 300; ++round) {
        auto spoilt = good;
        for (std::size_t n = 1 + roll(3); n > 0; --n) {
            const auto at = roll(spoilt.size());
            switch (roll(4)) {
                case 0: spoilt.erase(at, 1 + roll(40)); break;
                case 1: spoilt.insert(at, spoilt.substr(roll(spoilt.size()), roll(60))); break;
                case 2: spoilt[at] = static_cast<char>(roll(256)); break;
                default: spoilt.insert(at, 1, "\n\"[]=#"[roll(6)]);
            }
        }
        const auto read = read_settings(spoilt, "s");
        const auto edited = edit_settings(spoilt, "s", changes(read ? read->settings : Settings{}, wanted));
        (edited ? changed : refused)++;
        if (!edited) continue;
        EXPECT_TRUE(read);
        EXPECT_EQ(changes(read_settings(*edited, "s").value().settings, wanted), std::vector<SettingEdit>{})
            << spoilt;
    }
    EXPECT_GT(refused, 20);
    EXPECT_GT(changed, 20);
}

TEST(SettingsScreen, StepsStayInRangeAndRound) {
    Settings s;
    const auto setting = [](std::string_view key) {
        for (const auto& one : all_settings()) {
            if (one.key == key) return one;
        }
        return Setting{};
    };
    PlayerSettings player;
    const auto& speed = *std::find_if(player_settings().begin(), player_settings().end(),
                                      [](const auto& one) { return one.key == "sensitivity"; });
    change(speed, player, -14);
    EXPECT_EQ(written(speed, player), "0.3");
    change(speed, player, -1000);
    EXPECT_EQ(player.sensitivity, 0.05);
    reset(speed, player);
    EXPECT_EQ(player, PlayerSettings{});
    change(setting("text_scale"), s, 1);
    EXPECT_EQ(shown(setting("text_scale"), s), "125 %");
    change(setting("text_scale"), s, 100);
    EXPECT_EQ(s.text_scale, 2.5);
    change(setting("split"), s, -1);
    EXPECT_EQ(s.split, render::Split::side_by_side);
    change(setting("split"), s, 1);
    EXPECT_EQ(s.split, render::Split::top_bottom);
    EXPECT_EQ(shown(setting("split"), s), "top bottom");
    change(setting("fullscreen"), s, 1);
    EXPECT_TRUE(s.fullscreen);
    for (const auto& one : all_settings()) {
        EXPECT_FALSE(one.label.empty());
        EXPECT_FALSE(shown(one, s).empty());
    }
}

TEST(SettingsScreen, AFaderMovesByFivesAndKeepsItsValueWhenSwitched) {
    Fader fader{.share = 0.5};
    change(fader, -1);
    EXPECT_EQ(text(fader.share), "0.45");
    EXPECT_EQ(shown(fader), "45 %");
    fader.on = false;
    EXPECT_EQ(shown(fader), "off (45 %)");
    change(fader, 100);
    EXPECT_EQ(fader, (Fader{.share = 1, .on = false}));
    change(fader, -100);
    EXPECT_EQ(fader.share, 0);
    for (int i = 1; i <= 20; ++i) {
        change(fader, 1);
        input::DeviceSpec device;
        ask_for({Fader{.share = fader.share}}, device);
        EXPECT_EQ(device.fluid_reduction[0], 100 - 5 * i);
    }
    EXPECT_EQ(shown({.share = 0.333}), "33.3 %");
    for (std::size_t i = 0; i < haptics::fluid_modes.size(); ++i) {
        EXPECT_FALSE(label_of_fader(i).empty());
        EXPECT_FALSE(effect_of_fader(i).empty());
    }
}

void make_file(const std::filesystem::path& path) { std::ofstream(path) << "x"; }

TEST(MatchLogs, NamesAreNumberedAndOnlyTheOldestOfThemAreDeleted) {
    const auto folder = fresh_folder("matches");
    std::filesystem::create_directories(folder);
    // File names of an earlier version contain no number; they count as older than all numbered ones.
    for (int i = 10; i < 20; ++i) make_file(folder / text("2001-01-", i, "_00-00-00_01.thaumlog"));
    for (const auto* other : {"mine.thaumlog", "000001_mine.thaumlog", "000001_2001-01-10_00-00-00.txt"})
        make_file(folder / other);
    const auto first = new_match_log(folder, 5).value();
    EXPECT_TRUE(first.filename().string().starts_with("000001_")) << first;
    make_file(first);
    EXPECT_FALSE(std::filesystem::exists(folder / "2001-01-15_00-00-00_01.thaumlog"));
    EXPECT_TRUE(std::filesystem::exists(folder / "2001-01-16_00-00-00_01.thaumlog"));
    for (const auto* other : {"mine.thaumlog", "000001_mine.thaumlog", "000001_2001-01-10_00-00-00.txt"})
        EXPECT_TRUE(std::filesystem::exists(folder / other)) << other;
    const auto second = new_match_log(folder, 50).value();
    EXPECT_TRUE(second.filename().string().starts_with("000002_")) << second;
}

/// The logs of the latest matches are kept, whatever dates the clock and the file system show.
TEST(MatchLogs, AWrongClockDeletesNoNewerLog) {
    const auto folder = fresh_folder("matches_of_wrong_clocks");
    std::filesystem::create_directories(folder);
    int number = 0;
    const auto played = [&](const char* date, int hours) {
        auto log = folder / text("0000", ++number < 10 ? "0" : "", number, "_", date, ".thaumlog");
        make_file(log);
        std::filesystem::last_write_time(
            log, std::filesystem::file_time_type::clock::now() + std::chrono::hours(hours));
        return log;
    };
    std::vector<std::filesystem::path> logs;
    for (int i = 0; i < 8; ++i) logs.push_back(played("2026-10-01_00-00-00", -1000));
    for (int i = 0; i < 3; ++i) logs.push_back(played("2040-11-23_00-00-00", 100'000));
    for (int i = 0; i < 3; ++i) logs.push_back(played("2000-01-01_00-00-00", -200'000));
    for (std::size_t match = 0; match < 6; ++match) {
        const auto log = new_match_log(folder, 8).value();
        make_file(logs.emplace_back(log));
        for (std::size_t i = 0; i < logs.size(); ++i)
            EXPECT_EQ(std::filesystem::exists(logs[i]), i + 8 >= logs.size())
                << logs[i] << " after " << match;
    }
}

TEST(Settings, AreShownWithTheirUnits) {
    const auto shown_as = [](std::string_view key) {
        const auto all = all_settings();
        const auto found =
            std::find_if(all.begin(), all.end(), [&](const auto& setting) { return setting.key == key; });
        return found == all.end() ? std::string() : shown(*found, Settings());
    };
    EXPECT_EQ(shown_as("countdown_s"), "3 s");
    EXPECT_EQ(shown_as("logs_kept"), text(Settings().logs_kept));
    EXPECT_EQ(shown_as("fov_deg"), text(Settings().fov, "\u00B0"));
}

/// Sets environment variables during one test.
class Environment {
public:
    Environment(std::initializer_list<std::pair<const char*, const char*>> values) {
        for (const auto& [name, value] : values) {
            const char* const old = std::getenv(name);
            before_.emplace_back(name, old != nullptr ? std::optional<std::string>(old) : std::nullopt);
            value != nullptr ? ::setenv(name, value, 1) : ::unsetenv(name);
        }
    }
    ~Environment() {
        for (const auto& [name, value] : before_)
            value ? ::setenv(name.c_str(), value->c_str(), 1) : ::unsetenv(name.c_str());
    }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

private:
    std::vector<std::pair<std::string, std::optional<std::string>>> before_;
};

TEST(MatchLogs, FoldersAreNeverRelativeToWhereTheProgramWasStarted) {
    for (const char* home : {static_cast<const char*>(nullptr), "", "relative", "."}) {
        for (const char* xdg : {static_cast<const char*>(nullptr), "", "relative", "./here"}) {
            const Environment here{{"HOME", home}, {"XDG_CONFIG_HOME", xdg}, {"XDG_DATA_HOME", xdg}};
            for (const auto& path : {settings_file(), matches_folder()})
                EXPECT_TRUE(path.empty() || path.is_absolute()) << path;
        }
    }
    const Environment here{{"HOME", "/abode/a"}, {"XDG_CONFIG_HOME", "relative"}, {"XDG_DATA_HOME", "/data"}};
    EXPECT_EQ(settings_file(), "/abode/a/.config/thaum/settings.toml");
    EXPECT_EQ(matches_folder(), "/data/thaum/matches");
}

TEST(MatchLogs, RematchesAreCountedAfterTheirMatchAndALogInUseStays) {
    const auto folder = fresh_folder("matches_in_use");
    std::filesystem::create_directories(folder);
    const auto name = [&](std::string_view remaining) {
        return folder / text("2001-01-01_00-00-00_", remaining, ".thaumlog");
    };
    const auto in_use = input::LogWriter::create(name("01"), {}).value();
    for (const auto* remaining : {"01-2", "01-10", "02"}) std::ofstream(name(remaining)) << "x";
    std::ofstream(name("01-x")) << "x";
    EXPECT_TRUE(input::log_in_use(name("01")));
    EXPECT_FALSE(input::log_in_use(name("02")));
    ASSERT_TRUE(new_match_log(folder, 3));  // two of the four logs may be kept
    EXPECT_TRUE(std::filesystem::exists(name("01"))) << "the oldest, but in use";
    EXPECT_FALSE(std::filesystem::exists(name("01-2")));
    EXPECT_TRUE(std::filesystem::exists(name("01-10")));
    EXPECT_TRUE(std::filesystem::exists(name("02")));
    EXPECT_TRUE(std::filesystem::exists(name("01-x"))) << "not a name of a recorded match";
}

}  // namespace
}  // namespace thaum::game
