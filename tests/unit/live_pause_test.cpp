// Tests of a lost focus, of the time after the round's end, and of the words on the pause.
#include "game/app/live_pause.h"

#include <gtest/gtest.h>

#include "unit/live_rig.h"

namespace thaum::app {
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
    EXPECT_EQ(pause_words(0, {}), (PauseWords{"Paused", "by player 1"}));
    EXPECT_EQ(pause_words(1, {}), (PauseWords{"Paused", "by player 2"}));
    EXPECT_EQ(pause_words(game::no_player, {}), (PauseWords{"Paused", ""}));
    const std::string help = "press a button on it to rejoin, or keypad 0 for half of the keyboard";
    EXPECT_EQ(pause_words(0, {true, false}), (PauseWords{"Player 1: pad lost", help}));
    EXPECT_EQ(pause_words(1, {false, true}), (PauseWords{"Player 2: pad lost", help}));
}

}  // namespace
}  // namespace thaum::app
