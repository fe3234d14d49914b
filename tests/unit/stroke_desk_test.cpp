// Tests of the window of `thaum gesture record`: it counts strokes that a match would recognise, and says
// what is wrong with others.
#include <gtest/gtest.h>

#include "game/app/gesture/stroke_window.h"

namespace thaum::game {
namespace {

/// Feeds a straight stroke to the window, then the release of the button.
void draw(StrokeDesk& desk, double metres, double lasts, double tremor = 0) {
    static double t = 0;
    const int points = static_cast<int>(1000 * lasts);
    for (int i = 0; i <= points; ++i) {
        const double u = i / static_cast<double>(points);
        desk.recorder().feed({t += 0.001, vec3(metres * u + (i % 2) * tremor, 0, 0), 1}, true);
    }
    desk.recorder().feed({t += 0.001, vec3(0), 0}, false);
    desk.take_ended();
}

TEST(StrokeDesk, RefusesAtOnceWhatNoMatchReads) {
    StrokeDesk desk({.name = "line", .count = 2, .device = "mouse"});
    draw(desk, 0, 0.3);
    EXPECT_NE(desk.note().find("press without a stroke"), std::string::npos) << desk.note();
    draw(desk, 0, 0.3, 2e-4);
    EXPECT_NE(desk.note().find("press without a stroke"), std::string::npos) << "tremor is no stroke";
    draw(desk, 0.01, 0.3);
    EXPECT_EQ(desk.note(), "a stroke of 10 mm is too small to be read: draw it larger");
    draw(desk, 0.1, 0.05);
    EXPECT_EQ(desk.note(), "a stroke of 0.05 s is too short to be read: draw it more slowly");
    EXPECT_EQ(desk.title(), "line: stroke 1 of 2");
    draw(desk, 0.1, 0.3);
    EXPECT_EQ(desk.note(), "");
    EXPECT_EQ(desk.title(), "line: stroke 2 of 2");
}

TEST(StrokeDesk, CountsAgainWhatWasTakenBack) {
    StrokeDesk desk({.name = "line", .count = 2, .device = "mouse"});
    draw(desk, 0.1, 0.3);
    desk.key("Backspace");
    desk.take_ended();
    EXPECT_EQ(desk.title(), "line: stroke 1 of 2");
    draw(desk, 0, 0.3);
    EXPECT_EQ(desk.title(), "line: stroke 1 of 2");
    draw(desk, 0.1, 0.3);
    draw(desk, 0.1, 0.3);
    EXPECT_TRUE(desk.complete());
}

}  // namespace
}  // namespace thaum::game
