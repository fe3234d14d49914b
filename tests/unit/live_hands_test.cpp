// Tests of the players' input devices: pads that are unplugged and plugged in again, half of the keyboard,
// and new bindings.
#include "game/live/hands.h"

#include <gtest/gtest.h>

#include "unit/live_rig.h"

namespace thaum::game {
namespace {

using input::Button;
using input::PadAxis;
using input::PadButton;

/// Player 1 has mouse and keyboard, player 2 the first pad.
class PlayerHandsTest : public testing::Test {
protected:
    PlayerHandsTest() { hands_.begin_match(settings_, {rig::pad_with()}); }

    HandNews look(const input::PadState& first, const input::PadState& second = {}, bool menu_open = false) {
        return hands_.look({first, second}, settings_, menu_open);
    }
    input::DeviceSample sample(std::uint32_t player = 1) { return rig::taken(seats_, player); }

    const Settings settings_{};
    TakenSeats seats_ = rig::seats_for(rig::mouse_seat, rig::first_pad_seat);
    PlayerHands hands_{seats_};
    const input::PadState unplugged_{}, idle_ = rig::pad_with(), pressed_ = rig::pad_with({PadButton::a}),
                                        full_trigger_ = rig::pad_at(PadAxis::right_trigger, 1);
    const int keypad_zero_ = rig::key("kp_0"), keypad_eight_ = rig::key("kp_8");
};

TEST_F(PlayerHandsTest, ALostPadIsReportedOnceAndReleasesWhatItHeld) {
    const auto playing = look(full_trigger_);
    EXPECT_FALSE(playing.lost);
    EXPECT_EQ(sample().counts[input::hand::trigger], 255);
    const auto news = look(unplugged_);
    EXPECT_EQ(news.lost, 1U);
    EXPECT_FALSE(news.all_back);
    EXPECT_TRUE(hands_.is_lost(1));
    EXPECT_FALSE(hands_.is_lost(0));
    EXPECT_EQ(sample().counts[input::hand::trigger], 0);
    EXPECT_FALSE(look(unplugged_).lost);
    EXPECT_TRUE(hands_.is_lost(1));
}

TEST_F(PlayerHandsTest, AButtonOfThePadBringsItsPlayerBack) {
    look(unplugged_);
    const auto plugged = look(idle_);
    EXPECT_TRUE(hands_.is_lost(1)) << "plugging in is no press";
    EXPECT_FALSE(plugged.all_back);
    EXPECT_FALSE(look(full_trigger_).all_back);
    EXPECT_EQ(sample().counts[input::hand::trigger], 0) << "before the player is back";
    const auto news = look(pressed_);
    EXPECT_EQ(news.all_back, 1U);
    EXPECT_TRUE(news.used[0]);
    EXPECT_FALSE(hands_.is_lost(1));
}

TEST_F(PlayerHandsTest, ButtonsHeldOverARejoinAreIgnoredUntilReleased) {
    look(unplugged_);
    look(pressed_);
    EXPECT_FALSE(look(pressed_).used[0]) << "only the press that brings the player back";
    EXPECT_FALSE(rig::is_down(sample(), Button::jump));
    look(idle_);
    EXPECT_FALSE(rig::is_down(sample(), Button::jump));
    look(pressed_);
    EXPECT_TRUE(rig::is_down(sample(), Button::jump));
}

TEST_F(PlayerHandsTest, ButtonsHeldAtTheStartAreIgnoredUntilReleased) {
    hands_.begin_match(settings_, {pressed_});
    look(pressed_);
    EXPECT_FALSE(rig::is_down(sample(), Button::jump));
    look(idle_);
    look(pressed_);
    EXPECT_TRUE(rig::is_down(sample(), Button::jump));
}

TEST_F(PlayerHandsTest, PadsDoNotActWhileAMenuIsOpenNorBeforeARelease) {
    look(pressed_, {}, true);
    EXPECT_FALSE(rig::is_down(sample(), Button::jump));
    look(pressed_);
    EXPECT_FALSE(rig::is_down(sample(), Button::jump)) << "the button that closed the menu";
    look(idle_);
    look(pressed_);
    EXPECT_TRUE(rig::is_down(sample(), Button::jump));
}

TEST_F(PlayerHandsTest, SticksPointUpwardsInTheMatch) {
    look(rig::pad_at(PadAxis::left_y, 1));
    EXPECT_EQ(sample().counts[input::hand::forward], 127);
}

TEST_F(PlayerHandsTest, HalfOfTheKeyboardTakesOverForALostPad) {
    EXPECT_FALSE(hands_.take_half(keypad_zero_, settings_)) << "the pad is there";
    look(unplugged_);
    EXPECT_FALSE(hands_.take_half(keypad_eight_, settings_)) << "only the key for the wand asks";
    const auto news = hands_.take_half(keypad_zero_, settings_);
    ASSERT_TRUE(news);
    EXPECT_EQ(news->all_back, 1U);
    EXPECT_FALSE(hands_.is_lost(1));
    hands_.each([&](auto& hands) { hands.key(keypad_eight_, true); });
    EXPECT_EQ(sample().counts[input::hand::forward], 127);
    EXPECT_EQ(sample(0).counts[input::hand::forward], 0) << "the mouse's player does not have that half";
    EXPECT_FALSE(look(unplugged_).lost) << "the player has a device";
}

TEST_F(PlayerHandsTest, APluggedPadCanBeTakenForItsPlayerWithoutAPress) {
    look(unplugged_);
    EXPECT_EQ(hands_.first_lost(), 1U);
    EXPECT_EQ(hands_.heir_of_half(), 1U);
    EXPECT_FALSE(hands_.is_plugged_again(1));
    EXPECT_FALSE(hands_.take_plugged_pads(settings_).all_back);
    EXPECT_TRUE(hands_.is_lost(1)) << "it is not plugged in";
    look(idle_);
    EXPECT_TRUE(hands_.is_plugged_again(1));
    EXPECT_FALSE(hands_.heir_of_half()) << "the player has the pad";
    EXPECT_EQ(hands_.take_plugged_pads(settings_).all_back, 1U);
    EXPECT_FALSE(hands_.first_lost());
    look(full_trigger_);
    EXPECT_EQ(sample().counts[input::hand::trigger], 255);
}

TEST_F(PlayerHandsTest, ThePadTakesItsPlayerBackFromTheHalf) {
    look(unplugged_);
    hands_.take_half(keypad_zero_, settings_);
    EXPECT_FALSE(look(idle_).all_back);
    EXPECT_EQ(look(pressed_).all_back, 1U);
    hands_.each([&](auto& hands) { hands.key(keypad_eight_, true); });
    EXPECT_EQ(sample().counts[input::hand::forward], 0);
    look(idle_);
    look(pressed_);
    EXPECT_TRUE(rig::is_down(sample(), Button::jump));
}

TEST_F(PlayerHandsTest, ARematchKeepsTheHalfAndTheStartScreenForgetsIt) {
    look(unplugged_);
    hands_.take_half(keypad_zero_, settings_);
    hands_.begin_match(settings_, {});
    hands_.each([&](auto& hands) { hands.key(keypad_eight_, true); });
    EXPECT_EQ(sample().counts[input::hand::forward], 127);
    hands_.leave_seats();
    EXPECT_FALSE(seats_[1].hands);
    seats_ = rig::seats_for(rig::mouse_seat, rig::first_pad_seat);
    hands_.begin_match(settings_, {});
    hands_.each([&](auto& hands) { hands.key(keypad_eight_, true); });
    EXPECT_EQ(sample().counts[input::hand::forward], 0);
}

TEST_F(PlayerHandsTest, TheHalfBelongsToOnePlayer) {
    seats_ = rig::seats_for(rig::half_seat, rig::first_pad_seat);
    hands_.begin_match(settings_, {idle_});
    look(unplugged_);
    EXPECT_FALSE(hands_.take_half(keypad_zero_, settings_)) << "player 1 has it";
    EXPECT_TRUE(hands_.is_lost(1));
}

TEST_F(PlayerHandsTest, TheMatchGoesOnWhenBothPlayersAreBack) {
    seats_ = rig::seats_for(rig::first_pad_seat, rig::second_pad_seat);
    hands_.begin_match(settings_, {idle_, idle_});
    look(unplugged_, unplugged_);
    EXPECT_TRUE(hands_.is_lost(0) && hands_.is_lost(1));
    const auto one = look(unplugged_, pressed_);
    EXPECT_FALSE(one.all_back);
    EXPECT_TRUE(one.used[1]);
    EXPECT_FALSE(one.used[0]);
    EXPECT_EQ(look(pressed_, pressed_).all_back, 0U);
}

TEST_F(PlayerHandsTest, TwoLostPadsComeBackInAnyOrderToTheirPlayers) {
    seats_ = rig::seats_for(rig::first_pad_seat, rig::second_pad_seat);
    hands_.begin_match(settings_, {idle_, idle_});
    look(unplugged_, idle_);
    EXPECT_EQ(look(unplugged_, unplugged_).lost, 1U);
    look(unplugged_, pressed_);
    EXPECT_TRUE(hands_.is_lost(0));
    EXPECT_FALSE(hands_.is_lost(1));
    EXPECT_EQ(look(pressed_, idle_).all_back, 0U);
    look(idle_, idle_);
    look(full_trigger_, idle_);
    EXPECT_EQ(sample(0).counts[input::hand::trigger], 255);
    EXPECT_EQ(sample(1).counts[input::hand::trigger], 0);
}

TEST_F(PlayerHandsTest, AFreePadStandsInForALostOne) {
    look(unplugged_, idle_);
    EXPECT_TRUE(hands_.is_lost(1));
    const auto news = look(unplugged_, pressed_);
    EXPECT_EQ(news.all_back, 1U);
    EXPECT_TRUE(news.used[1]);
    look(unplugged_, idle_);
    look(idle_, full_trigger_);
    EXPECT_EQ(sample().counts[input::hand::trigger], 255);
    look(full_trigger_, idle_);
    EXPECT_EQ(sample().counts[input::hand::trigger], 0) << "the pad that came back has no player";
    // The second pad belongs to the other player, so a press on it does not make it replace the pad that was
    // unplugged.
    seats_ = rig::seats_for(rig::first_pad_seat, rig::second_pad_seat);
    hands_.begin_match(settings_, {idle_, idle_});
    EXPECT_FALSE(look(unplugged_, pressed_).all_back);
    EXPECT_TRUE(hands_.is_lost(0));
}

TEST_F(PlayerHandsTest, NewSettingsReachTheHands) {
    auto settings = settings_;
    settings.bindings_of(input::DeviceKind::keyboard_mouse).of(input::Action::move_forward) = {
        {input::Control::Source::key, rig::key("i"), 0}};
    settings.players[0].sensitivity = 2 * settings_.players[0].sensitivity;
    settings.players[0].invert_y = !settings_.players[0].invert_y;
    settings.players[1].sensitivity = 7;  // changes nothing for player 1
    hands_.each([&](auto& hands) { hands.key(rig::key("w"), true); });
    EXPECT_EQ(sample(0).counts[input::hand::forward], 127);
    hands_.rebind(settings);
    EXPECT_EQ(sample(0).counts[input::hand::forward], 0) << "a key without its binding is released";
    hands_.each([&](auto& hands) {
        hands.key(rig::key("i"), true);
        hands.mouse_move(10, 10);
    });
    const auto current = sample(0);
    EXPECT_EQ(current.counts[input::hand::forward], 127);
    EXPECT_EQ(current.counts[input::hand::look_right], 20);
    EXPECT_EQ(current.counts[input::hand::look_up], 20);
    // The devices of the next match are made with the new sensitivity, so the input collector applies no
    // additional factor.
    hands_.begin_match(settings, {});
    hands_.each([&](auto& hands) { hands.mouse_move(10, 10); });
    EXPECT_EQ(sample(0).counts[input::hand::look_right], 10);
    EXPECT_EQ(sample(0).counts[input::hand::look_up], 0);
}

TEST_F(PlayerHandsTest, EachPlayersSticksRespondAsThatPlayerChose) {
    auto settings = settings_;
    settings.players[0].stick_dead_zone = 0.6;
    settings.players[1].stick_dead_zone = 0;
    settings.players[1].stick_curve = 0;
    for (auto& player : settings.players) player.turn_ramp_s = 0;
    seats_ = rig::seats_for(rig::first_pad_seat, rig::second_pad_seat);
    hands_.begin_match(settings, {idle_, idle_});
    const auto half = rig::pad_at(PadAxis::right_x, 0.5);
    const auto turn = [&](std::uint32_t player) { return sample(player).counts[input::hand::turn_right]; };
    look(half, half);
    EXPECT_EQ(turn(0), 0);
    EXPECT_NEAR(input::turn_share(turn(1) / 127.0), 0.5, 0.01);
    // A dead zone that is changed during a pause applies from the next position on.
    settings.players[0].stick_dead_zone = 0;
    settings.players[1].stick_dead_zone = 0.6;
    hands_.rebind(settings);
    look(half, half);
    EXPECT_EQ(turn(0), 64);
    EXPECT_EQ(turn(1), 0);
}

TEST_F(PlayerHandsTest, KnowsWhichKeysOfItsPlayersPause) {
    auto settings = settings_;
    settings.bindings_of(input::DeviceKind::keyboard_mouse).of(input::Action::pause) = {
        {input::Control::Source::key, rig::key("p"), 0}};
    settings.bindings_of(input::DeviceKind::keyboard_half).of(input::Action::pause) = {
        {input::Control::Source::key, rig::key("kp_7"), 0}};
    EXPECT_TRUE(hands_.pauses(rig::key("p"), settings));
    EXPECT_FALSE(hands_.pauses(rig::key("kp_7"), settings)) << "nobody has that half";
    look(unplugged_);
    hands_.take_half(keypad_zero_, settings);
    EXPECT_TRUE(hands_.pauses(rig::key("kp_7"), settings));
}

TEST_F(PlayerHandsTest, BotsHaveNoHands) {
    EXPECT_TRUE(hands_.any_mouse());
    EXPECT_TRUE(hands_.any_pad());
    seats_ = rig::seats_for(rig::bot_seat, rig::bot_seat);
    hands_.begin_match(settings_, {idle_});
    EXPECT_FALSE(hands_.any_mouse());
    EXPECT_FALSE(hands_.any_pad());
    hands_.each([](auto&) { FAIL(); });
    EXPECT_FALSE(look(unplugged_).lost);
    EXPECT_FALSE(hands_.take_half(keypad_zero_, settings_));
}

}  // namespace
}  // namespace thaum::game
