// Tests of menus: the start screen, the pause and the pages of controls. Given events, the state and rows are
// checked.
#include <fstream>

#include "core/file.h"
#include "game/data/match_data.h"
#include "game/live/menu_choices.h"
#include "unit/menu_rig.h"

namespace thaum::game::menu_tests {
namespace {

// ---- joining a match on the start screen ------------------------------------------------------------------

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
    // A pad that no player uses yet joins the game with any button, including Back. Back on a keyboard does
    // not join.
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
    EXPECT_NE(p.seats[1].device.find("Beginner"), std::string::npos);
    s = choose(s, "Bot", Kind::left);
    EXPECT_EQ(value_of(s, "Bot"), "Expert");
    s = choose(s, "Bot", Kind::right);
    EXPECT_EQ(value_of(s, "Bot"), "Beginner");
    s = choose(choose(s, "Bot"), "Match");
    EXPECT_EQ(s.bot, 1U);
    EXPECT_EQ(value_of(s, "Match"), "standard: first to 5");
    EXPECT_EQ(s.request, MenuRequest::none);
}

/// The first arm (haptic device) goes to the player with the mouse, and the second one to the other player.
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
    auto data = game::load_match_data(folder, {}).value();
    LivePlan plan;
    plan.data = std::make_shared<const game::MatchData>(std::move(data));
    plan.assets = folder;
    const auto before = find_menu_context(plan);
    ASSERT_FALSE(before.rules.empty());
    ASSERT_EQ(before.bots.size(), 4U);
    EXPECT_EQ(before.bots.front().label, "Novice");
    const auto arena_labels = [](const MenuContext& context) {
        std::vector<std::string> labels;
        for (const auto& arena : context.arenas) labels.push_back(arena.label);
        return labels;
    };
    EXPECT_EQ(arena_labels(before), (std::vector<std::string>{"Boiling Court", "The Well"}));

    // Adds a longer match, a file that is not a match, a bot, and a file that is no bot.
    auto rules = read_text_file(source / "rules" / "quick.toml", 1U << 16U).value();
    const auto at = rules.find("seconds = 240");
    ASSERT_NE(at, std::string::npos);
    ASSERT_TRUE(
        write_text_file(folder / "rules" / "a_long_one.toml", rules.replace(at, 13, "seconds = 665")));
    ASSERT_TRUE(write_text_file(folder / "rules" / "broken.toml", "version = 1\nkills = \"many\"\n"));
    ASSERT_TRUE(write_text_file(folder / "bots" / "a_broken_one.toml", "version = 1\n"));
    ASSERT_TRUE(write_text_file(folder / "bots" / "brewer.toml",
                                "version = 1\nbase = \"level_3\"\nname = \"Brewer\"\nstyle = \"alchemist\"\n"
                                "words = \"Brews.\"\nlevel = 2\n[stir]\nbrew = 0.9\n"));
    std::filesystem::copy_file(THAUM_SOURCE_DIR "/tests/arenas/yard.toml", folder / "arenas/yard.toml");
    ASSERT_TRUE(write_text_file(folder / "arenas" / "broken.toml", "version = 1\nname = \n"));
    const auto after = find_menu_context(plan);
    EXPECT_EQ(arena_labels(after),
              (std::vector<std::string>{"Boiling Court", "broken: cannot be read", "The Well", "Yard"}));
    std::vector<std::string> bots;
    for (const auto& bot : after.bots) bots.push_back(bot.label);
    EXPECT_EQ(bots, (std::vector<std::string>{"Novice", "Beginner", "Brewer", "Adept", "Expert",
                                              "a_broken_one: cannot be read"}));
    EXPECT_EQ(after.bots[2].words, "Alchemist. Brews.");
    EXPECT_EQ(after.bots[5].fault.find("thaum_menu_assets/bots/a_broken_one.toml:1: "), 0U)
        << after.bots[5].fault;
    ASSERT_EQ(after.rules.size(), before.rules.size() + 2);
    EXPECT_EQ(after.rules[0].name, "a_long_one");
    EXPECT_EQ(after.rules[0].label, "a_long_one: first to 3, 11:05");
    EXPECT_TRUE(game::load_match_data(folder, {.match = "a_long_one"})) << "and it can be played";
    EXPECT_EQ(after.rules[1].name, "broken");
    EXPECT_EQ(after.rules[1].fault.find("thaum_menu_assets/rules/broken.toml:2: 'kills' must be"), 0U)
        << after.rules[1].fault;
    EXPECT_EQ(after.arenas[1].fault.find("thaum_menu_assets/arenas/broken.toml:2: "), 0U);

    std::filesystem::remove_all(folder / "bots");
    const auto without = find_menu_context(plan);
    ASSERT_EQ(without.bots.size(), 1U);
    EXPECT_EQ(without.bots[0].fault, "thaum_menu_assets/bots: the folder has no bot, NAME.toml");
}

TEST(StartScreen, WithoutABotThatCanBeReadTwoPlayersPlay) {
    auto none = context();
    none.bots = {{"", "none", "assets/bots: the folder has no bot"}};
    const auto press = [&](MenuState s, const Device& device) {
        return step(std::move(s), {.kind = Kind::confirm, .device = device}, none);
    };
    auto s = press(press(start_page(), first_pad), first_pad);
    EXPECT_EQ(s.request, MenuRequest::none);
    EXPECT_EQ(s.note, "assets/bots: the folder has no bot");
    s = press(press(start_page(), first_pad), second_pad);
    EXPECT_EQ(press(s, first_pad).request, MenuRequest::start);
}

TEST(StartScreen, AnotherDeviceJoinsWhateverRowIsChosen) {
    const auto quit = with(start_page(), Kind::up, keyboard);
    EXPECT_EQ(with(quit, Kind::confirm, keyboard).request, MenuRequest::quit) << "who chose the row means it";
    const auto s = with(quit, Kind::confirm, first_pad);
    EXPECT_EQ(s.request, MenuRequest::none);
    EXPECT_EQ(s.seats[0], first_pad);
    EXPECT_EQ(with(s, Kind::confirm, half).seats[1], half);
    // Both a player's device and a device that no player uses can choose the row Quit.
    EXPECT_EQ(with(s, Kind::confirm, first_pad).request, MenuRequest::quit);
    EXPECT_EQ(with(with(s, Kind::confirm, half), Kind::confirm, second_pad).request, MenuRequest::quit);
    // A click acts on the row under the mouse.
    const MenuEvent click{.kind = Kind::confirm, .device = keyboard, .row = row_named(s, "Settings")};
    EXPECT_EQ(step(start_page(), click, context()).pages.back().page, "settings");
}

TEST(StartScreen, RemembersItsChoicesInTheSettings) {
    auto two = context();
    two.arenas.push_back({"the_well", "The Well"});
    auto s = start_page();
    for (const std::size_t row : {1UL, 2UL, 3UL})
        s = step(s, {.kind = Kind::right, .device = keyboard, .row = row}, two);
    EXPECT_EQ(s.settings.last, (LastChoice{.bot = "level_2", .match = "standard", .arena = "the_well"}));
}

TEST(StartScreen, MutatorsAreTurnedOnAndOffOnAPageOfTheirOwn) {
    auto some = context();
    some.mutators = {{"fog", "Fog", "", "A cast fog is wide."},
                     {"odd", "odd: cannot be read", "assets/mutators/odd.toml:2: wrong"},
                     {"one_wand", "One wand"}};
    const auto press = [&](MenuState s, std::string_view label) {
        const auto rows = picture_of(s, some).rows;
        const auto row = std::ranges::find(rows, label, &MenuRow::label);
        EXPECT_NE(row, rows.end()) << label;
        return step(
            std::move(s),
            {.kind = Kind::confirm, .device = keyboard, .row = static_cast<std::size_t>(row - rows.begin())},
            some);
    };
    auto s = press(start_page(), "Mutators: none");
    EXPECT_EQ(picture_of(s, some).title, "Mutators");
    s = press(press(press(s, "One wand"), "Fog"), "odd: cannot be read");
    EXPECT_EQ(s.mutators, (std::vector<std::string>{"fog", "one_wand"})) << "in the order of the page";
    EXPECT_EQ(s.settings.last.mutators, s.mutators);
    const auto rows = picture_of(s, some).rows;
    EXPECT_EQ(rows[0].value, "on");
    EXPECT_EQ(rows[0].help, "A cast fog is wide.");
    EXPECT_EQ(rows[1].value, "off");
    EXPECT_EQ(rows[1].help, "assets/mutators/odd.toml:2: wrong");
    s = press(press(s, "Back"), "Mutators: Fog, One wand");
    s = press(press(s, "Fog"), "Reset to defaults");
    EXPECT_TRUE(s.mutators.empty());
    EXPECT_TRUE(s.settings.last.mutators.empty());
}

TEST(StartScreen, ABrokenFileStaysInItsRowAndIsNotPlayed) {
    auto broken = context();
    const std::string fault = "assets/rules/odd.toml:2: 'kills' is wrong";
    broken.rules = {broken.rules[0], {"odd", "odd: cannot be read", fault}};
    constexpr std::size_t match_row = 2;
    auto s = step(start_page(), {.kind = Kind::right, .device = keyboard, .row = match_row}, broken);
    const auto row = picture_of(s, broken).rows[match_row];
    EXPECT_EQ(row.value, "odd: cannot be read");
    EXPECT_EQ(row.help, fault);
    EXPECT_TRUE(row.dim);
    EXPECT_EQ(s.settings.last.match, start_page().settings.last.match) << "it is not remembered";
    for (int press = 0; press < 2; ++press)
        s = step(s, {.kind = Kind::confirm, .device = keyboard, .row = 0}, broken);
    EXPECT_EQ(s.request, MenuRequest::none);
    EXPECT_EQ(s.note, fault);
    s = step(s, {.kind = Kind::right, .device = keyboard, .row = match_row}, broken);
    EXPECT_EQ(step(s, {.kind = Kind::confirm, .device = keyboard, .row = 0}, broken).request,
              MenuRequest::start);
}

// ---- the menu of the pause --------------------------------------------------------------------------------

TEST(PauseMenu, GoesOnLeavesAndComesBackFromPagesBelow) {
    auto s = opened({}, "pause");
    s.head = "Paused";
    EXPECT_EQ(with(s, Kind::confirm).request, MenuRequest::go_on);
    EXPECT_EQ(with(s, Kind::back, first_pad).request, MenuRequest::go_on);
    EXPECT_EQ(choose(s, "End this match").request, MenuRequest::leave);
    EXPECT_EQ(choose(s, "Restart the match").request, MenuRequest::restart);
    EXPECT_EQ(with(s, Kind::other).request, MenuRequest::none);
    auto below = choose(choose(s, "Controls"), "Pad");
    EXPECT_EQ(below.pages.size(), 3U);
    below = with(with(below, Kind::back), Kind::back, first_pad);
    ASSERT_EQ(below.pages.size(), 1U);
    EXPECT_EQ(below.request, MenuRequest::none);
    EXPECT_EQ(picture_of(below, context()).cursor, 1U);
}

TEST(StartScreen, OffersTheApprenticeFirstOnAFirstStartAndAlways) {
    const auto s = choose(start_page(), "Apprentice (3 min)");
    EXPECT_EQ(s.request, MenuRequest::apprentice);
    EXPECT_EQ(s.seats[0], keyboard);
    EXPECT_FALSE(s.seats[1]);
    EXPECT_GT(row_named(start_page(), "Apprentice (3 min)"), 0U);
    auto first = context();
    first.first_start = true;
    const auto rows = picture_of(start_page(), first).rows;
    EXPECT_EQ(rows.front().label, "Apprentice (3 min)");
    const auto count = std::count_if(rows.begin(), rows.end(),
                                     [](const auto& row) { return row.label == "Apprentice (3 min)"; });
    EXPECT_EQ(count, 1);
}

TEST(StartScreen, OnePressOnAChosenRowForOnePlayerStartsIfNobodyHasJoined) {
    auto first = context();
    first.first_start = true;
    const auto confirm = [&](MenuState s, const Device& device) {
        return step(std::move(s), {.kind = Kind::confirm, .device = device}, first);
    };
    for (const auto& device : {keyboard, half, first_pad}) {
        const auto s = confirm(start_page(), device);
        EXPECT_EQ(s.request, MenuRequest::apprentice);
        EXPECT_EQ(s.seats[0], device);
    }
    const auto shown = picture_of(start_page(), first);
    EXPECT_EQ(shown.line, "press Enter or A to start, or any other key to join");
    EXPECT_NE(shown.hint.find("start: Enter, A, click"), std::string::npos) << shown.hint;
    // After one player has joined, the start screen waits: a press on another device joins, too.
    const auto one = step(start_page(), {.kind = Kind::other, .device = keyboard}, first);
    EXPECT_EQ(one.request, MenuRequest::none);
    EXPECT_EQ(picture_of(one, first).line, "press again to start, or a second player joins");
    const auto two = confirm(one, first_pad);
    EXPECT_EQ(two.request, MenuRequest::none);
    EXPECT_EQ(two.seats[1], first_pad);
    // Starting the duel by its row still takes two presses.
    auto s = step(start_page(), {.kind = Kind::down, .device = first_pad}, first);
    EXPECT_EQ(picture_of(s, first).line, "press to join");
    s = confirm(s, keyboard);
    EXPECT_EQ(s.request, MenuRequest::none);
    EXPECT_EQ(s.seats[0], keyboard);
}

TEST(StartScreen, OnAFirstStartTwoPressesOfAnyButtonStillStartADuel) {
    auto first = context();
    first.first_start = true;
    auto s = start_page();
    for (int press = 0; press < 2; ++press)
        s = step(std::move(s), {.kind = Kind::other, .device = keyboard}, first);
    EXPECT_EQ(s.request, MenuRequest::start);
}

TEST(PauseMenu, OnTheRangeAPressDrawsAnOwnGesture) {
    auto range = context();
    range.practice = true;
    range.gestures = {"circle", "s", "v"};
    auto s = opened({}, "pause");
    const auto row_of = [&](std::string_view label) {
        const auto rows = picture_of(s, range).rows;
        const auto found =
            std::find_if(rows.begin(), rows.end(), [&](const auto& r) { return r.label == label; });
        EXPECT_NE(found, rows.end()) << label;
        return static_cast<std::size_t>(found - rows.begin());
    };
    const auto own = row_of("Own gesture");
    EXPECT_EQ(picture_of(s, range).rows[own].value, "Circle");
    s = step(std::move(s), {.kind = Kind::left, .device = keyboard, .row = own}, range);
    EXPECT_EQ(picture_of(s, range).rows[own].value, "V");
    s = step(std::move(s), {.kind = Kind::confirm, .device = keyboard, .row = own}, range);
    EXPECT_EQ(s.request, MenuRequest::ask_match);
    ASSERT_TRUE(s.match_request.as<DrawGesture>());
    EXPECT_EQ(s.match_request.as<DrawGesture>()->number, 2U);
    // While an own gesture is drawn, the menu row that started this offers to give it up.
    range.drawn_gesture = 3;
    s = opened(std::move(s), "pause");
    EXPECT_EQ(s.pages.back().cursor, own);
    EXPECT_EQ(row_of("Give up drawing V"), own);
    s = step(std::move(s), {.kind = Kind::confirm, .device = keyboard}, range);
    EXPECT_EQ(s.request, MenuRequest::ask_match);
    EXPECT_TRUE(s.match_request.as<StopDrawing>());
    range.drawn_gesture = 0;
    s = opened(std::move(s), "pause");
    EXPECT_EQ(row_of("Own gesture"), s.pages.back().cursor);
    s = opened(std::move(s), "pause");
    EXPECT_EQ(s.pages.back().cursor, 0U) << "the pause after a pause that was merely closed";
    const auto usual = row_of("Usual V again");
    s = step(std::move(s), {.kind = Kind::confirm, .device = keyboard, .row = usual}, range);
    EXPECT_EQ(s.request, MenuRequest::forget_gesture);
    range.gestures.clear();
    for (const auto& row : picture_of(s, range).rows) EXPECT_NE(row.label, "Own gesture");
}

TEST(PauseMenu, OnTheRangeItChangesTheDummy) {
    auto range = context();
    range.practice = true;
    auto s = opened({}, "pause");
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

// ---- pages of controls ------------------------------------------------------------------------------------

TEST(BindingsPage, AnActionTakesTheNextControlAndNothingElseHappensMeanwhile) {
    auto s = choose(bindings_of("Mouse and keyboard"), "Jump");
    ASSERT_TRUE(s.waiting);
    const auto waiting = with(with(s, Kind::down), Kind::confirm);
    EXPECT_EQ(waiting.waiting, s.waiting);
    EXPECT_EQ(picture_of(waiting, context()).cursor, picture_of(s, context()).cursor);
    EXPECT_FALSE(with(s, Kind::back).waiting);
    EXPECT_EQ(with(s, Kind::back).settings, s.settings);
    // A button of a pad cannot be bound in the keyboard's list.
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
    s = press(choose(bindings_of("Pad"), "Jump"), button(PadButton::left_bumper));
    EXPECT_TRUE(bound(s, DeviceKind::pad, Action::trace).empty());
    EXPECT_EQ(bound(s, DeviceKind::keyboard_mouse, Action::jump),
              Settings{}.bindings_of(DeviceKind::keyboard_mouse).of(Action::jump));
}

TEST(BindingsPage, ActionsThatNeverActTogetherMayShareAControl) {
    // Choosing the default control again for every action takes no control from another action, so the
    // defaults have no conflict.
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

TEST(BindingsPage, TheWheelNeedsNoBindingToMoveWhatIsHeld) {
    auto s = choose(bindings_of("Mouse and keyboard"), "Nearer");
    EXPECT_TRUE(press(s, {Control::Source::wheel, 0, 1}).waiting);
    s = press(s, key("z"));
    EXPECT_EQ(value_of(s, "Nearer"), "Z");
    EXPECT_EQ(value_of(bindings_of("Pad"), "Farther"), "Pad up");
    EXPECT_EQ(value_of(bindings_of("Keypad and arrows"), "Nearer"), "Keypad 2");
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
    EXPECT_EQ(label_of(key("kp_add")), "Keypad +");
    EXPECT_EQ(label_of(key("left_alt")), "Left alt");
}

}  // namespace
}  // namespace thaum::game::menu_tests
