// Hostile strokes: for each, every method of recognition must answer, or correctly refuse, in bounded time.
#include <gtest/gtest.h>

#include <limits>

#include "gesture/recogniser.h"
#include "gesture/trials/dot.h"
#include "gesture/trials/methods.h"
#include "gesture/trials/stroke_networks.h"
#include "unit/gesture_shapes.h"
#include "unit/message_of.h"

namespace thaum::gesture {
namespace {

constexpr std::uint32_t nothing = 0xffffffff;

std::vector<std::pair<std::string, Course>> strokes_without_a_shape() {
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();
    auto broken = ess();
    broken[50].at.y = nan;
    auto endless = ess();
    endless[99].at.x = inf;
    auto untimed = ess();
    untimed[10].t = nan;
    auto unforced = ess();
    unforced[10].force = -inf;
    return {{"no point", {}},
            {"one point", {{0, {1, 2, 3}, 0}}},
            {"all equal", Course(1000, StrokePoint{0, {1, 1, 1}, 2})},
            {"NaN in place", broken},
            {"infinite place", endless},
            {"NaN in time", untimed},
            {"infinite force", unforced}};
}

TEST(GestureHostile, StrokesWithoutAShapeAreNothingToTheRecogniser) {
    const auto recogniser = Recogniser::make(three_gestures()).value();
    RecogniserSpace space;
    for (const auto& [name, stroke] : strokes_without_a_shape()) {
        const auto r = recogniser.recognise(stroke, space);
        EXPECT_EQ(r.gesture, nothing) << name;
        EXPECT_FALSE(r.accepted) << name;
        EXPECT_EQ(r.probability, 0) << name;
    }
}

TEST(GestureHostile, StrokesWithoutAPlaceAreNothingToEveryMethod) {
    for (const auto name : method_names()) {
        const auto classifier = make_classifier(*method_of(name), three_gestures(), {});
        ASSERT_TRUE(classifier) << name;
        for (const auto& [what, stroke] : strokes_without_a_shape()) {
            const auto answer = (*classifier)->classify(stroke);
            EXPECT_TRUE(answer.gesture == nothing || answer.gesture < 3) << name << ", " << what;
            EXPECT_TRUE(std::isfinite(answer.evidence.distance)) << name << ", " << what;
        }
        EXPECT_EQ((*classifier)->classify({}).gesture, nothing) << name;
        EXPECT_EQ((*classifier)->classify(Course(9, StrokePoint{0, {4, 4, 0}, 0})).gesture, nothing) << name;
    }
}

TEST(GestureHostile, TwoPointsAreAnAnswer) {
    const auto recogniser = Recogniser::make(three_gestures()).value();
    RecogniserSpace space;
    const Course two{{0, {0, 0, 0}, 0}, {0, {1, 1, 0}, 0}};
    const auto r = recogniser.recognise(two, space);
    EXPECT_LT(r.gesture, 3U);
    EXPECT_FALSE(r.accepted);
    EXPECT_TRUE(std::isfinite(r.distance) && std::isfinite(r.probability));
}

TEST(GestureHostile, AMillionPointsAreRecognised) {
    const auto recogniser = Recogniser::make(three_gestures()).value();
    RecogniserSpace space;
    const auto r = recogniser.recognise(ess(1'000'000), space);
    EXPECT_EQ(recogniser.name(r.gesture), "ess");
    EXPECT_TRUE(r.accepted);
}

TEST(GestureHostile, TimesThatRunBackwardsOrStandStillAreTakenByArcLength) {
    const auto recogniser = Recogniser::make(three_gestures()).value();
    RecogniserSpace space;
    auto backwards = ess(), standing = ess();
    for (auto& p : backwards) p.t = -p.t;
    for (auto& p : standing) p.t = 7;
    for (const auto* stroke : {&backwards, &standing}) {
        const auto r = recogniser.recognise(*stroke, space);
        EXPECT_EQ(recogniser.name(r.gesture), "ess");
        EXPECT_LT(r.distance, 0.05F);
    }
}

TEST(GestureHostile, HugeAndTinyNumbersAreAnAnswerOrNothing) {
    const auto recogniser = Recogniser::make(three_gestures()).value();
    RecogniserSpace space;
    for (const double scale : {1e-300, 1e-40, 1e-20, 1e10, 1e20, 1e38, 1e300}) {
        const auto r = recogniser.recognise(moved(ess(), {}, scale), space);
        EXPECT_TRUE(r.gesture == nothing || recogniser.name(r.gesture) == "ess") << scale;
        EXPECT_TRUE(std::isfinite(r.probability) && std::isfinite(r.distance)) << scale;
    }
}

TEST(GestureHostile, ATemplateWithoutAShapeIsRefusedByName) {
    auto gestures = three_gestures();
    gestures[1].strokes[0] = Course(5, StrokePoint{0, {1, 1, 1}, 0});
    EXPECT_NE(message_of(Recogniser::make(gestures)).find("'vee'"), std::string::npos);
    gestures[1].strokes.clear();
    EXPECT_FALSE(Recogniser::make(gestures));
    EXPECT_FALSE(Recogniser::make({}));
    EXPECT_FALSE(Recogniser::make(std::vector<Gesture>(max_gestures + 1, gestures[0])));
}

}  // namespace
}  // namespace thaum::gesture
