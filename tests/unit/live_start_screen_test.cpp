// Tests of the start screen of a session.
#include "unit/live_session_rig.h"

namespace thaum::game {
namespace {

using input::PadButton;

class LiveStartScreenTest : public LiveSessionTest {
protected:
    LiveStartScreenTest() {
        plan_.start_screen = true;
        plan_.seconds = 10;
        session_.emplace(shared_, plan_);
        session_->open_start_screen(now_);
    }
    bool step_start(const Pads& pads = {}) {
        const bool starts = session_->step_start_screen(pads, now_ += 16 * rig::ms);
        session_->publish_screen();
        return starts;
    }
};

TEST_F(LiveStartScreenTest, TwoPressesStartAMatchOfThatDevice) {
    EXPECT_FALSE(step_start());
    EXPECT_TRUE(screen().arena_scene);
    EXPECT_TRUE(shared_.scene.take()) << "the arena is shown";
    press("x");
    EXPECT_FALSE(step_start());
    press("x");
    press("x");
    EXPECT_TRUE(step_start()) << "a third press of the same moment is ignored";
    session_->take_seats({});
    EXPECT_EQ(shared_.seats[0].seat.kind, SeatKind::keyboard_mouse);
    EXPECT_EQ(shared_.seats[1].seat.kind, SeatKind::bot);
    session_->begin_match({});
    EXPECT_FALSE(session_->menu().is_open());
}

TEST_F(LiveStartScreenTest, TheRangeStartsWithADummy) {
    enter("Range: practise on a dummy");
    EXPECT_TRUE(step_start());
    session_->take_seats({});
    EXPECT_EQ(shared_.seats[1].seat.kind, SeatKind::dummy);
    EXPECT_TRUE(session_->menu().context().practice);
    EXPECT_TRUE(session_->next().take_range());
}

TEST_F(LiveStartScreenTest, AnotherArenaIsShownAtOnce) {
    shared_.scene.take();
    choose("Arena");
    press("right");
    step_start();
    ASSERT_TRUE(shared_.scene.take());
    EXPECT_EQ(shared_.scene.newest()->choice.arena, "the_well");
    step_start();
    EXPECT_FALSE(shared_.scene.take());
}

TEST_F(LiveStartScreenTest, TheResultOffersTheMenuOnlyIfThereIsOne) {
    step_start();
    EXPECT_TRUE(screen().hud.has_menu);
    plan_.start_screen = false;
    begin();
    step();
    EXPECT_FALSE(screen().hud.has_menu);
}

TEST_F(LiveStartScreenTest, AFaultOfTheSettingsFileIsSaid) {
    EXPECT_EQ(screen().menu.note, "");
    plan_.start_fault =
        "settings.toml:5: 'fov_deg' is 5, must be from 60 to 130; defaults replace wrong values";
    session_.emplace(shared_, plan_);
    session_->open_start_screen(now_);
    step_start();
    EXPECT_EQ(screen().menu.note, plan_.start_fault);
    press("down");
    step_start();
    EXPECT_EQ(screen().menu.note, plan_.start_fault) << "it stays after a press";
    shared_.data_fault.put("bolt.toml:3: a fault");
    step_start();
    EXPECT_EQ(screen().menu.note, plan_.start_fault) << "settings come first";
}

TEST_F(LiveStartScreenTest, AFaultOfTheDataFilesIsSaidOnceTheyAreRead) {
    session_->open_start_screen(now_);
    step_start();
    EXPECT_EQ(screen().menu.note, "");
    shared_.data_fault.put("bolt.toml:3: a fault");
    step_start();
    EXPECT_EQ(screen().menu.note, "bolt.toml:3: a fault");
}

TEST_F(LiveStartScreenTest, AnUnpluggedPadGivesUpItsSeat) {
    step_start({rig::pad_with()});
    step_start({rig::pad_with({PadButton::a})});
    EXPECT_TRUE(screen().menu.seats[0].taken);
    step_start({});
    EXPECT_FALSE(screen().menu.seats[0].taken);
}

/// A pad with every button down, and its triggers and sticks at their limits.
input::PadState whole_pad() {
    auto pad = rig::pad_with();
    pad.buttons = 0x7FFF;
    pad.axes.fill(1);
    return pad;
}

TEST_F(LiveStartScreenTest, TwoPadsThatPressEverythingAtOnceBothGetASeat) {
    const auto idle = rig::pad_with(), some = rig::pad_with({PadButton::a, PadButton::b, PadButton::up});
    EXPECT_FALSE(step_start({idle, idle}));
    EXPECT_FALSE(step_start({some, some}));
    EXPECT_FALSE(step_start({whole_pad(), whole_pad()})) << "triggers come later than buttons";
    EXPECT_FALSE(step_start({rig::pad_with({PadButton::x}), some}));
    EXPECT_FALSE(step_start({whole_pad(), whole_pad()})) << "not let go of since";
    EXPECT_TRUE(screen().menu.seats[0].taken);
    EXPECT_TRUE(screen().menu.seats[1].taken);
    EXPECT_FALSE(step_start({idle, idle}));
    EXPECT_TRUE(step_start({whole_pad(), idle})) << "the second press starts";
    session_->take_seats({idle, idle});
    EXPECT_EQ(shared_.seats[0].seat.kind, SeatKind::pad);
    EXPECT_EQ(shared_.seats[1].seat.kind, SeatKind::pad);
}

TEST_F(LiveStartScreenTest, APadThatJoinsInTheMomentOfTheStartGetsItsSeat) {
    const auto idle = rig::pad_with(), pressed = rig::pad_with({PadButton::a});
    step_start({idle, idle});
    EXPECT_FALSE(step_start({pressed, idle}));
    step_start({idle, idle});
    EXPECT_TRUE(step_start({pressed, pressed}));
    session_->take_seats({idle, idle});
    EXPECT_EQ(shared_.seats[1].seat.kind, SeatKind::pad);
}

TEST_F(LiveStartScreenTest, EndsByQuitOrWhenItsTimeIsUp) {
    press("escape");
    press("enter");
    EXPECT_FALSE(step_start());
    EXPECT_TRUE(shared_.stop) << "Quit";
    shared_.stop = false;
    now_ += 9'900 * rig::ms;
    EXPECT_FALSE(step_start());
    EXPECT_FALSE(shared_.stop);
    now_ += 100 * rig::ms;
    EXPECT_FALSE(step_start());
    EXPECT_TRUE(shared_.stop);
}

}  // namespace
}  // namespace thaum::game
