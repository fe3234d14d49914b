// Tests of recognising the likely gesture of an unfinished stroke.
#include "gesture/prefix.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gesture/generated_users.h"
#include "gesture/recogniser.h"
#include "gesture/trials/evaluation.h"
#include "gesture/variations.h"
#include "unit/allocations.h"
#include "unit/gesture_shapes.h"

namespace thaum::gesture {
namespace {

PrefixReader reader_of(const std::vector<Gesture>& gestures) { return PrefixReader::make(gestures).value(); }

struct Score {
    double right{}, told{}, told_right{};
};

/// How often strokes of the game's spells, by users whom the recogniser does not know, are recognised when
/// only this share of their length is drawn.
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
    EXPECT_GE(half.right, 0.96) << "also of those who draw gently or harshly, thus slowly or fast";
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

/// Statistics of the likely gestures that are named while unknown users draw, recognised anew at every
/// fiftieth of a stroke's length.
struct AnswerCourse {
    double told{};     ///< share of recognitions that give an answer, counted after a quarter of the stroke
    double wrong{};    ///< share of the answers after a quarter of the stroke that are wrong
    double changes{};  ///< number of answers in a stroke that disappear again or are replaced (mean)
    double at_end{};   ///< share of complete strokes that get an answer
};

AnswerCourse course_of(const PrefixReader& reader, std::span<const Stroke> strokes) {
    PrefixSpace space;
    AnswerCourse course;
    double readings = 0;
    for (const auto& stroke : strokes) {
        std::uint32_t told = LikelyGesture::none;
        for (int k = 1; k <= 50; ++k) {
            const auto before = told;
            told = reader.tell(beginning_of(stroke.points, k / 50.0), told, space);
            const bool any = told != LikelyGesture::none;
            if (before != LikelyGesture::none && told != before) ++course.changes;
            if (k == 50) course.at_end += any;
            if (4 * k <= 50) continue;
            ++readings;
            course.told += any;
            course.wrong += any && reader.name(told) != stroke.gesture;
        }
    }
    for (double* share : {&course.changes, &course.at_end}) *share /= static_cast<double>(strokes.size());
    for (double* share : {&course.told, &course.wrong}) *share /= readings;
    return course;
}

TEST(GesturePrefix, WhatIsToldStays) {
    const auto reader = reader_of(generated_templates(1));
    const auto course = course_of(reader, generated_strokes({.users = 12, .samples = 1, .seed = 5}));
    EXPECT_GE(course.told, 0.88);
    EXPECT_LE(course.wrong, 0.01) << "no false colour";
    EXPECT_LE(course.changes, 0.15) << "no flicker";
    EXPECT_GE(course.at_end, 0.98);
}

TEST(GesturePrefix, WhatIsToldGoesWhenTheStrokeLeavesIt) {
    const auto reader = reader_of(three_gestures());
    PrefixSpace space;
    const auto told = reader.tell(beginning_of(ess(), 0.7), LikelyGesture::none, space);
    ASSERT_NE(told, LikelyGesture::none);
    auto astray = ess();
    const auto at = astray.back().at;
    for (int i = 1; i <= 200; ++i) {
        const double u = 0.1 * i;
        astray.push_back({1 + 0.01 * i, at + 0.3 * u * vec3(std::cos(3 * u), std::sin(3 * u), 0), 0});
    }
    EXPECT_NE(reader.tell(astray, told, space), told);
    EXPECT_EQ(reader.tell({}, told, space), LikelyGesture::none);
    EXPECT_EQ(reader.tell({}, 77, space), LikelyGesture::none) << "a gesture that is not there";
}

/// A stroke with a force that rises until its middle and falls again, as in a viscous field.
Course swelling(Course stroke, double force) {
    for (auto& p : stroke) p.force = force * (0.3 + std::sin(pi * p.t));
    return stroke;
}

TEST(GesturePrefix, ForceTellsTwinsApartOrNothingDoes) {
    const auto reader =
        reader_of({gesture_of("soft", {swelling(ess(), 0.5)}), gesture_of("hard", {swelling(ess(), 2.5)}),
                   gesture_of("circle", {swelling(circle(), 1)})});
    PrefixSpace space;
    for (const double share : {0.5, 0.75, 1.0}) {
        const auto told = [&](double force) {
            const auto stroke = swelling(ess(), force);
            return reader.tell(beginning_of(stroke, share), LikelyGesture::none, space);
        };
        EXPECT_EQ(told(0.4), 0U) << share;
        EXPECT_EQ(told(0.6), 0U) << share;
        EXPECT_EQ(told(2), 1U) << share;
        EXPECT_EQ(told(3), 1U) << share;
        EXPECT_EQ(told(1.118), LikelyGesture::none) << "as far from both, at " << share;
        EXPECT_EQ(told(0), LikelyGesture::none) << "a device without a force, at " << share;
    }
}

/// Twins are two gestures that only their force tells apart. Here they are an S drawn softly and a bowed S
/// drawn hard. Their shapes count as equal, because the circle, the only other gesture, is far from both.
TEST(GesturePrefix, TwinsAreThoseOfTheRecogniserOfWholeStrokes) {
    auto bowed = ess();
    for (auto& p : bowed) p.at.x += 1.4 * std::sin(pi * p.t);
    const std::vector<Gesture> gestures{gesture_of("soft", {swelling(ess(), 0.5)}),
                                        gesture_of("hard", {swelling(bowed, 2.5)}),
                                        gesture_of("circle", {swelling(circle(), 1)})};
    ASSERT_TRUE(Recogniser::make(gestures, {.calibrate = false}).value().are_twins(0, 1));
    PrefixSpace space;
    const auto told = [&](const PrefixReader& reader, double force) {
        return reader.tell(swelling(ess(), force), LikelyGesture::none, space);
    };
    const auto reader = reader_of(gestures);
    EXPECT_EQ(told(reader, 0.5), 0U);
    EXPECT_EQ(told(reader, 1.118), LikelyGesture::none) << "as far from both";
    // If the recogniser does not compare forces (its second channel is off), the force of a stroke makes no
    // difference.
    const auto without = PrefixReader::make(std::vector<Gesture>{gesture_of("soft", {swelling(ess(), 0.5)}),
                                                                 gesture_of("hard", {swelling(ess(), 2.5)}),
                                                                 gesture_of("circle", {circle()})},
                                            {.channels = {true, false}})
                             .value();
    EXPECT_EQ(without.read(swelling(ess(), 0.5), space).probability,
              without.read(swelling(ess(), 1.118), space).probability);
}

/// A line may become either of two hooks, which turn only at the end, so until then neither may be named.
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
