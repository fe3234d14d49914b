// Tests of the comparison of a stroke with a gesture, and of the advice for the player.
#include <gtest/gtest.h>

#include "gesture/comparison.h"
#include "gesture/generated_users.h"
#include "unit/gesture_shapes.h"

namespace thaum::gesture {
namespace {

Course turned_by(Course stroke, double angle) {
    for (auto& p : stroke) p.at = rotation({0, 0, 1}, angle) * p.at;
    return stroke;
}

std::string said(const Course& stroke, const Gesture& gesture, double force = 0.5, bool read = false) {
    std::string all;
    for (const auto& line : advice_on(compare(stroke, gesture), gesture, force, read)) all += line + "; ";
    return all;
}

TEST(GestureComparison, TheSameElsewhereAndLargerDoesNotDiffer) {
    const auto gesture = gesture_of("ess", {ess()});
    const auto c = compare(moved(ess(), {3, -2, 1}, 0.07), gesture);
    EXPECT_NEAR(c.size, 0.14, 0.002);
    EXPECT_NEAR(c.tilt, 0, 1e-9);
    EXPECT_LT(c.worst, 1e-6);
    EXPECT_FALSE(c.backwards);
    EXPECT_EQ(said(moved(ess(), {}, 0.07), gesture), "");
}

TEST(GestureComparison, TellsTiltAndItsSide) {
    const auto gesture = gesture_of("ess", {ess()}, {.rotation = 0.2});
    EXPECT_NEAR(compare(turned_by(ess(), 0.4), gesture).tilt, 0.4, 1e-6);
    EXPECT_EQ(said(turned_by(ess(), 0.4), gesture), "turn it 23 degrees to the right; ");
    EXPECT_EQ(said(turned_by(ess(), -0.4), gesture), "turn it 23 degrees to the left; ");
    EXPECT_EQ(said(turned_by(ess(), 0.15), gesture), "");
}

TEST(GestureComparison, TellsSizeAndForce) {
    const auto gesture = gesture_of("ess", {ess()}, {.gentle_below = 1, .harsh_above = 1.5});
    EXPECT_EQ(said(moved(ess(), {}, 0.01), gesture), "draw it larger: it has 2.0 cm; ");
    EXPECT_EQ(said(moved(ess(), {}, 0.01), gesture, 0.5, true), "") << "it was large enough to be read";
    EXPECT_EQ(said(ess(), gesture, 1.2), "slower for gentle, faster for harsh; ");
    EXPECT_EQ(said(ess(), gesture, 1.5), "");
}

TEST(GestureComparison, TellsASizeOutsideTheRangeOfTheGesture) {
    const auto gesture = gesture_of("ess", {ess()}, {.min_scale = 0.5, .max_scale = 2});
    EXPECT_NEAR(compare(moved(ess(), {}, 0.4), gesture).scale, 0.4, 1e-9);
    EXPECT_EQ(said(moved(ess(), {}, 0.4), gesture).find("draw it larger: "), 0U);
    EXPECT_EQ(said(moved(ess(), {}, 3), gesture).find("draw it smaller: "), 0U);
    EXPECT_EQ(said(moved(ess(), {}, 1.9), gesture), "");
}

TEST(GestureComparison, KnowsAShapeThatIsOnlyTurnedOrBegunAtTheWrongEnd) {
    const auto gesture = gesture_of("ess", {ess()}, {.rotation = 0.2});
    auto back = ess();
    std::reverse(back.begin(), back.end());
    EXPECT_TRUE(is_turned_copy(compare(back, gesture), gesture));
    EXPECT_EQ(said(back, gesture), "draw it from the other end; ");
    EXPECT_TRUE(is_turned_copy(compare(turned_by(ess(), 0.4), gesture), gesture));
    EXPECT_FALSE(is_turned_copy(compare(ess(), gesture), gesture));
    EXPECT_FALSE(is_turned_copy(compare(vee(), gesture), gesture));
    EXPECT_FALSE(is_turned_copy(compare({}, gesture), gesture));
}

TEST(GestureComparison, AClosedGestureMayStartAnywhereButEndsWhereItBegan) {
    const auto gesture =
        gesture_of("circle", {circle()}, {.direction_sensitive = false, .rotation = pi, .closed = true});
    for (const double start : {0.0, 1.0, 4.0}) {
        EXPECT_EQ(said(circle(start), gesture), "") << start;
        EXPECT_EQ(said(circle(start, -1), gesture), "") << start;
    }
    EXPECT_NE(said(circle(0, 0.8), gesture).find("end where you began"), std::string::npos);
}

TEST(GestureComparison, TellsTheWrongEnd) {
    auto back = ess();
    std::reverse(back.begin(), back.end());
    // An S turned by half a turn looks the same, so an asymmetrical stroke is needed to detect that the wrong
    // end comes first.
    const auto hook = drawn([](double u) { return vec3(u < 0.7 ? 0 : u - 0.7, u < 0.7 ? -2 * u : -1.4, 0); });
    auto wrong = hook;
    std::reverse(wrong.begin(), wrong.end());
    EXPECT_TRUE(compare(wrong, gesture_of("hook", {hook})).backwards);
    EXPECT_FALSE(compare(wrong, gesture_of("hook", {hook}, {.direction_sensitive = false})).backwards);
    EXPECT_EQ(said(wrong, gesture_of("hook", {hook})), "draw it from the other end; ");
}

TEST(GestureComparison, TellsThePartThatIsFarthestOff) {
    const auto gesture = gesture_of("vee", {vee()});
    auto bent = vee();
    for (auto& p : bent) p.at += vec3(0, p.at.x > 0.8 ? 2.5 * (0.8 - p.at.x) : 0, 0);
    EXPECT_NE(said(bent, gesture).find("the upper right is the farthest off"), std::string::npos)
        << said(bent, gesture);
    EXPECT_EQ(place_words({0.3, 0.02, 0}), "right");
    EXPECT_EQ(place_words({-0.3, -0.3, 0}), "lower left");
    EXPECT_EQ(place_words({0.01, 0.4, 0}), "top");
    EXPECT_EQ(place_words({0.05, -0.05, 0}), "middle");
}

TEST(GestureComparison, NothingAndEqualPointsHaveZeros) {
    const auto gesture = gesture_of("vee", {vee()});
    EXPECT_EQ(compare({}, gesture).size, 0);
    EXPECT_EQ(compare(Course(5, StrokePoint{}), gesture).size, 0);
    Course vertical;
    for (int i = 0; i < 5; ++i) vertical.push_back({0.1 * i, {0, 0, 0.1 * i}, 0});
    EXPECT_EQ(compare(vertical, gesture).size, 0) << "a way in depth alone";
}

TEST(GestureComparison, GoodStrokesOfUsersGetLittleAdvice) {
    const auto gestures = generated_templates(1);
    int lines = 0, strokes = 0;
    for (const auto& stroke : generated_strokes({.users = 20, .samples = 1, .seed = 5})) {
        const auto& g = *std::find_if(gestures.begin(), gestures.end(),
                                      [&](const auto& each) { return each.name == stroke.gesture; });
        lines += static_cast<int>(advice_on(compare(stroke.points, g), g, 0.5, true).size());
        ++strokes;
    }
    EXPECT_LT(lines, strokes) << "less than a line for each stroke";
}

}  // namespace
}  // namespace thaum::gesture
