// Tests of the main thread's part of a live session (a played match with its menus), without window, threads
// and clock. The test acts as the simulation thread: it sets the match's state and reads the requests to the
// match.
#include "game/live/session.h"

#include <gtest/gtest.h>

#include "core/file.h"
#include "game/bots/bot.h"
#include "game/match/record.h"
#include "unit/live_session_rig.h"

namespace thaum::game {
namespace {

using input::Button;
using input::PadButton;

/// Replay of a match of eight ticks.
Expected<game::Playback> short_replay() {
    const rig::TestPath file("replay.thaumlog");
    const game::MatchSetup setup{.devices = {game::bot_device(0, "level_1"), game::bot_device(1, "level_1")}};
    game::Simulation match(shipped_data(), setup);
    auto header = game::log_header(*shipped_data(), setup, {"human", "bot 1"});
    header.names = {"Ada", "Bot 1"};
    auto log = input::LogWriter::create(file.path, header);
    if (!log) return log.error();
    for (int t = 0; t < 8; ++t) game::tick_and_record(match, {}, &*log);
    if (const auto closed = game::close_log(*log, match); !closed) return closed.error();
    return game::Playback::open(file.path, THAUM_SOURCE_DIR "/assets");
}

// ---- pads that are lost and come back ---------------------------------------------------------------------

TEST_F(LiveSessionTest, APadLostInPlayPausesAndIsNamedUntilItsPlayerIsBack) {
    begin({rig::pad_with()});
    step();
    EXPECT_EQ(requests().pause, game::no_player);
    pads_ = {};
    step();
    EXPECT_EQ(requests().pause, 1U);
    EXPECT_TRUE(shared_.pad_lost[1]);
    EXPECT_FALSE(shared_.pad_lost[0]);
    EXPECT_EQ(screen().hud.device_messages[1],
              "pad lost: plug it in and press a button on it or on a free pad");
    EXPECT_EQ(screen().menu, game::MenuPicture{}) << "the match has not paused yet";
    pause(1);
    EXPECT_EQ(screen().menu.title, pause_words({.lost_pad = {std::nullopt, 0}}).head);
    EXPECT_TRUE(screen().hud.menu);
    pads_[0] = rig::pad_with();
    step();
    EXPECT_EQ(screen().menu.title, "Pad 1 of Tide is plugged in again");
    EXPECT_EQ(screen().hud.device_messages[1], "pad is back: press a button on it to go on");
    EXPECT_EQ(requests().go_on, game::no_player);
    pads_[0] = rig::pad_with({PadButton::a});
    step();
    EXPECT_EQ(requests().go_on, 1U);
    EXPECT_FALSE(shared_.pad_lost[1]);
    EXPECT_EQ(screen().hud.device_messages[1], "");
    EXPECT_EQ(session_->menu().state().pages.size(), 1U) << "the button does not act in the menu";
    go_on();
    EXPECT_FALSE(session_->menu().is_open());
    step();
    EXPECT_FALSE(rig::is_down(sample(1), Button::jump)) << "held over the rejoin";
    pads_[0] = rig::pad_with();
    step();
    pads_[0] = rig::pad_with({PadButton::a});
    step();
    EXPECT_TRUE(rig::is_down(sample(1), Button::jump));
}

TEST_F(LiveSessionTest, AMatchWithoutAPlayersPadBeginsPausedAndSaysWhosePadIsMissing) {
    plan_.seats = {rig::first_pad_seat, rig::first_pad_seat};
    begin({rig::pad_with()});
    EXPECT_EQ(requests().pause, 1U) << "one pad for two";
    EXPECT_FALSE(shared_.pad_lost[0]);
    EXPECT_TRUE(shared_.pad_lost[1]);
    pause(1);
    EXPECT_EQ(screen().menu.title, pause_words({.lost_pad = {std::nullopt, 1}}).head);
    pads_[1] = rig::pad_with({PadButton::a});
    step();
    EXPECT_EQ(requests().go_on, 1U);
    EXPECT_FALSE(shared_.pad_lost[1]);
    begin(Pads{});
    step();
    EXPECT_TRUE(shared_.pad_lost[0] && shared_.pad_lost[1]);
    EXPECT_LT(requests().pause, game::players);
}

TEST_F(LiveSessionTest, NobodyGoesOnWithoutTheLostPad) {
    plan_.seats = {rig::first_pad_seat, rig::first_pad_seat};
    const Pads one{rig::pad_with()}, both{rig::pad_with(), rig::pad_with()};
    begin(both);
    pads_ = one;
    step();
    pause(1);
    requests().pause = game::no_player;
    const auto refused = [&] {
        step();
        return requests().go_on == game::no_player && session_->menu().is_open() &&
               screen().menu.note == "cannot go on: pad 2 of Tide is not plugged in";
    };
    press("escape");
    EXPECT_TRUE(refused()) << screen().menu.note;
    enter("Go on");
    EXPECT_TRUE(refused());
    pads_[0] = rig::pad_with({PadButton::start});
    step();
    EXPECT_TRUE(refused()) << "the other player's pad";
    pads_ = both;
    step();
    EXPECT_EQ(screen().menu.note, "") << "it is back";
    press("escape");
    step();
    EXPECT_LT(requests().go_on, game::players) << "it is plugged in again";
    EXPECT_FALSE(shared_.pad_lost[1]);
}

TEST_F(LiveSessionTest, AWishToGoOnComesTooLateForAPadThatLeaves) {
    begin({rig::pad_with()});
    pause(0);
    press("escape");
    pads_ = {};
    step();
    EXPECT_EQ(requests().go_on, game::no_player);
    EXPECT_EQ(screen().menu.title, "Pad 1 of Tide is not plugged in");
}

TEST_F(LiveSessionTest, ARoundThatBeginsWithoutAPadPauses) {
    begin({rig::pad_with()});
    shared_.progress.state = PlayState::over;
    pads_ = {};
    step();
    requests().pause = game::no_player;  // between two rounds there is nothing to pause
    step();
    EXPECT_EQ(requests().pause, game::no_player);
    go_on();
    EXPECT_EQ(requests().pause, 1U);
}

TEST_F(LiveSessionTest, ThePauseWithoutAPadOffersTheKeypadAndAWayOut) {
    begin({rig::pad_with()});
    pads_ = {};
    step();
    pause(1);
    enter("Keypad and arrows for Tide");
    step();
    EXPECT_EQ(requests().go_on, 1U);
    go_on();
    session_->key(rig::key("kp_8"), true, now_);
    EXPECT_EQ(sample(1).counts[input::hand::forward], 127);
    // Players can always leave: the last row of the menu does it.
    begin(Pads{});
    pause(1);
    enter("Quit");
    step();
    EXPECT_TRUE(shared_.stop);
}

TEST_F(LiveSessionTest, TheKeypadStandsInForALostPad) {
    begin({rig::pad_with()});
    pads_ = {};
    step();
    pause(1);
    press("kp_0");
    EXPECT_EQ(requests().go_on, 1U);
    go_on();
    session_->key(rig::key("kp_8"), true, now_);
    EXPECT_EQ(sample(1).counts[input::hand::forward], 127);
}

TEST_F(LiveSessionTest, ButtonBLeavesOnceTheResultWasSeen) {
    plan_.start_screen = true;
    plan_.seats = {};
    session_.emplace(shared_, plan_);
    session_->open_start_screen(now_);
    const Pads held{rig::pad_with({PadButton::a})}, idle{rig::pad_with()};
    session_->step_start_screen(held, now_);
    session_->step_start_screen(idle, now_);
    ASSERT_TRUE(session_->step_start_screen(held, now_));
    session_->take_seats(idle);
    session_->begin_match(idle);
    const auto press_b = [&](std::int64_t after_ms) {
        pads_ = idle;
        step(after_ms);
        pads_[0] = rig::pad_with({PadButton::b});
        step();
        return requests().end.load();
    };
    EXPECT_FALSE(press_b(4)) << "during play";
    shared_.progress.state = PlayState::over;
    EXPECT_FALSE(press_b(4));
    EXPECT_FALSE(press_b(700));
    EXPECT_TRUE(press_b(200));
    EXPECT_FALSE(shared_.stop) << "the start screen follows";
}

// ---- loss of the window's focus ---------------------------------------------------------------------------

TEST_F(LiveSessionTest, ALostFocusReleasesAllKeysAndThenPauses) {
    begin();
    session_->key(rig::key("w"), true, now_);
    EXPECT_EQ(sample(0).counts[input::hand::forward], 127);
    session_->focus(false, now_);
    EXPECT_EQ(sample(0).counts[input::hand::forward], 0);
    step(150);
    EXPECT_EQ(requests().pause, game::no_player) << "it may be a flicker";
    step(1);
    EXPECT_EQ(requests().pause, 0U);
    requests().pause = game::no_player;
    step(1000);
    EXPECT_EQ(requests().pause, game::no_player) << "once";
}

TEST_F(LiveSessionTest, ThePauseSaysThatTheWindowLostTheFocus) {
    begin();
    session_->focus(false, now_);
    step(200);
    pause(0);
    EXPECT_EQ(screen().menu.line, pause_words({.focus_lost = true}).line);
    go_on();
    pause(0);
    EXPECT_EQ(screen().menu.line, "by Ember") << "another pause has another reason";
    session_->focus(false, now_);
    step(200);
    EXPECT_EQ(screen().menu.line, "by Ember") << "the match was paused before";
}

TEST_F(LiveSessionTest, ALostFocusWaitsForTheFirstPicture) {
    begin();
    shared_.ready = false;
    session_->focus(false, now_);
    step(500);
    EXPECT_EQ(requests().pause, game::no_player);
    shared_.ready = true;
    step();
    EXPECT_EQ(requests().pause, 0U);
}

TEST_F(LiveSessionTest, BotsAndAProbePlayOnWithoutTheFocus) {
    plan_.probe = true;
    begin();
    session_->focus(false, now_);
    step(500);
    EXPECT_EQ(requests().pause, game::no_player);
    plan_.probe = false;
    plan_.seats = {rig::bot_seat, rig::bot_seat};
    begin();
    session_->focus(false, now_);
    step(500);
    EXPECT_EQ(requests().pause, game::no_player);
}

// ---- keys in play and in the pause ------------------------------------------------------------------------

TEST_F(LiveSessionTest, InputGoesToTheHandsInPlayAndToTheMenuInThePause) {
    begin();
    session_->key(rig::key("w"), true, now_);
    session_->mouse_move(7, 0, now_ + 1);
    EXPECT_EQ(shared_.input_came_ns, now_) << "arrival of the first event that no tick has taken";
    const auto playing = sample(0);
    EXPECT_EQ(playing.counts[input::hand::forward], 127);
    EXPECT_EQ(playing.counts[input::hand::look_right], 7);
    EXPECT_TRUE(session_->captures_cursor());
    pause(0);
    EXPECT_FALSE(session_->captures_cursor());
    EXPECT_EQ(sample(0).counts[input::hand::forward], 0) << "the pause releases all keys";
    shared_.input_came_ns = 0;
    session_->key(rig::key("w"), true, now_);
    session_->mouse_move(7, 0, now_);
    session_->wheel(1, now_);
    EXPECT_EQ(sample(0).counts[input::hand::forward], 0);
    EXPECT_EQ(sample(0).counts[input::hand::look_right], 0);
    EXPECT_EQ(shared_.input_came_ns, 0);
    press("escape");
    step();
    EXPECT_EQ(requests().go_on, 0U);
}

TEST_F(LiveSessionTest, TheSessionsPauseKeyAsksForAPauseUnlessAPlayersKeyDoes) {
    plan_.settings.session[static_cast<std::size_t>(SessionKey::pause)] = {
        {input::Control::Source::key, rig::key("f9"), 0}};
    begin();
    press("f9");
    EXPECT_EQ(requests().pause, 0U);
    requests().pause = game::no_player;
    plan_.settings.bindings_of(input::DeviceKind::keyboard_mouse).of(input::Action::pause) = {
        {input::Control::Source::key, rig::key("f9"), 0}};
    begin();
    press("f9");
    EXPECT_EQ(requests().pause, game::no_player) << "the player's hands pause";
}

TEST_F(LiveSessionTest, TheScreenNamesPlayersAndTheirControls) {
    begin();
    step();
    EXPECT_EQ(screen().hud.names, (std::array<std::string, 2>{})) << "people are called by their teams";
    EXPECT_EQ(screen().hud.controls[0].fire, "Left mouse");
    EXPECT_EQ(screen().hud.controls[1].fire, "RT");
    plan_.settings.players[0].name = "Zoë";
    plan_.settings.players[1].name = "Ann";
    begin();
    step();
    EXPECT_EQ(screen().hud.names, (std::array<std::string, 2>{"Zoë", "Ann"}));
    plan_.settings.players[0].name.clear();
    plan_.seats[1] = {.kind = SeatKind::bot, .bot = "level_3"};
    begin();
    step();
    EXPECT_EQ(screen().hud.names, (std::array<std::string, 2>{"", "Expert"})) << "a bot has not Ann's name";
    EXPECT_EQ(screen().hud.controls[1], game::ControlNames{}) << "a bot needs no prompt";
    plan_.seats[0] = {.kind = SeatKind::bot, .bot = "level_3"};
    begin();
    step();
    EXPECT_EQ(screen().hud.names, (std::array<std::string, 2>{})) << "two bots are told apart by their teams";
}

TEST_F(LiveSessionTest, KeysLeaveOrRepeatAFinishedMatch) {
    begin();
    const auto again = rig::code_of(defaults_, SessionKey::again),
               leave = rig::code_of(defaults_, SessionKey::leave);
    press(again);
    press(leave);
    EXPECT_FALSE(requests().rematch) << "during play";
    EXPECT_FALSE(shared_.stop);
    shared_.progress.state = PlayState::over;
    step();
    press(leave);
    EXPECT_FALSE(shared_.stop) << "the result was not seen yet";
    step(801);
    press(again);
    EXPECT_TRUE(requests().rematch);
    press(leave);
    EXPECT_TRUE(shared_.stop) << "without a start screen the program ends";
    EXPECT_FALSE(requests().end);
}

TEST_F(LiveSessionTest, SomeKeysActAtAnyTime) {
    begin();
    press(rig::code_of(defaults_, SessionKey::mark));
    press(rig::code_of(defaults_, SessionKey::forces));
    press(rig::code_of(defaults_, SessionKey::fullscreen));
    pause(0);
    press(rig::code_of(defaults_, SessionKey::mark));
    press(rig::code_of(defaults_, SessionKey::split));
    session_->publish_screen();
    EXPECT_TRUE(requests().take() && requests().take() && !requests().take()) << "two marks";
    EXPECT_TRUE(screen().hud.forces);
    EXPECT_EQ(screen().hud.split, render::Split::side_by_side);
    EXPECT_TRUE(session_->menu().settings().fullscreen);
}

TEST_F(LiveSessionTest, AKeyShowsForcesThenTimesOfThePictureThenNeither) {
    begin();
    for (const auto& [forces, times] :
         {std::pair(true, false), {false, true}, {false, false}, {true, false}}) {
        press(rig::code_of(defaults_, SessionKey::forces));
        session_->publish_screen();
        EXPECT_EQ(screen().hud.forces, forces);
        EXPECT_EQ(screen().frame_times, times);
    }
}

TEST_F(LiveSessionTest, AReplayHasItsOwnKeysAndMouse) {
    auto replay = short_replay().value();
    const game::ReplayIndex index(replay);
    const ShownReplay shown{replay, index, 5, 0.5};
    plan_.replay = &shown;
    begin();
    EXPECT_EQ(shared_.replay.target, 5U);
    EXPECT_EQ(shared_.replay.speed, 0.5);
    EXPECT_FALSE(shared_.seats[0].hands) << "a replay has no players at the devices";
    pause(0);
    EXPECT_FALSE(session_->menu().is_open()) << "a pause in the log opens no menu";
    EXPECT_FALSE(screen().hud.can_play_again);
    EXPECT_EQ(screen().hud.replay->length, 8U);
    press("v");
    session_->publish_screen();
    EXPECT_EQ(screen().hud.watch, game::Watch::first);
    EXPECT_EQ(screen().hud.names, (game::PlayerNames{"Ada", "Bot 1"}));
    EXPECT_EQ(screen().hud.replay->eyes, "Ada's eyes");
    const auto track = game::lay_out_replay_bar(1, rig::window).track;
    session_->cursor(track.high, rig::window);
    session_->mouse_button(0, true, rig::window, now_);
    EXPECT_EQ(shared_.replay.target, 8U);
    EXPECT_FALSE(shared_.stop);
    press("escape");
    EXPECT_TRUE(shared_.stop);
}

// ---- the pause's menu -------------------------------------------------------------------------------------

TEST_F(LiveSessionTest, ASettingChangedInThePauseReachesFileScreenAndHands) {
    const rig::TestPath file("settings.toml");
    plan_.settings_file = file.path;
    ASSERT_TRUE(load_settings(plan_.settings_file, plan_.assets));
    begin();
    pause(0);
    for (const auto* key : {"down", "down", "enter", "down", "down", "right"}) press(key);
    step();
    EXPECT_EQ(screen().hud.fov, 95);
    enter("Each player's own settings");
    choose("Mouse speed");
    press("right");
    step();
    const auto saved =
        parse_settings(read_text_file(plan_.settings_file, 1U << 20U).value(), "settings").value();
    EXPECT_EQ(saved.fov, 95);
    EXPECT_DOUBLE_EQ(saved.players[0].sensitivity, 1.05);
    EXPECT_DOUBLE_EQ(saved.players[1].sensitivity, 1);
    go_on();
    session_->mouse_move(100, 0, now_);
    EXPECT_EQ(sample(0).counts[input::hand::look_right], 105);
}

TEST_F(LiveSessionTest, AnotherKeyActsAtOnce) {
    begin();
    pause(0);
    for (const auto* key : {"down", "enter", "enter"}) press(key);
    choose("Move forward");
    for (const auto* key : {"enter", "i"}) press(key);
    step();
    go_on();
    session_->key(rig::key("i"), true, now_);
    EXPECT_EQ(sample(0).counts[input::hand::forward], 127);
}

TEST_F(LiveSessionTest, ThePauseOfTheRangeChangesTheDummy) {
    plan_.practice = game::DummyKind::strafing;
    plan_.seats = {rig::mouse_seat, live::Seat{.kind = SeatKind::dummy}};
    session_.emplace(shared_, plan_);
    EXPECT_EQ(requests().dummy, game::DummyKind::strafing);
    ASSERT_TRUE(session_->next().open_range());
    session_->take_seats({});
    session_->begin_match({});
    pause(0);
    press("down");
    press("right");
    step();
    EXPECT_EQ(requests().dummy, game::DummyKind::shooting);
}

TEST_F(LiveSessionTest, ThePauseOfTheRangeChangesItsRules) {
    begin_range();
    ASSERT_TRUE(session_->next().take_range());
    pause(0);
    choose("Energy of the wands");
    press("right");
    choose("Effects of the brew");
    press("right");
    step();
    EXPECT_EQ(requests().range.load(), (game::RangeChanges{.endless_energy = true, .harmless_brew = true}));
    enter("Restart the range");
    step();
    EXPECT_TRUE(requests().end);
    EXPECT_TRUE(session_->take_restart());
    EXPECT_TRUE(session_->next().is_practice()) << "the files were read again";
}

TEST_F(LiveSessionTest, ThePauseOfTheApprenticeSkipsRepeatsAndRestarts) {
    plan_.practice = game::DummyKind::still;
    plan_.seats = {rig::mouse_seat, live::Seat{.kind = SeatKind::dummy}};
    session_.emplace(shared_, plan_);
    ASSERT_TRUE(session_->next().open_apprentice());
    session_->take_seats({});
    session_->begin_match({});
    ASSERT_TRUE(session_->next().take_range() && session_->next().take_lessons());
    const auto chosen = [&](std::string_view row) {
        pause(0);
        enter(row);
        step();
    };
    chosen("Skip this step");
    EXPECT_TRUE(asked_range<SkipStep>());
    chosen("Repeat this step");
    EXPECT_TRUE(asked_range<RepeatStep>());
    EXPECT_EQ(requests().go_on, 0U) << "and the match goes on";
    chosen("Restart the Apprentice");
    EXPECT_TRUE(requests().end && session_->take_restart());
    EXPECT_TRUE(session_->next().is_apprentice()) << "the lessons were read again";
}

TEST_F(LiveSessionTest, ThePauseOfTheRangeFindsTheLargestForceByFeel) {
    begin_range();
    pause(0);
    for (const auto* row : {"Settings", "Forces and body", "Find it by feel"}) enter(row);
    step();
    EXPECT_TRUE(asked_range<FindForce>());
    EXPECT_EQ(requests().go_on.load(), 0U) << "and the match goes on";
    shared_.progress.found_force = 35;
    step();
    const auto& found = session_->menu().settings().players[0];
    EXPECT_EQ(force_percent_of(found), 35U);
    EXPECT_EQ(shared_.seats[0].faders->take(), (input::FaderChange{1, 35})) << "it counts at once";
}

TEST_F(LiveSessionTest, RestartingInThePauseEndsTheMatchAndBeginsAnother) {
    begin();
    pause(0);
    enter("Restart the match");
    EXPECT_FALSE(requests().end);
    step();
    EXPECT_TRUE(requests().end);
    EXPECT_FALSE(shared_.stop);
    EXPECT_TRUE(session_->take_restart());
    EXPECT_FALSE(session_->take_restart()) << "once";
}

TEST_F(LiveSessionTest, EndingTheMatchInThePauseEndsItAndNotTheProgram) {
    plan_.start_screen = true;
    begin();
    pause(game::no_player);
    press("q");
    step();
    EXPECT_TRUE(requests().end);
    EXPECT_FALSE(shared_.stop);
}

// ---- faults of arms ---------------------------------------------------------------------------------------

TEST_F(LiveSessionTest, AFaultOfAnArmIsShownToItsPlayer) {
    begin();
    auto arm = std::make_unique<LiveArm>();
    arm->player = 0;
    arm->notice = {"Touch (gone)", "The arm's motors are too warm: let them rest"};
    shared_.arms.push_back(std::move(arm));
    session_->publish_screen();
    EXPECT_EQ(screen().hud.device_messages[0], "The arm's motors are too warm: let them rest");
    EXPECT_EQ(screen().hud.device_messages[1], "");
    shared_.arms.clear();
}

// ---- what is published for the screen ---------------------------------------------------------------------

TEST_F(LiveSessionTest, TheScreenIsPublishedOnlyWhenItChanges) {
    begin();
    session_->publish_screen();
    shared_.screen.take();
    step();
    EXPECT_FALSE(shared_.screen.take());
    pause(0);
    EXPECT_TRUE(shared_.screen.take());
    step();
    EXPECT_FALSE(shared_.screen.take());
    press("down");
    step();
    EXPECT_TRUE(shared_.screen.take());
}

TEST_F(LiveSessionTest, WaitsForEventsAsLongAsNothingMustBePolled) {
    begin();
    EXPECT_DOUBLE_EQ(session_->patience_s(), 0.004) << "pads send no events";
    EXPECT_TRUE(session_->needs_pads());
    plan_.seats = {rig::mouse_seat, rig::bot_seat};
    begin();
    EXPECT_DOUBLE_EQ(session_->patience_s(), 0.25);
    EXPECT_FALSE(session_->needs_pads());
    EXPECT_EQ(session_->plan().seats[1].kind, SeatKind::bot);
    session_->focus(false, now_);
    EXPECT_DOUBLE_EQ(session_->patience_s(), 0.05);
    pause(0);
    session_->step_match(std::nullopt, now_);
    EXPECT_DOUBLE_EQ(session_->patience_s(), 0.016);
    EXPECT_TRUE(session_->needs_pads());
}

}  // namespace
}  // namespace thaum::game
