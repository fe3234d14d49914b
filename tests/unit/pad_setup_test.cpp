// Tests of joysticks that do not play: a session tells which and why, and asks for the controls of one.
#include "game/live/pad_setup.h"

#include <gtest/gtest.h>

#include "game/settings/own_pads.h"
#include "unit/live_session_rig.h"

namespace thaum::app {
namespace {

input::Stick stick_with(std::optional<std::size_t> held = {}) {
    input::Stick stick{
        .name = "Stick of wood", .path = "/dev/input/event3", .guid = "03000000aabb00001122000001000000"};
    stick.state.buttons.resize(12);
    if (held) stick.state.buttons.at(*held) = true;
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
    std::optional<std::string> look(IdleSticks sticks) {
        session_->step_start_screen({}, now_ += 16 * rig::ms);
        auto mapping = session_->look_at_sticks(std::move(sticks));
        session_->publish_screen();
        return mapping;
    }
    void open_setup() {
        look({.unknown = {stick_with()}});
        choose("Controls");
        press("enter");
        choose("Set up Stick of wood");
        press("enter");
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
    look({.unknown = {stick_with(4)}});
    EXPECT_TRUE(screen().menu.line.starts_with("2 of 20: ")) << screen().menu.line;
    look({.unknown = {stick_with()}});
    std::optional<std::string> mapping;
    for (std::size_t i = 1; i < input::PadAssignment::count(); ++i) {
        EXPECT_FALSE(mapping);
        press("enter");  // skips
        mapping = look({.unknown = {stick_with()}});
    }
    ASSERT_TRUE(mapping);
    EXPECT_EQ(*mapping, "03000000aabb00001122000001000000,Stick of wood,a:b4,platform:Linux,");
    session_->end_pad_setup(*mapping, {});
    EXPECT_EQ(session_->menu().state().pages.back().page, Page::sheets);
    EXPECT_NE(session_->menu().state().note, "");
    EXPECT_EQ(load_own_pads(own_pads_file(plan_.settings_file)).value(), std::vector{*mapping});
    look({});
    EXPECT_TRUE(session_->menu().context().sticks.empty());
}

TEST_F(PadSetupTest, EscEndsItAndNothingIsKept) {
    open_setup();
    look({.unknown = {stick_with(4)}});
    press("escape");
    look({.unknown = {stick_with()}});
    EXPECT_EQ(session_->menu().state().pages.back().page, Page::sheets);
    for (int i = 0; i < 40; ++i) EXPECT_FALSE(look({.unknown = {stick_with()}}));
    EXPECT_TRUE(load_own_pads(own_pads_file(plan_.settings_file)).value().empty());
    // The next set-up begins with the first control.
    choose("Set up Stick of wood");
    press("enter");
    look({.unknown = {stick_with()}});
    EXPECT_TRUE(screen().menu.line.starts_with("1 of 20: ")) << screen().menu.line;
    // Its joystick is pulled out.
    look({});
    EXPECT_EQ(session_->menu().state().pages.back().page, Page::sheets);
}

TEST_F(PadSetupTest, ThePauseOffersItToo) {
    plan_.start_screen = false;
    begin();
    pause(0);
    step();
    look({.unknown = {stick_with()}});
    EXPECT_NE(screen().menu.note, "");
    choose("Controls");
    press("enter");
    choose("Set up Stick of wood");
    press("enter");
    step();
    session_->look_at_sticks({.unknown = {stick_with()}});
    EXPECT_EQ(requests().go_on, game::no_player) << "the match stays paused";
    EXPECT_TRUE(session_->menu().sets_up_pad());
}

}  // namespace
}  // namespace thaum::app
