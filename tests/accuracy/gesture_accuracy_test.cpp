// Tests the accuracy of gesture recognition on public data in a folder beside the source tree
// (../shared/data/gestures). The tests are skipped if the folder does not exist.
#include <gtest/gtest.h>

#include <filesystem>

#include "gesture/stroke_files.h"
#include "gesture/trials/evaluation.h"
#include "gesture/trials/spotting.h"

namespace thaum::gesture {
namespace {

const std::filesystem::path data = std::filesystem::path(THAUM_SOURCE_DIR) / "../shared/data/gestures";

class GesturePublicData : public testing::Test {
protected:
    void SetUp() override {
        if (!std::filesystem::exists(data)) GTEST_SKIP() << "no folder " << data;
    }

    static StrokeSet strokes(const char* file) { return gesture::load_strokes(data / file).value(); }

    static double accuracy(const StrokeSet& set, EvaluationSettings settings) {
        settings.channels = {set.has_depth, set.has_force};
        return evaluate(set.strokes, settings).value().accuracy;
    }
};

TEST_F(GesturePublicData, LettersWithForce) {
    const auto set = strokes("character-trajectories.csv.gz");
    EXPECT_EQ(set.strokes.size(), 1429U);
    EXPECT_TRUE(set.has_force);
    EvaluationSettings settings{.protocol = Protocol::random, .templates = 1, .repeats = 10};
    EXPECT_GE(accuracy(set, settings), 0.91);
    settings.templates = 3;
    EXPECT_GE(accuracy(set, settings), 0.97);
    settings.templates = 9;
    EXPECT_GE(accuracy(set, settings), 0.985);
}

TEST_F(GesturePublicData, HalfOfAStrokeTellsMoreWhereRecordedStrokesAgree) {
    EvaluationSettings settings{
        .method = Method::early, .protocol = Protocol::random, .templates = 9, .repeats = 1, .at = 0.5};
    EXPECT_GE(accuracy(strokes("character-trajectories.csv.gz"), settings), 0.84) << "by one writer";
    settings.protocol = Protocol::leave_user_out;
    settings.templates = 3;
    EXPECT_GE(accuracy(strokes("machete-mouse.csv.gz"), settings), 0.975) << "by ten";
}

TEST_F(GesturePublicData, WhatIsToldOfHalfALetterIsRight) {
    const auto set = strokes("character-trajectories.csv.gz");
    const EvaluationSettings settings{.method = Method::early,
                                      .protocol = Protocol::random,
                                      .templates = 3,
                                      .repeats = 1,
                                      .channels = {set.has_depth, set.has_force},
                                      .at = 0.5,
                                      .own_calibration = true};
    const auto result = evaluate(set.strokes, settings).value();
    const auto certainty = certainty_of(result, 0.8);
    EXPECT_GE(certainty.told, 0.25);
    EXPECT_GE(certainty.right, 0.975);
}

TEST_F(GesturePublicData, LettersOfWhichHalfAreUnknown) {
    const auto set = strokes("character-trajectories.csv.gz");
    const EvaluationSettings settings{.protocol = Protocol::random,
                                      .templates = 3,
                                      .repeats = 10,
                                      .channels = {false, true},
                                      .unknown_share = 0.5};
    const auto result = evaluate(set.strokes, settings);
    ASSERT_TRUE(result && result->open_set);
    // Letters that were not learnt are so similar to known ones, such as h and n, that even with 20 templates
    // of each letter no more than 85 % are accepted correctly.
    EXPECT_GE(result->open_set->correct_accepts, 0.78);
    EXPECT_LE(result->open_set->false_accepts, 0.015);
}

TEST_F(GesturePublicData, TheRecogniserBeatsTheBaselinesOfThePapers) {
    const auto set = strokes("character-trajectories.csv.gz");
    EvaluationSettings settings{.protocol = Protocol::random, .templates = 3, .repeats = 1};
    const double standard = accuracy(set, settings);
    settings.method = Method::dot;
    EXPECT_GT(standard, accuracy(set, settings) + 0.05);
    settings.method = Method::directions;
    EXPECT_GT(standard, accuracy(set, settings) + 0.05);
}

TEST_F(GesturePublicData, MouseGesturesOfUnknownUsers) {
    const auto set = strokes("machete-mouse.csv.gz");
    EXPECT_EQ(set.strokes.size(), 500U);
    const EvaluationSettings settings{.protocol = Protocol::leave_user_out, .templates = 1, .repeats = 5};
    EXPECT_GE(accuracy(set, settings), 0.998);
}

TEST_F(GesturePublicData, ProbabilitiesHoldAndUnknownGesturesAreNothing) {
    const auto set = strokes("machete-mouse.csv.gz");
    const EvaluationSettings settings{.protocol = Protocol::leave_user_out,
                                      .templates = 3,
                                      .repeats = 4,
                                      .channels = {false, false},
                                      .unknown_share = 0.5};
    const auto result = evaluate(set.strokes, settings);
    ASSERT_TRUE(result && result->open_set);
    EXPECT_LT(result->calibration_error, 0.02);
    EXPECT_GE(result->open_set->correct_accepts, 0.98);
    EXPECT_LE(result->open_set->false_accepts, 0.03);
}

/// The recogniser's probabilities must be right even if it has only its templates (one or three of each
/// gesture) and no further strokes of users to fit them to.
TEST_F(GesturePublicData, ProbabilitiesHoldWithoutStrokesOfUsers) {
    const auto error = [](const StrokeSet& set, Protocol protocol, std::size_t templates) {
        const auto result = evaluate(set.strokes, {.protocol = protocol,
                                                   .templates = templates,
                                                   .repeats = 1,
                                                   .channels = {set.has_depth, set.has_force},
                                                   .own_calibration = true});
        return result ? result->calibration_error : 1;
    };
    const auto letters = strokes("character-trajectories.csv.gz"), mouse = strokes("machete-mouse.csv.gz");
    for (const std::size_t templates : {1U, 3U}) {
        EXPECT_LE(error(letters, Protocol::random, templates), 0.05) << templates << " templates of letters";
        EXPECT_LE(error(mouse, Protocol::leave_user_out, templates), 0.05) << templates << " templates";
    }
}

TEST_F(GesturePublicData, GesturesAreSpottedInContinuousMotion) {
    const auto set = strokes("machete-mouse.csv.gz");
    const auto sessions = gesture::load_sessions(data / "machete-mouse-sessions.csv.gz");
    const auto labels = gesture::load_labels(data / "machete-mouse-sessions.labels.csv");
    ASSERT_TRUE(sessions && labels);
    const auto ignored = gesture::load_labels(std::filesystem::path(THAUM_SOURCE_DIR) /
                                              "tests/accuracy/unlabelled_strokes.csv")
                             .value();
    SpottingSettings settings{.templates = 3, .repeats = 1};
    const auto result = evaluate_spotting(*sessions, *labels, set.strokes, settings).value();
    EXPECT_EQ(result.labels, 300U);
    EXPECT_GE(result.best.f1, 0.88);
    // The sessions hold 59 strokes without a label that look like gestures: attempts that the users had to
    // repeat. The publishers of the data count reports of such attempts neither as right nor as wrong.
    settings.ignored = ignored;
    const auto fair = evaluate_spotting(*sessions, *labels, set.strokes, settings).value();
    EXPECT_GE(fair.best.f1, 0.96);
    EXPECT_GE(fair.at_six.recall, 0.95);
}

}  // namespace
}  // namespace thaum::gesture
