// Tests of losing the window's focus, of the time after the end of a round, and of the texts of the pause.
#include "game/live/pause.h"

#include <gtest/gtest.h>

#include "unit/live_rig.h"

namespace thaum::game {
namespace {

TEST(FocusLossTest, OnlyALossThatLastsCounts) {
    FocusLoss focus;
    EXPECT_FALSE(focus.lasts(1000 * rig::ms)) << "a window has the focus at first";
    focus.changed(false, 1000 * rig::ms);
    EXPECT_TRUE(focus.pending());
    EXPECT_FALSE(focus.lasts(1150 * rig::ms));
    EXPECT_TRUE(focus.lasts(1151 * rig::ms));
    focus.changed(true, 1200 * rig::ms);
    EXPECT_FALSE(focus.pending());
    EXPECT_FALSE(focus.lasts(5000 * rig::ms));
}

TEST(FocusLossTest, CountsOnceUntilTheNextLoss) {
    FocusLoss focus;
    focus.changed(false, 1000 * rig::ms);
    ASSERT_TRUE(focus.lasts(2000 * rig::ms));
    focus.handled();
    EXPECT_FALSE(focus.lasts(3000 * rig::ms));
    focus.changed(false, 4000 * rig::ms);
    EXPECT_TRUE(focus.lasts(5000 * rig::ms));
}

TEST(RoundEndTest, TheResultIsSeenBeforeAKeyLeavesIt) {
    RoundEnd end;
    for (const auto state : {PlayState::playing, PlayState::paused}) {
        end.follow(state, 1000 * rig::ms);
        EXPECT_FALSE(end.may_leave(9000 * rig::ms));
    }
    end.follow(PlayState::over, 10'000 * rig::ms);
    end.follow(PlayState::over, 10'700 * rig::ms);
    EXPECT_FALSE(end.may_leave(10'800 * rig::ms));
    EXPECT_TRUE(end.may_leave(10'801 * rig::ms));
    end.follow(PlayState::playing, 11'000 * rig::ms);
    EXPECT_FALSE(end.may_leave(20'000 * rig::ms)) << "the next round of the match goes on";
}

TEST(PauseWordsTest, NameThePlayerOrTheLostPad) {
    EXPECT_EQ(pause_words({.paused_by = 0}), (PauseWords{"Paused", "by Ember"}));
    EXPECT_EQ(pause_words({.paused_by = 1, .names = {"", "Zoë"}}), (PauseWords{"Paused", "by Zoë"}));
    EXPECT_EQ(pause_words({}), (PauseWords{"Paused", ""}));
    const std::string help = "plug it in and press a button on it or on a free pad";
    EXPECT_EQ(pause_words({.lost_pad = {2, std::nullopt}}),
              (PauseWords{"Pad 3 of Ember is not plugged in", help, "pad 3 of Ember is not plugged in", ""}));
    EXPECT_EQ(pause_words({.lost_pad = {std::nullopt, 0},
                           .heir_of_half = 1,
                           .names = {"", "Zoë"},
                           .key_for_half = "Keypad 0"}),
              (PauseWords{"Pad 1 of Zoë is not plugged in", help + ", or Keypad 0 for half of the keyboard",
                          "pad 1 of Zoë is not plugged in", "Zoë"}));
    EXPECT_EQ(pause_words({.focus_lost = true, .lost_pad = {0, 1}}).head,
              "Pad 1 of Ember and pad 2 of Tide are not plugged in");
}

TEST(PauseWordsTest, APadThatIsPluggedInAgainIsNotMissing) {
    EXPECT_EQ(pause_words({.lost_pad = {0, std::nullopt}, .plugged_again = {true, false}}),
              (PauseWords{"Pad 1 of Ember is plugged in again", "press a button on it to go on"}));
    EXPECT_EQ(pause_words({.lost_pad = {0, 1}, .plugged_again = {true, false}}).head,
              "Pad 2 of Tide is not plugged in");
    EXPECT_EQ(pause_words({.lost_pad = {0, 1}, .plugged_again = {true, true}}).head,
              "Pad 1 of Ember and pad 2 of Tide are plugged in again");
}

TEST(PauseWordsTest, SayThatTheWindowLostTheFocus) {
    EXPECT_EQ(pause_words({.paused_by = 0, .focus_lost = true}),
              (PauseWords{"Paused", "the window lost the focus"}));
}

}  // namespace
}  // namespace thaum::game
