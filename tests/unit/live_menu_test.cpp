// Tests of the menu in a live session: directions that are held down, the mouse, bindings, saved settings and
// requests.
#include "game/live/menu.h"

#include <gtest/gtest.h>

#include "core/file.h"
#include "unit/live_rig.h"

namespace thaum::game {
namespace {

using input::DeviceKind;
using input::PadAxis;
using input::PadButton;

class LiveMenuTest : public testing::Test {
protected:
    /// Opens the pause menu with its title. A menu without a title is not drawn.
    void open_pause() {
        menu_.open("pause");
        menu_.set_pause({"Paused", ""});
    }
    void press(std::string_view name, std::int64_t now_ns = 0) {
        menu_.key(rig::key(name), true, now_ns);
        menu_.key(rig::key(name), false, now_ns);
    }
    void press_all(std::initializer_list<const char*> names) {
        for (const auto* name : names) press(name);
    }
    std::size_t cursor() const { return menu_.state().pages.back().cursor; }
    std::string_view page() const { return menu_.state().pages.back().page; }
    std::size_t row_of(std::string_view label) const {
        const auto rows = menu_.picture().rows;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (rows[i].label == label) return i;
        }
        ADD_FAILURE() << "no row " << label;
        return 0;
    }
    std::string value_of(std::string_view label) const { return menu_.picture().rows[row_of(label)].value; }
    void choose(std::string_view label) {
        while (cursor() != row_of(label)) press("down");
    }
    /// A point in a part of a menu row (px).
    fvec2 point_of(std::string_view label, game::MenuPart part = game::MenuPart::row) const {
        const auto row = row_of(label);
        const auto picture = menu_.picture();
        for (float y = 0; y < 720; y += 8) {
            for (float x = 0; x < 1280; x += 8) {
                const auto place = game::place_at(picture, rig::window, 1, {x, y});
                if (place && place->row == row && place->part == part) return {x, y};
            }
        }
        ADD_FAILURE() << label << " is not in the window";
        return {};
    }
    void click(fvec2 point, int button = 0) {
        menu_.cursor(point, rig::window);
        menu_.mouse_button(button, true, rig::window);
        menu_.mouse_button(button, false, rig::window);
    }

    LiveMenu menu_{{},
                   {.bots = {{"level_1", "Beginner"}, {"level_2", "Adept"}, {"level_3", "Expert"}},
                    .rules = {{"quick", "quick"}, {"standard", "standard"}},
                    .arenas = {{"boiling_court", "Boiling Court"}},
                    .ends_match = true},
                   {}};
    static constexpr auto first = LiveMenu::repeat_after_ns, next = LiveMenu::repeat_every_ns;
};

// ---- changes while the menu is open ----------------------------------------------------------------------

TEST_F(LiveMenuTest, AJoystickThatIsPluggedInLeavesTheChosenRowChosen) {
    menu_.open("start");
    choose("Controls");
    press("enter");
    choose("Back");
    menu_.tell_sticks({"Stick"}, {}, {});
    EXPECT_EQ(cursor(), row_of("Back"));
    choose("Set up Stick");
    menu_.tell_sticks({"Another", "Stick"}, {"Own"}, {});
    EXPECT_EQ(cursor(), row_of("Set up Stick"));
    choose("Forget the set-up of Own");
    menu_.tell_sticks({}, {"Own"}, {});
    EXPECT_EQ(cursor(), row_of("Forget the set-up of Own"));
    menu_.tell_sticks({}, {}, {});
    press("enter");
    EXPECT_EQ(page(), "start") << "the last row is chosen once the row is gone";
}

TEST_F(LiveMenuTest, TheRowsBelowAnOpenPageStayChosenToo) {
    menu_.tell_sticks({"Stick"}, {}, {});
    menu_.open("start");
    choose("Controls");
    press("enter");
    choose("Set up Stick");
    press("enter");
    ASSERT_EQ(page(), "pad_setup");
    menu_.tell_sticks({"Another"}, {"Stick"}, {});
    menu_.end_pad_setup("");
    EXPECT_EQ(cursor(), row_of("Set up Stick again"));
}

TEST_F(LiveMenuTest, AnOfferInThePauseLeavesTheChosenRowChosen) {
    open_pause();
    choose("End this match");
    menu_.set_pause({.head = "Pad 2 of Tide is not plugged in", .half_for = "Tide"});
    EXPECT_EQ(cursor(), row_of("End this match"));
    menu_.set_pause({.head = "Paused"});
    EXPECT_EQ(cursor(), row_of("End this match"));
}

TEST_F(LiveMenuTest, TheWindowsTitleNamesPageAndRow) {
    const auto title = [&] { return window_title(menu_.state(), menu_.context()); };
    EXPECT_EQ(title(), "Thaum");
    menu_.open("start");
    choose("Bot");
    EXPECT_EQ(title(), "Thaum: Bot: Beginner");
    open_pause();
    EXPECT_EQ(title(), "Thaum (paused): Go on");
    choose("Settings");
    press("enter");
    EXPECT_EQ(title(), "Thaum (paused): Settings / Split: " + value_of("Split"));
    menu_.close();
    EXPECT_EQ(title(), "Thaum");
}

// ---- directions that are held down ------------------------------------------------------------------------

TEST_F(LiveMenuTest, AHeldKeyRepeatsAtTheStatedTimes) {
    menu_.open("start");
    menu_.key(rig::key("down"), true, 0);
    EXPECT_EQ(cursor(), 1U);
    menu_.repeat(first - 1);
    EXPECT_EQ(cursor(), 1U);
    menu_.repeat(first);
    EXPECT_EQ(cursor(), 2U);
    menu_.repeat(first + next - 1);
    EXPECT_EQ(cursor(), 2U);
    menu_.repeat(first + next);
    EXPECT_EQ(cursor(), 3U);
    menu_.key(rig::key("down"), false, first + next);
    menu_.repeat(10 * first);
    EXPECT_EQ(cursor(), 3U);
    press("space", 20 * first);
    menu_.key(rig::key("space"), true, 20 * first);
    const auto before = cursor();
    menu_.repeat(30 * first);
    EXPECT_EQ(cursor(), before) << "only directions repeat";
}

TEST_F(LiveMenuTest, AnotherKeysReleaseDoesNotEndTheRepetition) {
    menu_.open("start");
    menu_.key(rig::key("up"), true, 0);
    menu_.key(rig::key("down"), true, 0);
    menu_.key(rig::key("up"), false, 0);
    menu_.repeat(first);
    EXPECT_EQ(cursor(), 1U);
    menu_.release();
    menu_.repeat(9 * first);
    EXPECT_EQ(cursor(), 1U) << "the focus was lost";
}

TEST_F(LiveMenuTest, AStickThatIsPushedWhenItsPadIsPluggedInMovesNothing) {
    open_pause();
    const auto stuck = rig::pad_at(PadAxis::left_y, -1);
    menu_.pad(0, {}, stuck, 0);
    menu_.pad(0, stuck, stuck, LiveMenu::repeat_after_ns + 1);
    menu_.repeat(LiveMenu::repeat_after_ns + 1);
    EXPECT_EQ(cursor(), 0U);
    menu_.pad(0, stuck, rig::pad_with(), 0);
    menu_.pad(0, rig::pad_with(), stuck, 0);
    EXPECT_EQ(cursor(), 1U) << "it was let go of";
}

TEST_F(LiveMenuTest, AHeldStickRepeatsUntilItIsLetGoOrUnplugged) {
    menu_.open("start");
    const auto idle = rig::pad_with(), down = rig::pad_at(PadAxis::left_y, -1);
    menu_.pad(0, idle, down, 0);
    EXPECT_EQ(cursor(), 1U);
    menu_.pad(0, down, down, first / 2);
    EXPECT_EQ(cursor(), 1U);
    menu_.repeat(first);
    EXPECT_EQ(cursor(), 2U);
    menu_.pad(1, idle, idle, first);
    menu_.repeat(first + next);
    EXPECT_EQ(cursor(), 3U) << "another pad changes nothing";
    menu_.pad(0, down, idle, first + next);
    menu_.repeat(9 * first);
    EXPECT_EQ(cursor(), 3U);
    menu_.pad(0, idle, down, 10 * first);
    menu_.pad(0, down, {}, 10 * first);
    menu_.repeat(19 * first);
    EXPECT_EQ(cursor(), 4U) << "one step of the new push, and no repetition without the pad";
}

TEST_F(LiveMenuTest, AClosedMenuForgetsAHeldDirection) {
    menu_.open("pause");
    menu_.key(rig::key("down"), true, 0);
    menu_.close();
    menu_.repeat(first);
    menu_.open("pause");
    menu_.repeat(2 * first);
    EXPECT_EQ(cursor(), 0U);
}

// ---- the mouse in a menu ----------------------------------------------------------------------------------

TEST_F(LiveMenuTest, TheMouseChoosesTheRowUnderIt) {
    open_pause();
    menu_.cursor(point_of("Settings"), rig::window);
    EXPECT_EQ(cursor(), row_of("Settings"));
    menu_.cursor({2, 2}, rig::window);
    EXPECT_EQ(cursor(), row_of("Settings")) << "beside the rows";
    click(point_of("Settings"));
    ASSERT_EQ(page(), "settings");
    const auto before = value_of("Field of view");
    click(point_of("Field of view", game::MenuPart::more));
    EXPECT_NE(value_of("Field of view"), before);
    click(point_of("Field of view", game::MenuPart::less));
    EXPECT_EQ(value_of("Field of view"), before);
    click(point_of("Field of view"), 1);
    EXPECT_EQ(page(), "pause") << "the right button goes back";
}

TEST_F(LiveMenuTest, AClickBeforeTheMouseMovedChoosesNothing) {
    menu_.open("start");
    menu_.cursor(point_of("Quit"), rig::window);
    menu_.close();
    open_pause();
    menu_.mouse_button(0, true, rig::window);
    EXPECT_EQ(menu_.take_request(), MenuRequest::none);
    menu_.cursor(point_of("Go on"), rig::window);
    menu_.mouse_button(0, true, rig::window);
    EXPECT_EQ(menu_.take_request(), MenuRequest::go_on);
}

TEST_F(LiveMenuTest, TheWheelMovesTheChoice) {
    menu_.open("pause");
    menu_.wheel(-1);
    EXPECT_EQ(cursor(), 1U);
    menu_.wheel(1);
    menu_.wheel(0);
    EXPECT_EQ(cursor(), 0U);
}

// ---- typing a name ----------------------------------------------------------------------------------------

class LiveMenuNameTest : public LiveMenuTest {
protected:
    LiveMenuNameTest() {
        open_pause();
        press_all({"down", "down", "enter"});
        choose("Each player's own settings");
        press("enter");
        choose("Name");
        press("enter");
    }
    void type(std::u32string_view words) {
        for (const auto character : words) menu_.character(character);
    }
};

TEST_F(LiveMenuNameTest, CharactersMakeTheNameAndKeysDoNothingElse) {
    ASSERT_TRUE(menu_.takes_text());
    type(U" Zoë");
    press_all({"w", "q", "space", "down"});
    EXPECT_EQ(menu_.take_request(), MenuRequest::none) << "Q does not leave";
    EXPECT_EQ(value_of("Name"), "Zoë_");
    EXPECT_EQ(menu_.settings().players[0].name, "") << "not before Enter";
    menu_.key(rig::key("backspace"), true, 0);
    menu_.repeat(first);
    menu_.key(rig::key("backspace"), false, first);
    type(U"ö");
    press("enter");
    EXPECT_FALSE(menu_.takes_text());
    EXPECT_EQ(menu_.settings().players[0].name, "Zö");
    EXPECT_EQ(menu_.settings().players[1].name, "");
    EXPECT_TRUE(menu_.take_settings_change());
    type(U"x");
    EXPECT_EQ(value_of("Name"), "Zö") << "only while a name is typed";
}

TEST_F(LiveMenuNameTest, EscapeKeepsTheOldNameAndTheMouseCannotLeaveTheRow) {
    type(U"Ann");
    const auto row = cursor();
    menu_.cursor(point_of("Captions"), rig::window);
    EXPECT_EQ(cursor(), row);
    press("escape");
    EXPECT_EQ(menu_.settings(), Settings{});
    EXPECT_EQ(page(), "player");
}

TEST_F(LiveMenuTest, WAndSMoveTheChoiceAndAAndDTurnAValue) {
    menu_.open("start");
    press_all({"s", "s", "w"});
    EXPECT_EQ(cursor(), 1U);
    press_all({"d", "d", "a"});
    EXPECT_EQ(value_of("Bot"), "Adept");
    EXPECT_FALSE(menu_.state().seats[0]) << "keys that move do not join";
}

// ---- devices in a menu ------------------------------------------------------------------------------------

TEST_F(LiveMenuTest, EachDeviceJoinsWithItsOwnPress) {
    menu_.open("start");
    menu_.pad(2, rig::pad_with(), rig::pad_with({PadButton::start}), 0);
    press("kp_0");
    EXPECT_EQ(menu_.state().seats[0], (Device{DeviceKind::pad, 2}));
    EXPECT_EQ(menu_.state().seats[1], (Device{DeviceKind::keyboard_half, 0}));
    press("left_alt");
    EXPECT_TRUE(menu_.state().note.empty()) << "a key to change windows does not ask for a seat";
    press("x");
    EXPECT_FALSE(menu_.state().note.empty()) << "both seats are taken";
}

TEST_F(LiveMenuTest, AButtonThatIsHeldIsNoPress) {
    menu_.open("start");
    const auto held = rig::pad_with({PadButton::a});
    menu_.pad(0, held, held, 0);
    EXPECT_FALSE(menu_.state().seats[0]);
}

TEST_F(LiveMenuTest, PadsAreNamedAndAnUnpluggedOneGivesUpItsSeat) {
    menu_.open("start");
    menu_.name_pads({rig::pad_with()});
    menu_.pad(0, rig::pad_with(), rig::pad_with({PadButton::a}), 0);
    EXPECT_EQ(menu_.picture().seats[0].device, "Pad 1 (Make-believe pad)");
    menu_.name_pads({});
    EXPECT_FALSE(menu_.state().seats[0]);
    EXPECT_EQ(menu_.context().pads[0], "");
}

// ---- bindings and settings --------------------------------------------------------------------------------

TEST_F(LiveMenuTest, TheNextControlOfItsDeviceIsBound) {
    menu_.open("pause");
    press_all({"down", "enter", "enter"});
    ASSERT_EQ(page(), "bindings");
    choose("Jump");
    press("enter");
    ASSERT_TRUE(menu_.waits_for_control());
    menu_.pad(0, rig::pad_with(), rig::pad_with({PadButton::a}), 0);
    EXPECT_TRUE(menu_.waits_for_control()) << "a pad's button is not on this device";
    menu_.key(rig::key("down"), true, 0);
    EXPECT_FALSE(menu_.waits_for_control());
    EXPECT_EQ(value_of("Jump"), "Down");
    const auto row = cursor();
    menu_.repeat(first);
    EXPECT_EQ(cursor(), row) << "the key was no direction";
    press("enter");
    menu_.mouse_button(3, true, rig::window);
    EXPECT_EQ(value_of("Jump"), "Mouse button 4");
    press("enter");
    menu_.wheel(1);
    EXPECT_EQ(value_of("Jump"), "Wheel up");
    press("enter");
    press("escape");
    EXPECT_FALSE(menu_.waits_for_control());
    EXPECT_EQ(value_of("Jump"), "Wheel up");
    EXPECT_EQ(page(), "bindings");
}

TEST_F(LiveMenuTest, AChangedSettingIsReportedOnce) {
    menu_.open("pause");
    press_all({"down", "down", "enter"});
    ASSERT_EQ(page(), "settings");
    EXPECT_FALSE(menu_.take_settings_change());
    choose("Text size");
    press("right");
    EXPECT_GT(menu_.settings().text_scale, Settings{}.text_scale);
    EXPECT_TRUE(menu_.take_settings_change());
    EXPECT_FALSE(menu_.take_settings_change());
    EXPECT_TRUE(menu_.state().note.empty());
}

class LiveMenuFileTest : public LiveMenuTest {
protected:
    LiveMenuFileTest() {
        EXPECT_TRUE(load_settings(file_.path, THAUM_SOURCE_DIR "/assets"));
        menu_ = LiveMenu({}, menu_.context(), file_.path);
        menu_.open("pause");
        press_all({"down", "down", "enter"});
        choose("Field of view");
    }
    std::string source() const { return read_text_file(file_.path, 1U << 20U).value(); }

    const rig::TestPath file_{"settings.toml"};
};

TEST_F(LiveMenuFileTest, AChangedSettingReachesTheFile) {
    press("right");
    const auto read = parse_settings(source(), "settings.toml").value();
    EXPECT_EQ(read.fov, menu_.settings().fov);
    EXPECT_NE(read.fov, Settings{}.fov);
    EXPECT_NE(source().find("# 60 to 130"), std::string::npos) << "comments stay";
}

TEST_F(LiveMenuFileTest, TheSessionsKeysChangeThisRunOnly) {
    const auto before = source();
    menu_.toggle_fullscreen();
    menu_.turn_split();
    EXPECT_TRUE(menu_.settings().fullscreen);
    EXPECT_EQ(menu_.settings().split, render::Split::side_by_side);
    press("right");
    const auto read = parse_settings(source(), "settings.toml").value();
    EXPECT_FALSE(read.fullscreen);
    EXPECT_EQ(read.split, render::Split::top_bottom);
    EXPECT_NE(source(), before);
}

TEST_F(LiveMenuFileTest, AFaultyFileIsKeptAndTheChangeHoldsForThisRun) {
    ASSERT_TRUE(write_text_file(file_.path, "version = 9\n"));
    press("right");
    EXPECT_EQ(source(), "version = 9\n");
    EXPECT_NE(menu_.settings().fov, Settings{}.fov);
    EXPECT_TRUE(menu_.take_settings_change());
    EXPECT_EQ(menu_.picture().note.find("for this run only: "), 0U) << menu_.picture().note;
}

// ---- requests that a menu makes to the session ------------------------------------------------------------

TEST_F(LiveMenuTest, TheLeaveKeyLeavesFromThePauseItself) {
    menu_.open("pause");
    press("q");
    EXPECT_EQ(menu_.take_request(), MenuRequest::leave);
    EXPECT_EQ(menu_.take_request(), MenuRequest::none);
    press_all({"down", "enter", "q"});
    EXPECT_EQ(menu_.take_request(), MenuRequest::none) << "on a page below the pause";
}

/// A request of the menu stays until the session carries it out. Presses at the same moment are kept for the
/// menu that follows.
TEST_F(LiveMenuTest, ARequestIsNotLostByLaterEvents) {
    menu_.open("start");
    press_all({"x", "x", "escape", "down"});
    EXPECT_TRUE(menu_.state().seats[0]);
    EXPECT_EQ(menu_.take_request(), MenuRequest::start);
    press("escape");
    EXPECT_FALSE(menu_.state().seats[0]);
}

TEST_F(LiveMenuTest, AMenuThatOpensHasNoOldRequest) {
    menu_.open("start");
    press_all({"x", "x"});
    menu_.open("pause");
    EXPECT_EQ(menu_.take_request(), MenuRequest::none);
}

TEST_F(LiveMenuTest, ThePauseShowsItsReason) {
    menu_.open("pause");
    menu_.set_pause({"Paused", "by player 2"});
    EXPECT_EQ(menu_.picture().title, "Paused");
    EXPECT_EQ(menu_.picture().line, "by player 2");
    EXPECT_FALSE(menu_.on_start_screen());
    menu_.close();
    EXPECT_FALSE(menu_.is_open());
    EXPECT_EQ(menu_.picture(), game::MenuPicture{});
}

}  // namespace
}  // namespace thaum::game
