// The likely gesture of an unfinished stroke.
#include "gesture/prefix.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gesture/evaluation.h"
#include "gesture/generated_users.h"
#include "gesture/variations.h"
#include "unit/allocations.h"
#include "unit/gesture_shapes.h"

namespace thaum::gesture {
namespace {

PrefixReader reader_of(const std::vector<Gesture>& gestures) {
    auto made = PrefixReader::make(gestures);
    EXPECT_TRUE(made) << (made ? "" : made.error().message);
    return std::move(*made);
}

struct Score {
    double right{}, told{}, told_right{};
};

/// How strokes of the game's spells by unknown users are read at a share of their length.
Score score_at(double share) {
    static const auto reader = reader_of(generated_templates(1));
    static const auto strokes = generated_strokes({.users = 12, .samples = 1, .seed = 5});
    PrefixSpace space;
    Score score;
    for (const auto& stroke : strokes) {
        const auto likely = reader.read(beginning_of(stroke.points, share), space);
        const bool right =
            likely.gesture != LikelyGesture::none && reader.name(likely.gesture) == stroke.gesture;
        const bool told = likely.probability >= likely_enough;
        score.right += right;
        score.told += told;
        score.told_right += told && right;
    }
    score.told_right /= score.told;
    for (double* share_of : {&score.right, &score.told}) *share_of /= static_cast<double>(strokes.size());
    return score;
}

TEST(GesturePrefix, HalfOfAStrokeTellsTheSpell) {
    const auto half = score_at(0.5);
    EXPECT_GE(half.right, 0.93);
    EXPECT_GE(half.told, 0.7);
    EXPECT_GE(half.told_right, 0.97) << "no false colour";
}

TEST(GesturePrefix, AQuarterIsToldOnlyWhereItIsSure) {
    const auto quarter = score_at(0.25);
    EXPECT_GE(quarter.right, 0.85);
    EXPECT_GE(quarter.told_right, 0.95);
}

TEST(GesturePrefix, AWholeStrokeIsItself) {
    const auto whole = score_at(1);
    EXPECT_GE(whole.right, 0.99);
    EXPECT_GE(whole.told, 0.85);
}

/// A line may become each of two hooks, which turn only at the end.
TEST(GesturePrefix, WhatMayBecomeEitherIsNotTold) {
    const auto hook = [](double side) {
        return drawn([side](double s) { return vec3(s, s > 0.6 ? side * (s - 0.6) : 0, 0); });
    };
    const auto reader = reader_of({gesture_of("left", {hook(1)}), gesture_of("right", {hook(-1)})});
    PrefixSpace space;
    EXPECT_LT(reader.read(beginning_of(hook(1), 0.5), space).probability, likely_enough);
    const auto later = reader.read(beginning_of(hook(1), 0.95), space);
    EXPECT_EQ(later.gesture, 0U);
    EXPECT_GT(later.probability, likely_enough);
}

TEST(GesturePrefix, ClosedStrokesStartAnywhereAndOthersMayGoBackwards) {
    const GestureOptions closed{.closed = true}, any{.direction_sensitive = false};
    const auto reader =
        reader_of({gesture_of("circle", {circle()}, closed), gesture_of("ess", {ess()}, any)});
    PrefixSpace space;
    for (const double start : {0.5, 2.0, 4.0})
        EXPECT_EQ(reader.read(beginning_of(circle(start), 0.6), space).gesture, 0U) << start;
    auto back = ess();
    std::reverse(back.begin(), back.end());
    for (std::size_t i = 0; i < back.size(); ++i) back[i].t = 0.008 * static_cast<double>(i);
    EXPECT_EQ(reader.read(beginning_of(back, 0.6), space).gesture, 1U);
}

TEST(GesturePrefix, NoStrokeIsTooStrangeToRead) {
    const auto reader = reader_of(three_gestures());
    PrefixSpace space;
    const double nan = std::nan("");
    const std::vector<Course> strange{{},
                                      {{}},
                                      {{0, {1, 1, 1}}, {1, {1, 1, 1}}},
                                      {{0, {0, 0, 0}}, {1, {nan, 0, 0}}},
                                      {{0, {0, 0, 0}}, {1, {1e308, -1e308, 0}}},
                                      {{5, {0, 0, 0}}, {1, {1e-300, 0, 0}}}};
    for (const auto& stroke : strange) {
        for (const double share : {0.0, 0.5, 1.0, nan}) {
            const auto likely = reader.read(beginning_of(stroke, share), space);
            EXPECT_TRUE(likely.probability >= 0 && likely.probability <= 1);
        }
    }
}

TEST(GesturePrefix, ReadingAllocatesNothingAndRepeats) {
    const auto reader = reader_of(three_gestures());
    PrefixSpace space;
    const auto stroke = ess();
    const auto first = reader.read(stroke, space);
    const auto before = test::allocations();
    const auto again = reader.read(stroke, space);
    EXPECT_EQ(test::allocations(), before);
    EXPECT_EQ(again.probability, first.probability);
    EXPECT_EQ(again.evidence.distance, first.evidence.distance);
}

TEST(GesturePrefix, AGestureWithoutAShapeIsRefused) {
    EXPECT_FALSE(PrefixReader::make({}));
    const std::vector<Gesture> empty{gesture_of("empty", {})}, still{gesture_of("still", {{{}, {}}})};
    EXPECT_FALSE(PrefixReader::make(empty));
    EXPECT_FALSE(PrefixReader::make(still));
}

}  // namespace
}  // namespace thaum::gesture
