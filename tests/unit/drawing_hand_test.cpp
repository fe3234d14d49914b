// Tests of the mouse as a hand that draws strokes outside of a match.
#include <gtest/gtest.h>

#include "game/app/gesture/drawing_hand.h"
#include "game/data/match_data.h"

namespace thaum::game {
namespace {

constexpr std::int64_t tick_of_mouse = 1'000'000;

DrawingMouse drawing_mouse() { return {game::load_match_data(game::find_assets(), {})->device, 0}; }

TEST(DrawingMouse, ACountMovesTheHandATenthOfAMillimetreAgainstTheField) {
    auto hand = drawing_mouse();
    gesture::StrokeRecorder recorder;
    hand.press(true);
    std::int64_t now = 0;
    for (int i = 0; i < 100; ++i) {  // for a second, the mouse moves 10 counts right and 5 up in each 10 ms
        hand.move(10, -5);
        hand.advance(now += 10 * tick_of_mouse, recorder);
    }
    const double speed = std::hypot(0.1, 0.05);
    EXPECT_NEAR(recorder.open().back().force, gesture::stroke_viscosity * speed, 0.01);
    hand.advance(now += 200 * tick_of_mouse, recorder);
    hand.press(false);
    hand.advance(now += tick_of_mouse, recorder);
    ASSERT_EQ(recorder.strokes().size(), 1U);
    const auto& stroke = recorder.strokes()[0];
    EXPECT_EQ(stroke.size(), 1200U) << "a point a millisecond";
    EXPECT_NEAR(stroke.back().t, 1.199, 1e-9);
    // Dry friction of the simulated device's mechanism keeps the hand a little short of the target.
    EXPECT_NEAR(stroke.back().at.x, 0.1, 1e-3);
    EXPECT_NEAR(stroke.back().at.y, 0.05, 1e-3);
    EXPECT_EQ(stroke.back().at.z, 0);
    EXPECT_NEAR(stroke.back().force, 0, 1e-6);
}

TEST(DrawingMouse, EveryStrokeBeginsInTheMiddleAndHasNoEdge) {
    auto hand = drawing_mouse();
    gesture::StrokeRecorder recorder;
    std::int64_t now = 0;
    for (int stroke = 0; stroke < 2; ++stroke) {
        hand.move(5000, 5000);  // moves to the start of the next stroke
        hand.advance(now += 50 * tick_of_mouse, recorder);
        hand.press(true);
        for (int i = 0; i < 40; ++i) {
            hand.move(-100, 0);
            hand.advance(now += 10 * tick_of_mouse, recorder);
        }
        hand.press(false);
        hand.advance(now += tick_of_mouse, recorder);
    }
    ASSERT_EQ(recorder.strokes().size(), 2U);
    for (const auto& stroke : recorder.strokes()) {
        EXPECT_NEAR(stroke.front().at.x, 0, 1e-3);
        EXPECT_LT(stroke.back().at.x, -0.35) << "far beyond the edge of the arm";
    }
    EXPECT_EQ(recorder.strokes()[0].back().at, recorder.strokes()[1].back().at);
    recorder.drop_last();
    EXPECT_EQ(recorder.strokes().size(), 1U);
    EXPECT_TRUE(recorder.open().empty());
}

TEST(DrawingMouse, ALongStopIsNoLongStroke) {
    auto hand = drawing_mouse();
    gesture::StrokeRecorder recorder;
    hand.press(true);
    hand.advance(100 * tick_of_mouse, recorder);
    hand.advance(100'000 * tick_of_mouse, recorder);
    EXPECT_EQ(recorder.open().size(), 350U);
}

}  // namespace
}  // namespace thaum::game
