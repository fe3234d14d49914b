// Tests of menus: events in, state and rows out, and the places where rows are drawn and clicked.
#include "game/app/menu.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/file.h"
#include "core/random.h"
#include "game/app/menu_choices.h"
#include "game/data/match_data.h"
#include "render/font.h"

namespace thaum::app {
namespace {

using input::Action;
using input::Control;
using input::DeviceKind;
using input::PadButton;
using Kind = MenuEvent::Kind;

constexpr Device keyboard{DeviceKind::keyboard_mouse, 0}, half{DeviceKind::keyboard_half, 0},
    first_pad{DeviceKind::pad, 0}, second_pad{DeviceKind::pad, 1};

const MenuContext& context() {
    static const MenuContext context{
        .levels = {1, 2, 3},
        .rules = {{"quick", "quick: first to 3"}, {"standard", "standard: first to 5"}},
        .arenas = {{"boiling_court", "Boiling Court"}},
        .pads = {"Make-believe pad", "Another pad", "", ""},
        .ends_match = true};
    return context;
}

MenuState with(MenuState s, Kind kind, const Device& device = keyboard) {
    return step(std::move(s), {.kind = kind, .device = device}, context());
}

MenuState start_page() { return opened({}, Page::start); }

std::size_t row_named(const MenuState& s, std::string_view label) {
    const auto rows = picture_of(s, context()).rows;
    const auto found =
        std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.label == label; });
    EXPECT_NE(found, rows.end()) << label;
    return static_cast<std::size_t>(found - rows.begin());
}

MenuState choose(MenuState s, std::string_view label, Kind kind = Kind::confirm) {
    const auto row = row_named(s, label);
    return step(std::move(s), {.kind = kind, .device = keyboard, .row = row}, context());
}

std::string value_of(const MenuState& s, std::string_view label) {
    return picture_of(s, context()).rows[row_named(s, label)].value;
}

MenuState bindings_of(std::string_view sheet) { return choose(choose(start_page(), "Controls"), sheet); }

Control key(std::string_view name) { return {Control::Source::key, *key_code_of(name), 0}; }
Control button(PadButton b) { return {Control::Source::pad_button, static_cast<int>(b), 0}; }

MenuState press(MenuState s, const Control& control) {
    return step(std::move(s), {.kind = Kind::control, .control = control}, context());
}

const std::vector<Control>& bound(const MenuState& s, DeviceKind kind, Action action) {
    return s.settings.bindings_of(kind).of(action);
}

// ---- joining ----------------------------------------------------------------------------------------------

TEST(StartScreen, TwoPressesOfAnyDeviceStart) {
    for (const auto& device : {keyboard, half, first_pad, second_pad}) {
        for (const auto kind : {Kind::confirm, Kind::other}) {
            auto s = with(start_page(), kind, device);
            EXPECT_EQ(s.request, MenuRequest::none);
            ASSERT_TRUE(s.seats[0]);
            EXPECT_EQ(*s.seats[0], device);
            EXPECT_FALSE(s.seats[1]);
            s = with(s, kind, device);
            EXPECT_EQ(s.request, MenuRequest::start);
        }
    }
}

TEST(StartScreen, TwoDevicesTakeTwoSeatsAndEitherStarts) {
    auto s = with(with(start_page(), Kind::other, first_pad), Kind::other, second_pad);
    EXPECT_EQ(s.request, MenuRequest::none);
    EXPECT_EQ(s.seats[0], first_pad);
    EXPECT_EQ(s.seats[1], second_pad);
    EXPECT_EQ(with(s, Kind::confirm, first_pad).request, MenuRequest::start);
    EXPECT_EQ(with(s, Kind::other, second_pad).request, MenuRequest::start);
    const auto third = with(s, Kind::other, keyboard);
    EXPECT_EQ(third.request, MenuRequest::none);
    EXPECT_EQ(third.seats, s.seats);
    EXPECT_FALSE(picture_of(third, context()).note.empty());
}

TEST(StartScreen, ASeatIsGivenUpByBackAndByUnplugging) {
    auto s = with(with(start_page(), Kind::other, first_pad), Kind::other, keyboard);
    s = with(s, Kind::back, keyboard);
    EXPECT_FALSE(s.seats[1]);
    s = with(s, Kind::gone, second_pad);
    EXPECT_EQ(s.seats[0], first_pad);
    s = with(s, Kind::gone, first_pad);
    EXPECT_FALSE(s.seats[0]);
    // A pad without a seat joins with any button, Back included. Back on a keyboard does not join.
    EXPECT_EQ(with(s, Kind::back, first_pad).seats[0], first_pad);
    s = with(s, Kind::back, keyboard);
    EXPECT_FALSE(s.seats[0]);
    EXPECT_EQ(with(s, Kind::confirm, keyboard).request, MenuRequest::quit);
}

TEST(StartScreen, ShowsSeatsLevelsAndRules) {
    auto p = picture_of(start_page(), context());
    EXPECT_EQ(p.line, "press to join");
    ASSERT_EQ(p.seats.size(), 2U);
    EXPECT_FALSE(p.seats[0].taken);
    auto s = with(start_page(), Kind::other, first_pad);
    p = picture_of(s, context());
    EXPECT_TRUE(p.seats[0].taken);
    EXPECT_NE(p.seats[0].device.find("Make-believe pad"), std::string::npos);
    EXPECT_NE(p.seats[1].device.find("level 1"), std::string::npos);
    s = choose(s, "Bot", Kind::left);
    EXPECT_EQ(value_of(s, "Bot"), "level 3");
    s = choose(s, "Bot", Kind::right);
    EXPECT_EQ(value_of(s, "Bot"), "level 1");
    s = choose(choose(s, "Bot"), "Match");
    EXPECT_EQ(s.level, 1U);
    EXPECT_EQ(value_of(s, "Match"), "standard: first to 5");
    EXPECT_EQ(s.request, MenuRequest::none);
}

/// The first arm goes to the player with the mouse, and the second one to the other player.
TEST(StartScreen, NamesTheRealArmsOfBothPlayers) {
    auto with_arms = context();
    with_arms.arms = {"Touch 1", "Touch 2 (gone)"};
    const auto joined = with(with(start_page(), Kind::confirm, first_pad), Kind::confirm, second_pad);
    EXPECT_EQ(picture_of(joined, with_arms).seats[0].device, "Pad 1 (Make-believe pad)");
    auto s = with(start_page(), Kind::confirm, first_pad);
    s.seats[1] = keyboard;
    const auto seats = picture_of(s, with_arms).seats;
    EXPECT_EQ(seats[0].device, "Pad 1 (Make-believe pad) and Touch 2 (gone)");
    EXPECT_EQ(seats[1].device, "Mouse, keys and Touch 1");
}

TEST(StartScreen, OnePressOnTheRangeStartsItForThatPlayer) {
    const auto s = choose(start_page(), "Range: practise on a dummy");
    EXPECT_EQ(s.request, MenuRequest::range);
    EXPECT_EQ(s.seats[0], keyboard);
    const auto row = row_named(start_page(), "Range: practise on a dummy");
    auto joined = with(with(start_page(), Kind::other, keyboard), Kind::other, first_pad);
    joined = step(joined, {.kind = Kind::confirm, .device = first_pad, .row = row}, context());
    EXPECT_EQ(joined.request, MenuRequest::range);
    EXPECT_EQ(joined.seats[0], first_pad) << "the pad must keep its seat";
    EXPECT_FALSE(joined.seats[1]);
}

TEST(StartScreen, OneSetOfRulesIsNoChoice) {
    auto few = context();
    few.rules.resize(1);
    for (const auto& row : picture_of(start_page(), few).rows) EXPECT_NE(row.label, "Match");
}

TEST(StartScreen, ChoosesTheArenaOfTheNextMatch) {
    for (const auto& row : picture_of(start_page(), context()).rows)
        EXPECT_NE(row.label, "Arena") << "one: no choice";
    auto two = context();
    two.arenas.push_back({"the_well", "The Well"});
    const auto shown = [&](const MenuState& s) {
        const auto rows = picture_of(s, two).rows;
        const auto row =
            std::find_if(rows.begin(), rows.end(), [](const auto& r) { return r.label == "Arena"; });
        EXPECT_NE(row, rows.end());
        return std::pair(static_cast<std::size_t>(row - rows.begin()), row->value);
    };
    auto s = start_page();
    EXPECT_EQ(shown(s).second, "Boiling Court");
    s = step(s, {.kind = Kind::right, .device = keyboard, .row = shown(s).first}, two);
    EXPECT_EQ(s.arena, 1U);
    EXPECT_EQ(shown(s).second, "The Well");
    s = step(s, {.kind = Kind::confirm, .device = keyboard, .row = shown(s).first}, two);
    EXPECT_EQ(s.arena, 0U) << "and round again";
    EXPECT_EQ(s.request, MenuRequest::none);
}

TEST(StartScreen, OffersTheLevelsMatchesAndArenasThatTheDataFolderHas) {
    const std::filesystem::path source = THAUM_SOURCE_DIR "/assets";
    const auto folder = std::filesystem::path(testing::TempDir()) / "thaum_menu_assets";
    std::filesystem::remove_all(folder);
    std::filesystem::copy(source, folder, std::filesystem::copy_options::recursive);
    auto data = game::load_match_data(folder, {});
    ASSERT_TRUE(data) << data.error().message;
    LivePlan plan;
    plan.data = std::make_shared<const game::MatchData>(std::move(*data));
    plan.assets = folder;
    const auto before = find_menu_context(plan);
    ASSERT_FALSE(before.rules.empty());
    EXPECT_EQ(before.levels.front(), game::easiest_bot);
    const auto arena_labels = [](const MenuContext& context) {
        std::vector<std::string> labels;
        for (const auto& arena : context.arenas) labels.push_back(arena.label);
        return labels;
    };
    EXPECT_EQ(arena_labels(before), (std::vector<std::string>{"Boiling Court", "The Well"}));

    // Adds a longer match, a file that is no match, and a broken level.
    auto rules = read_text_file(source / "rules" / "quick.toml", 1U << 16U).value();
    const auto at = rules.find("seconds = 240");
    ASSERT_NE(at, std::string::npos);
    ASSERT_TRUE(
        write_text_file(folder / "rules" / "a_long_one.toml", rules.replace(at, 13, "seconds = 665")));
    ASSERT_TRUE(write_text_file(folder / "rules" / "broken.toml", "version = 1\nkills = \"many\"\n"));
    ASSERT_TRUE(write_text_file(folder / "bots" / "level_6.toml", "version = 1\n"));
    std::filesystem::copy_file(THAUM_SOURCE_DIR "/tests/arenas/yard.toml", folder / "arenas/yard.toml");
    ASSERT_TRUE(write_text_file(folder / "arenas" / "broken.toml", "version = 1\nname = \n"));
    const auto after = find_menu_context(plan);
    EXPECT_EQ(arena_labels(after), (std::vector<std::string>{"Boiling Court", "The Well", "Yard"}));
    EXPECT_EQ(after.levels, before.levels);
    ASSERT_EQ(after.rules.size(), before.rules.size() + 1);
    EXPECT_EQ(after.rules[0].name, "a_long_one");
    EXPECT_EQ(after.rules[0].label, "a_long_one: first to 3, 11:05");
}

// ---- the pause --------------------------------------------------------------------------------------------

TEST(PauseMenu, GoesOnLeavesAndComesBackFromPagesBelow) {
    auto s = opened({}, Page::pause);
    s.head = "Paused";
    EXPECT_EQ(with(s, Kind::confirm).request, MenuRequest::go_on);
    EXPECT_EQ(with(s, Kind::back, first_pad).request, MenuRequest::go_on);
    EXPECT_EQ(choose(s, "End this match").request, MenuRequest::leave);
    EXPECT_EQ(with(s, Kind::other).request, MenuRequest::none);
    auto below = choose(choose(s, "Controls"), "Pad");
    EXPECT_EQ(below.pages.size(), 3U);
    below = with(with(below, Kind::back), Kind::back, first_pad);
    ASSERT_EQ(below.pages.size(), 1U);
    EXPECT_EQ(below.request, MenuRequest::none);
    EXPECT_EQ(picture_of(below, context()).cursor, 1U);
}

TEST(PauseMenu, OnTheRangeItChangesTheDummy) {
    auto range = context();
    range.practice = true;
    auto s = opened({}, Page::pause);
    const auto dummy = [&] { return picture_of(s, range).rows[1]; };
    EXPECT_EQ(dummy().label, "Dummy");
    EXPECT_EQ(dummy().value, "still");
    for (const auto* kind : {"strafing", "shooting", "still"}) {
        s = step(std::move(s), {.kind = Kind::right, .device = keyboard, .row = 1}, range);
        EXPECT_EQ(dummy().value, kind);
    }
    EXPECT_EQ(picture_of(s, range).rows.back().label, "Leave the range");
    for (const auto& row : picture_of(s, context()).rows) EXPECT_NE(row.label, "Dummy");
}

// ---- bindings ---------------------------------------------------------------------------------------------

TEST(BindingsPage, AnActionTakesTheNextControlAndNothingElseHappensMeanwhile) {
    auto s = choose(bindings_of("Mouse and keyboard"), "Jump");
    ASSERT_TRUE(s.waiting);
    const auto waiting = with(with(s, Kind::down), Kind::confirm);
    EXPECT_EQ(waiting.waiting, s.waiting);
    EXPECT_EQ(picture_of(waiting, context()).cursor, picture_of(s, context()).cursor);
    EXPECT_FALSE(with(s, Kind::back).waiting);
    EXPECT_EQ(with(s, Kind::back).settings, s.settings);
    // A pad's button cannot be bound to a keyboard.
    const auto wrong = press(s, button(PadButton::a));
    EXPECT_TRUE(wrong.waiting);
    EXPECT_FALSE(wrong.note.empty());
    s = press(s, key("j"));
    EXPECT_FALSE(s.waiting);
    EXPECT_EQ(value_of(s, "Jump"), "J");
    EXPECT_TRUE(s.note.empty());
    s = press(choose(s, "Jump"), {Control::Source::wheel, 0, -1});
    EXPECT_EQ(value_of(s, "Jump"), "Wheel down");
    EXPECT_EQ(value_of(s, "Next wand"), "none");
}

TEST(BindingsPage, TheOtherActionLosesTheControlAndUndoBringsItBack) {
    auto s = press(choose(bindings_of("Mouse and keyboard"), "Jump"), key("w"));
    EXPECT_TRUE(bound(s, DeviceKind::keyboard_mouse, Action::move_forward).empty());
    EXPECT_EQ(s.note, "W is taken from: Move forward");
    s = choose(s, "Undo the last change");
    EXPECT_EQ(s.settings, Settings{});
    EXPECT_TRUE(picture_of(s, context()).rows[row_named(s, "Undo the last change")].dim);
    s = press(choose(s, "Jump"), key("w"));
    s = choose(s, "Reset to defaults");
    EXPECT_EQ(s.settings, Settings{});
    s = choose(s, "Undo the last change");
    EXPECT_EQ(value_of(s, "Jump"), "W");
}

TEST(BindingsPage, OneKeyboardHasTwoHandsAndTheSession) {
    auto s = press(choose(bindings_of("Mouse and keyboard"), "Fire"), key("kp_8"));
    EXPECT_TRUE(bound(s, DeviceKind::keyboard_half, Action::move_forward).empty());
    EXPECT_NE(s.note.find("Keypad and arrows"), std::string::npos);
    s = press(choose(bindings_of("Mouse and keyboard"), "Fire"), key("f6"));
    EXPECT_TRUE(s.settings.of(SessionKey::split).empty());
    s = press(choose(bindings_of("Keys for everybody"), "Split"), key("w"));
    EXPECT_TRUE(bound(s, DeviceKind::keyboard_mouse, Action::move_forward).empty());
    // A change of the pad's bindings leaves the keyboard's unchanged.
    s = press(choose(bindings_of("Pad"), "Jump"), button(PadButton::x));
    EXPECT_TRUE(bound(s, DeviceKind::pad, Action::stir).empty());
    EXPECT_EQ(bound(s, DeviceKind::keyboard_mouse, Action::jump),
              Settings{}.bindings_of(DeviceKind::keyboard_mouse).of(Action::jump));
}

TEST(BindingsPage, ActionsThatNeverActTogetherMayShareAControl) {
    // Choosing each default again takes no control from any action, so the defaults have no conflict.
    for (std::size_t sheet = 0; sheet < sheets; ++sheet) {
        const auto actions = sheet == session_sheet ? session_keys : input::actions;
        for (std::size_t action = 0; action < actions; ++action) {
            const Settings defaults;
            const Slot slot{sheet, action};
            for (const auto& control : controls_of(defaults, slot)) {
                auto settings = defaults;
                EXPECT_TRUE(assign(settings, slot, control).empty()) << sheet << ' ' << action;
            }
        }
    }
}

TEST(BindingsPage, EscCanBeBoundToPauseOnly) {
    auto s = choose(bindings_of("Mouse and keyboard"), "Pause");
    EXPECT_FALSE(esc_ends_waiting(s));
    EXPECT_FALSE(press(s, key("escape")).waiting);
    EXPECT_TRUE(esc_ends_waiting(choose(bindings_of("Mouse and keyboard"), "Jump")));
    EXPECT_TRUE(esc_ends_waiting(choose(bindings_of("Pad"), "Pause")));
    EXPECT_FALSE(esc_ends_waiting(start_page()));
}

TEST(BindingsPage, TogglesAreChosenPerHand) {
    auto s = choose(bindings_of("Pad"), "Trace: hold or toggle");
    EXPECT_EQ(value_of(s, "Trace: hold or toggle"), "toggle");
    EXPECT_EQ(changes({}, s.settings), (std::vector<SettingEdit>{{"pad", "toggle", "\"trace\""}}));
    s = choose(s, "Trace: hold or toggle", Kind::left);
    EXPECT_EQ(s.settings, Settings{});
}

bool all_differ(std::vector<std::string> labels) {
    std::sort(labels.begin(), labels.end());
    return !labels.front().empty() && std::adjacent_find(labels.begin(), labels.end()) == labels.end();
}

TEST(BindingsPage, EveryControlOfAHandHasALabelOfItsOwn) {
    std::vector<std::string> keys, pads;
    for (int code = 0; code < 512; ++code) {
        if (!key_name_of(code).empty()) keys.push_back(label_of({Control::Source::key, code, 0}));
    }
    for (int i = 0; i < 5; ++i) keys.push_back(label_of({Control::Source::mouse_button, i, 0}));
    for (const int way : {-1, 1}) keys.push_back(label_of({Control::Source::wheel, 0, way}));
    for (int i = 0; i < 15; ++i) pads.push_back(label_of({Control::Source::pad_button, i, 0}));
    for (int i = 0; i < 4; ++i) {
        for (const int way : {-1, 1}) pads.push_back(label_of({Control::Source::pad_axis, i, way}));
    }
    for (int i = 4; i < 6; ++i) pads.push_back(label_of({Control::Source::pad_axis, i, 1}));
    EXPECT_TRUE(all_differ(keys));
    EXPECT_TRUE(all_differ(pads));
    EXPECT_EQ(label_of(key("kp_8")), "Keypad 8");
    EXPECT_EQ(label_of(key("left_alt")), "Left alt");
}

// ---- settings ---------------------------------------------------------------------------------------------

TEST(SettingsPage, EveryRowChangesItsSettingAndNoOther) {
    auto s = choose(start_page(), "Settings");
    const auto count = picture_of(s, context()).rows.size();
    EXPECT_EQ(count, all_settings().size() + 2) << "the cauldron's page, and back";
    for (std::size_t i = 0; i < all_settings().size(); ++i) {
        const MenuEvent less{.kind = Kind::left, .device = keyboard, .row = i};
        const MenuEvent more{.kind = Kind::right, .device = keyboard, .row = i};
        auto changed = step(s, more, context());
        // The value was at the end of its range.
        if (changed.settings == s.settings) changed = step(s, less, context());
        const auto edits = changes(s.settings, changed.settings);
        ASSERT_EQ(edits.size(), 1U) << all_settings()[i].key;
        EXPECT_EQ(edits[0].key, all_settings()[i].key);
        EXPECT_EQ(edits[0].table, "");
    }
    EXPECT_EQ(choose(s, "Back").pages.size(), 1U);
}

// ---- the cauldron -----------------------------------------------------------------------------------------

constexpr std::string_view cauldron_row = "Cauldron feedback";

MenuState cauldron_page() { return choose(choose(opened({}, Page::pause), "Settings"), cauldron_row); }

TEST(CauldronPage, EachSourceHasAFaderAndASwitchForEachPlayer) {
    const auto fresh = cauldron_page();
    EXPECT_EQ(picture_of(fresh, context()).title, "The cauldron");
    EXPECT_NE(picture_of(fresh, context()).hint.find("applies from the next match"), std::string::npos);
    for (std::size_t player = 0; player < 2; ++player) {
        for (std::size_t i = 0; i < haptics::fluid_modes.size(); ++i) {
            const auto label = label_of_fader(i);
            auto s = fresh;
            for (std::size_t p = 0; p < player; ++p) s = choose(s, "Whose hand", Kind::right);
            s = choose(choose(s, label, Kind::left), label, Kind::left);
            EXPECT_EQ(value_of(s, label), "90 %");
            EXPECT_EQ(picture_of(s, context()).line, effect_of_fader(i));
            s = choose(s, label);
            EXPECT_EQ(value_of(s, label), "off (90 %)");
            EXPECT_TRUE(picture_of(s, context()).rows[row_named(s, label)].dim);
            const auto name = std::string(haptics::fluid_modes[i].name);
            const std::string table(cauldron_tables[player]);
            EXPECT_EQ(changes({}, s.settings),
                      (std::vector<SettingEdit>{{table, name, "0.9"}, {table, "off", '"' + name + '"'}}));
            s = choose(s, label, Kind::right);
            EXPECT_EQ(value_of(s, label), "off (95 %)") << "a fader that is moved stays off";
            s = choose(s, label);
            EXPECT_EQ(value_of(s, label), "95 %");
            EXPECT_EQ(choose(s, "Reset to defaults").settings, Settings{});
        }
    }
    EXPECT_EQ(choose(fresh, "Back").pages.size(), 2U);
}

TEST(CauldronPage, OpensForThePlayerWhoAsks) {
    auto s = with(with(start_page(), Kind::other, first_pad), Kind::other, keyboard);
    s = choose(opened(s, Page::pause), "Settings");
    const auto row = row_named(s, cauldron_row);
    const auto opened_by = [&](const Device& device) {
        return value_of(step(s, {.kind = Kind::confirm, .device = device, .row = row}, context()),
                        "Whose hand");
    };
    EXPECT_EQ(opened_by(first_pad), "player 1");
    EXPECT_EQ(opened_by(keyboard), "player 2");
    EXPECT_EQ(opened_by(second_pad), "player 1") << "a device without a seat opens the page of player 1";
}

// ---- anything at all --------------------------------------------------------------------------------------

/// After random events the state can be drawn, no control is bound twice in conflict, and the settings can
/// be written.
TEST(MenuUnderWildHands, StaysWhole) {
    Random dice = random_stream(7, 1);
    const auto roll = [&](std::uint64_t n) { return static_cast<int>(dice.next() % n); };
    auto s = start_page();
    for (int i = 0; i < 20000; ++i) {
        MenuEvent event{.kind = static_cast<Kind>(roll(12)),
                        .device = {static_cast<DeviceKind>(roll(3)), roll(4)}};
        if (roll(4) == 0) event.row = static_cast<std::size_t>(roll(60));
        if (event.kind == Kind::control) {
            const auto source = static_cast<Control::Source>(roll(5));
            event.control = {source, 0, roll(2) * 2 - 1};
            if (source == Control::Source::key)
                event.control = key(std::string(1, static_cast<char>('a' + roll(26))));
            if (source == Control::Source::pad_button) event.control = {source, roll(15), 0};
            if (source == Control::Source::mouse_button) event.control = {source, roll(5), 0};
            if (source == Control::Source::pad_axis) event.control.code = roll(6);
        }
        s = step(std::move(s), event, context());
        ASSERT_FALSE(s.pages.empty());
        const auto picture = picture_of(s, context());
        ASSERT_LT(picture.cursor, picture.rows.size());
        ASSERT_TRUE(!s.seats[0] || s.seats[0] != s.seats[1]);
        if (roll(400) == 0) s = opened(std::move(s), roll(2) == 0 ? Page::start : Page::pause);
    }
    const auto edited = edit_settings("version = 1\n", "s", changes({}, s.settings));
    ASSERT_TRUE(edited) << edited.error().message;
    EXPECT_EQ(changes(parse_settings(*edited, "s").value(), s.settings), std::vector<SettingEdit>{});
    for (std::size_t action = 0; action < input::actions; ++action) {
        auto again = s.settings;
        const auto controls = controls_of(again, {0, action});
        for (const auto& control : controls)
            EXPECT_TRUE(assign(again, {0, action}, control).empty()) << action;
    }
}

// ---- drawing ----------------------------------------------------------------------------------------------

struct Box {
    fvec2 low, high;
};

std::vector<Box> boxes_of_text(const render::Overlay& overlay, render::Font& font) {
    std::vector<Box> boxes;
    for (const auto& item : overlay.items) {
        const auto* words = std::get_if<render::TextItem>(&item);
        if (words == nullptr) continue;
        const auto size = font.measure(words->text, words->size);
        const float share = words->align == render::Align::left    ? 0
                            : words->align == render::Align::right ? 1
                                                                   : 0.5F;
        const fvec2 low = words->position - fvec2(share * size.x, 0);
        boxes.push_back({low, low + size});
    }
    return boxes;
}

TEST(MenuDrawing, WordsStayInTheWindowAtEverySize) {
    auto font = render::Font::load();
    ASSERT_TRUE(font) << font.error().message;
    auto joined = with(with(start_page(), Kind::other, first_pad), Kind::other, keyboard);
    auto conflict = press(choose(bindings_of("Mouse and keyboard"), "Fire"), key("kp_8"));
    for (const auto& state : {start_page(), joined, conflict, choose(start_page(), "Settings"),
                              cauldron_page(), opened({}, Page::pause)}) {
        for (const render::Size size :
             {render::Size{1280, 720}, {640, 480}, {320, 200}, {3840, 2160}, {500, 900}}) {
            for (const double scale : {1.0, 1.75, 2.5}) {
                render::Overlay overlay;
                auto picture = picture_of(state, context());
                if (picture.title.empty()) picture.title = "Paused";
                add_menu(overlay, picture, size, scale);
                for (const auto& box : boxes_of_text(overlay, *font)) {
                    EXPECT_GE(box.low.x, 0) << size.width << ' ' << scale;
                    EXPECT_GE(box.low.y, 0) << size.width << ' ' << scale;
                    EXPECT_LE(box.high.x, size.width + 3) << size.width << ' ' << scale;
                    EXPECT_LE(box.high.y, size.height + 3) << size.width << ' ' << scale;
                }
            }
        }
    }
}

/// Tries points over the whole window. Each visible row is found where it is drawn, in order, and the
/// chosen row is always visible.
TEST(MenuDrawing, RowsAreFoundWhereTheyAreDrawn) {
    auto s = bindings_of("Mouse and keyboard");
    for (const double scale : {1.0, 2.5}) {
        for (const std::size_t cursor : {0UL, 15UL, 31UL}) {
            s.pages.back().cursor = cursor;
            const auto picture = picture_of(s, context());
            std::vector<std::size_t> seen;
            for (float y = 0; y < 480; ++y) {
                const auto place = game::place_at(picture, {640, 480}, scale, {320, y});
                if (place && (seen.empty() || seen.back() != place->row)) seen.push_back(place->row);
            }
            ASSERT_GE(seen.size(), 4U);
            EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
            EXPECT_EQ(seen.back() - seen.front() + 1, seen.size());
            EXPECT_NE(std::find(seen.begin(), seen.end(), picture.cursor), seen.end());
        }
    }
    EXPECT_FALSE(game::place_at(picture_of(s, context()), {640, 480}, 1, {2, 240}));
    EXPECT_FALSE(game::place_at({}, {640, 480}, 1, {320, 240}));
}

TEST(MenuDrawing, ArrowsAroundAValueAreLessAndMore) {
    const auto picture = picture_of(choose(start_page(), "Settings"), context());
    int less = 0, more = 0, row = 0;
    for (float x = 0; x < 1280; ++x) {
        const auto place = game::place_at(picture, {1280, 720}, 1, {x, 560});
        if (!place) continue;
        less += place->part == game::MenuPart::less ? 1 : 0;
        more += place->part == game::MenuPart::more ? 1 : 0;
        row += place->part == game::MenuPart::row ? 1 : 0;
    }
    EXPECT_EQ(less, 30);
    EXPECT_EQ(more, 30);
    EXPECT_GT(row, 400);
}

}  // namespace
}  // namespace thaum::app
