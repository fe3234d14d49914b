// Tests of joysticks that cannot be used: a session shows which and why, and asks for the controls of one of
// them.
#include "game/live/pad_setup.h"

#include <gtest/gtest.h>

#include "core/text.h"
#include "game/settings/own_pads.h"
#include "unit/live_session_rig.h"

namespace thaum::game {
namespace {

input::Stick stick_with(std::optional<std::size_t> held = {}) {
    input::Stick stick{
        .name = "Stick of wood", .path = "/dev/input/event3", .guid = "03000000aabb00001122000001000000"};
    stick.state.buttons.resize(12);
    stick.state.axes.resize(4);
    if (held) stick.state.buttons.at(*held) = true;
    return stick;
}

/// The joystick while the user answers a question: axes for the sticks, buttons for all other controls.
input::Stick answering(std::size_t question) {
    constexpr std::size_t first_axis = 4, axes = 4;
    const bool axis = question >= first_axis && question < first_axis + axes;
    if (!axis) return stick_with(question < first_axis ? question : question - axes);
    auto stick = stick_with();
    stick.state.axes.at(question - first_axis) = 32767;
    return stick;
}

class PadSetupTest : public LiveSessionTest {
protected:
    PadSetupTest() {
        plan_.start_screen = true;
        plan_.settings_file = folder_.path / "settings.toml";
        session_.emplace(shared_, plan_);
        session_->open_start_screen(now_);
    }
    std::optional<PadChange> look(IdleSticks sticks) {
        session_->step_start_screen({}, now_ += 16 * rig::ms);
        auto change = session_->look_at_sticks(std::move(sticks));
        session_->publish_screen();
        return change;
    }
    /// Answers a question with the joystick and releases the part, or skips the question.
    std::optional<PadChange> answer(std::size_t question, bool own = false) {
        const auto sticks = [&](input::Stick stick) {
            return own ? IdleSticks{.own = {std::move(stick)}} : IdleSticks{.unknown = {std::move(stick)}};
        };
        if (!question_is_needed()) {
            press("enter");
            return look(sticks(stick_with()));
        }
        EXPECT_FALSE(look(sticks(answering(question))));
        return look(sticks(stick_with()));
    }
    bool question_is_needed() const { return session_->menu().context().pad_needs_control; }
    void open_setup() {
        look({.unknown = {stick_with()}});
        enter("Controls");
        enter("Set up Stick of wood");
        look({.unknown = {stick_with()}});
    }

    rig::TestPath folder_{"pad_setup"};
};

TEST_F(PadSetupTest, JoysticksThatDoNotPlayAreToldOnTheScreenAndOnceInTheTerminal) {
    testing::internal::CaptureStderr();
    const IdleSticks sticks{.unknown = {stick_with()}, .locked = {{"Locked pad", "/dev/input/event7"}}};
    look(sticks);
    const auto note = screen().menu.note;
    EXPECT_NE(note.find("'Locked pad'"), std::string::npos) << note;
    EXPECT_NE(note.find("/dev/input/event7"), std::string::npos) << note;
    EXPECT_NE(note.find("1 more"), std::string::npos) << note;
    look(sticks);
    look({});
    EXPECT_EQ(screen().menu.note, "") << "both were pulled out";
    look(sticks);
    const auto said = testing::internal::GetCapturedStderr();
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 2) << said;
    EXPECT_NE(said.find("'Stick of wood'"), std::string::npos) << said;
}

TEST_F(PadSetupTest, AllControlsMakeAMappingThatIsKept) {
    open_setup();
    EXPECT_EQ(screen().menu.title, "Set up Stick of wood");
    EXPECT_TRUE(screen().menu.line.starts_with("1 of 20: press A")) << screen().menu.line;
    press("enter");
    look({.unknown = {stick_with()}});
    EXPECT_EQ(screen().menu.note, "a duel cannot be played without this control");
    EXPECT_TRUE(screen().menu.line.starts_with("1 of 20: ")) << screen().menu.line;
    std::optional<PadChange> change;
    for (std::size_t i = 0; i < input::PadAssignment::count(); ++i) {
        EXPECT_FALSE(change);
        change = answer(i);
    }
    ASSERT_TRUE(change);
    EXPECT_EQ(change->mapping,
              "03000000aabb00001122000001000000,Stick of wood,a:b0,leftx:a0,lefty:a1,rightx:a2,righty:a3,"
              "righttrigger:b4,start:b8,platform:Linux,");
    session_->end_pad_setup(*change, {});
    EXPECT_EQ(session_->menu().state().pages.back().page, "sheets");
    EXPECT_TRUE(session_->menu().state().note.starts_with("it plays as a pad now, without B, X, Y, LT, RB, "))
        << session_->menu().state().note;
    const auto file = own_pads_file(plan_.settings_file);
    EXPECT_EQ(load_own_pads(file).mappings, std::vector{change->mapping});
    look({});
    EXPECT_TRUE(session_->menu().context().sticks.empty());
}

TEST_F(PadSetupTest, APadThatWasSetUpCanBeSetUpAgainAndForgotten) {
    const auto file = own_pads_file(plan_.settings_file);
    ASSERT_TRUE(save_own_pad(file, text(stick_with().guid, ",Stick of wood,a:b3,platform:Linux,")));
    look({.own = {stick_with()}});
    EXPECT_EQ(screen().menu.note, "") << "it plays";
    enter("Controls");
    enter("Set up Stick of wood again");
    look({.own = {stick_with()}});
    EXPECT_EQ(screen().menu.title, "Set up Stick of wood");
    std::optional<PadChange> change;
    for (std::size_t i = 0; i < input::PadAssignment::count(); ++i) change = answer(i, true);
    ASSERT_TRUE(change);
    session_->end_pad_setup(*change, {});
    EXPECT_EQ(load_own_pads(file).mappings, std::vector{change->mapping}) << "instead of the old one";
    look({.own = {stick_with()}});
    enter("Forget the set-up of Stick of wood");
    change = look({.own = {stick_with()}});
    ASSERT_TRUE(change);
    EXPECT_EQ(change->model, stick_with().guid);
    EXPECT_EQ(change->mapping, "");
    session_->end_pad_setup(*change, {});
    EXPECT_TRUE(load_own_pads(file).mappings.empty());
    EXPECT_EQ(session_->menu().state().note, "its set-up is forgotten");
    EXPECT_FALSE(look({.unknown = {stick_with()}})) << "once";
}

TEST_F(PadSetupTest, OldButtonsOfAPadMeanNothingWhileItIsSetUpAgain) {
    const auto stick = stick_with();
    const auto pad = [&](std::initializer_list<input::PadButton> pressed) {
        auto state = rig::pad_with(pressed);
        state.path = stick.path;
        return state;
    };
    const auto step_with = [&](const input::PadState& state) {
        session_->step_start_screen({state}, now_ += 16 * rig::ms);
        session_->look_at_sticks({.own = {stick}});
    };
    step_with(pad({}));
    enter("Controls");
    step_with(pad({}));
    enter("Set up Stick of wood again");
    step_with(pad({}));
    step_with(pad({input::PadButton::b}));
    EXPECT_TRUE(session_->menu().sets_up_pad()) << "B leaves other pages";
    step_with(pad({}));
    press("escape");
    step_with(pad({}));
    step_with(pad({input::PadButton::b}));
    EXPECT_EQ(session_->menu().state().pages.back().page, "start") << "the set-up has ended";
}

TEST_F(PadSetupTest, AFileThatCannotBeWrittenIsTold) {
    std::filesystem::create_directories(own_pads_file(plan_.settings_file));
    session_->end_pad_setup({stick_with().guid, text(stick_with().guid, ",Stick,a:b0,")}, {});
    const auto note = session_->menu().state().note;
    EXPECT_TRUE(note.starts_with("it plays as a pad now, for this run only: ")) << note;
    EXPECT_NE(note.find("pads.txt"), std::string::npos) << note;
}

TEST_F(PadSetupTest, FaultsOfTheFileAndPadsWithoutAPlaceAreTold) {
    look({.left_over = {"Fifth pad"}, .faults = {"pads.txt:3: maps no control of a pad"}});
    EXPECT_EQ(screen().menu.note, "pads.txt:3: maps no control of a pad (1 more in the terminal)");
    look({.left_over = {"Fifth pad"}});
    EXPECT_EQ(screen().menu.note, "only 4 pads can be used at once: 'Fifth pad' cannot play");
    look({.left_over = {"Fifth pad", "Sixth pad", "Sixth pad"}});
    EXPECT_EQ(screen().menu.note, "only 4 pads can be used at once: 'Fifth pad' and 2 more cannot play");
}

TEST_F(PadSetupTest, APadThatCannotTurnIsTold) {
    const IdleSticks sticks{.without_right_stick = {"Old pad"}};
    look(sticks);
    EXPECT_EQ(
        screen().menu.note,
        "pad 'Old pad' has no right stick: give \"Turn left\" and the like other controls (Controls, Pad)");
    auto& pad = plan_.settings.bindings_of(input::DeviceKind::pad);
    pad.of(input::Action::turn_left) = {{input::Control::Source::pad_button, 4, 0}};
    pad.of(input::Action::turn_right) = {{input::Control::Source::pad_button, 5, 0}};
    session_.emplace(shared_, plan_);
    session_->open_start_screen(now_);
    look(sticks);
    EXPECT_EQ(screen().menu.note, "") << "its buttons turn";
}

TEST_F(PadSetupTest, EscEndsItAndNothingIsKept) {
    open_setup();
    look({.unknown = {stick_with(4)}});
    press("escape");
    look({.unknown = {stick_with()}});
    EXPECT_EQ(session_->menu().state().pages.back().page, "sheets");
    for (int i = 0; i < 40; ++i) EXPECT_FALSE(look({.unknown = {stick_with()}}));
    EXPECT_TRUE(load_own_pads(own_pads_file(plan_.settings_file)).mappings.empty());
    // The next set-up begins with the first control.
    enter("Set up Stick of wood");
    look({.unknown = {stick_with()}});
    EXPECT_TRUE(screen().menu.line.starts_with("1 of 20: ")) << screen().menu.line;
    // The joystick is unplugged during the set-up.
    look({});
    EXPECT_EQ(session_->menu().state().pages.back().page, "sheets");
}

TEST_F(PadSetupTest, ThePauseOffersItToo) {
    plan_.start_screen = false;
    begin();
    pause(0);
    look({.unknown = {stick_with()}});
    EXPECT_NE(screen().menu.note, "");
    enter("Controls");
    enter("Set up Stick of wood");
    step();
    session_->look_at_sticks({.unknown = {stick_with()}});
    EXPECT_EQ(requests().go_on, game::no_player) << "the match stays paused";
    EXPECT_TRUE(session_->menu().sets_up_pad());
}

}  // namespace
}  // namespace thaum::game
