// Tests of the spotter, which finds gestures within continuous motion: what it finds, the choice among
// candidates, and the limits of its work.
#include <gtest/gtest.h>

#include "core/hash.h"
#include "gesture/trials/spotting.h"
#include "gesture/variations.h"
#include "unit/allocations.h"
#include "unit/gesture_shapes.h"

namespace thaum::gesture {
namespace {

constexpr double tick_length = 0.001;

Candidate candidate_of(std::uint32_t gesture, float distance, double start, double end) {
    return {.gesture = gesture, .distance = distance, .score = distance, .start = start, .end = end};
}

TEST(CandidateChoice, TheBestOfThoseThatOverlapIsReportedAfterTheWait) {
    CandidateChoice choice(0.4, 0.2F);
    EXPECT_FALSE(choice.add(candidate_of(0, 0.15F, 0, 1), 1));
    EXPECT_FALSE(choice.add(candidate_of(1, 0.10F, 0.1, 1.1), 1.1));
    EXPECT_FALSE(choice.add(candidate_of(2, 0.12F, 0.1, 1.2), 1.2));
    EXPECT_FALSE(choice.at(1.49));
    const auto reported = choice.at(1.5);
    ASSERT_TRUE(reported);
    EXPECT_EQ(reported->gesture, 1U);
    EXPECT_FALSE(choice.at(9));
}

TEST(CandidateChoice, NothingIsReportedTwiceOrAboveTheThreshold) {
    CandidateChoice choice(0.1, 0.2F);
    choice.add(candidate_of(0, 0.1F, 0, 1), 1);
    EXPECT_TRUE(choice.at(2));
    choice.add(candidate_of(0, 0.05F, 0.2, 1.2), 2);  // this candidate overlaps the gesture that was reported
    choice.add(candidate_of(0, 0.25F, 5, 6), 6);      // a candidate whose distance is above the threshold
    EXPECT_FALSE(choice.at(9));
    choice.add(candidate_of(0, 0.2F, 5, 6), 9);
    EXPECT_TRUE(choice.at(10));
}

/// Ticks of a hand that moves aimlessly, draws a stroke, and moves aimlessly again.
Course session_with(const Course& stroke, double& start, double& end) {
    Course session;
    double t = 0;
    const auto hold = [&](vec3 from, vec3 to, double seconds) {
        const auto count = static_cast<std::size_t>(seconds / tick_length);
        for (std::size_t i = 0; i < count; ++i, t += tick_length)
            session.push_back(
                {t, from + (to - from) * (static_cast<double>(i) / static_cast<double>(count)), 0});
    };
    hold({-6, 1, 0}, stroke.front().at, 2);
    start = t;
    for (std::size_t i = 1; i < stroke.size(); ++i)
        hold(stroke[i - 1].at, stroke[i].at, stroke[i].t - stroke[i - 1].t);
    end = t;
    hold(stroke.back().at, {6, 2, 0}, 2);
    hold({6, 2, 0}, {6, 2, 0}, 1);
    return session;
}

TEST(Spotter, FindsEachGestureOnceWithStartAndEnd) {
    const auto gestures = three_gestures();
    const auto recogniser = Recogniser::make(gestures, {.channels = {false, false}}).value();
    Random random = random_stream(8, 8);
    for (std::uint32_t g = 0; g < 3; ++g) {
        Spotter spotter(recogniser, {});
        double start = 0, end = 0;
        std::vector<Spotted> found;
        for (const auto& p :
             session_with(variation_of(gestures[g].strokes[0], random, careful), start, end)) {
            if (const auto s = spotter.feed(p)) found.push_back(*s);
        }
        ASSERT_EQ(found.size(), 1U) << g;
        EXPECT_EQ(found[0].what.gesture, g);
        EXPECT_NEAR(found[0].what.start, start, 0.35);
        EXPECT_NEAR(found[0].what.end, end, 0.35);
        EXPECT_GT(found[0].probability, 0.5);
        EXPECT_LT(found[0].told, end + 1.5);
    }
}

/// The best (lowest) score of a gesture at any time in a session of continuous motion.
float best_score(const Recogniser& recogniser, const Course& session, std::uint32_t gesture) {
    Spotter spotter(recogniser, {});
    float best = 9;
    for (const auto& p : session) {
        for (const auto& c : spotter.scan(p)) best = c.gesture == gesture ? std::min(best, c.score) : best;
    }
    return best;
}

TEST(Spotter, StartAndEndAreFoundWithinAFewHundredthsOfTheStroke) {
    const auto recogniser = Recogniser::make(three_gestures(), {.channels = {false, false}}).value();
    double start = 0, end = 0;
    const auto session = session_with(ess(), start, end);
    Spotter spotter(recogniser, {});
    Candidate best{.score = 9};
    for (const auto& p : session) {
        for (const auto& c : spotter.scan(p)) best = c.gesture == 2 && c.score < best.score ? c : best;
    }
    EXPECT_NEAR(best.start, start, 0.05 * (end - start));
    EXPECT_NEAR(best.end, end, 0.05 * (end - start));
}

TEST(Spotter, AFlatGestureIsFoundBesideOneWithDepth) {
    // One gesture is a helix, which has depth. The other one is flat: its depth does not count.
    const auto helix = drawn([](double u) { return vec3(det::cos(6 * u), 2 * u, det::sin(6 * u)); });
    const auto gestures = {gesture_of("helix", {helix}), gesture_of("ess", {ess()}, {.planar = true})};
    const auto recogniser =
        Recogniser::make(std::vector<Gesture>(gestures), {.channels = {true, false}}).value();
    auto deep = ess();
    for (auto& p : deep) p.at.z = 0.5 * det::sin(7 * p.t);
    double start = 0, end = 0;
    EXPECT_LT(best_score(recogniser, session_with(helix, start, end), 0), 0.1F);
    EXPECT_LT(best_score(recogniser, session_with(deep, start, end), 1), 0.1F);
    EXPECT_GT(best_score(recogniser, session_with(deep, start, end), 0), 0.14F);
}

TEST(Spotter, ARestBeforeAndAfterTheUsualDurationScoresBetter) {
    const auto recogniser = Recogniser::make(three_gestures(), {.channels = {false, false}}).value();
    const auto among = [](const Course& stroke, double rest) {
        double start = 0, end = 0;
        auto session = session_with(stroke, start, end);
        for (auto& p : session) p.t += (p.t >= start ? rest : 0) + (p.t >= end ? rest : 0);
        return session;
    };
    const float hurried = best_score(recogniser, among(ess(), 0), 2);
    EXPECT_LT(best_score(recogniser, among(ess(), 0.4), 2), 0.9F * hurried);
    const auto slow = moved(ess(), {}, 1, 0.2);  // the S, drawn at a fifth of the speed
    EXPECT_GT(best_score(recogniser, among(slow, 0.4), 2), best_score(recogniser, among(ess(), 0.4), 2));
}

TEST(Spotter, AllocatesNothingAndGivesTheSameBitsInEachRun) {
    const auto recogniser = Recogniser::make(three_gestures(), {.channels = {false, false}}).value();
    double start = 0, end = 0;
    const auto session = session_with(ess(), start, end);
    std::uint64_t hashes[2] = {0, 0};
    for (auto& hash : hashes) {
        Spotter spotter(recogniser, {});
        const auto before = test::allocations();
        for (const auto& p : session) {
            for (const auto& c : spotter.scan(p))
                hash = hash_combine(hash, hash_combine(hash_value(c.distance), c.gesture));
        }
        EXPECT_EQ(test::allocations(), before);
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_NE(hashes[0], 0U);
}

TEST(Spotter, OutlastsHostileMotion) {
    const auto recogniser = Recogniser::make(three_gestures(), {.channels = {false, false}}).value();
    Spotter spotter(recogniser, {});
    Random random = random_stream(1, 5);
    const double nan = std::nan("");
    for (int i = 0; i < 60'000; ++i) {
        StrokePoint p{i * tick_length, {random.uniform(-9, 9), random.uniform(-9, 9), 0}, 0};
        if (i % 7 == 0) p.at.x = nan;
        if (i % 11 == 0) p.t = -1;
        if (i % 1003 == 0) p.at.y = 1e300;
        spotter.feed(p);
    }
}

/// Three users who draw each gesture once in their sessions.
struct SpottingData {
    std::vector<Stroke> strokes{};
    SessionSet sessions{};
    std::vector<SessionLabel> labels{};
};

SpottingData spotting_data() {
    const auto gestures = three_gestures();
    SpottingData data;
    Random random = random_stream(2, 2);
    for (int user = 0; user < 3; ++user) {
        Session session{std::to_string(user), {}};
        for (const auto& g : gestures) {
            for (int i = 0; i < 3; ++i)
                data.strokes.push_back(
                    {session.user, g.name, std::to_string(i), variation_of(g.strokes[0], random, careful)});
            double start = 0, end = 0;
            const double from = session.points.empty() ? 0 : session.points.back().t + 1;
            for (auto p : session_with(variation_of(g.strokes[0], random, careful), start, end)) {
                p.t += from;
                session.points.push_back(p);
            }
            data.labels.push_back({session.user, g.name, from + start, from + end});
        }
        data.sessions.sessions.push_back(std::move(session));
    }
    return data;
}

TEST(Spotting, FindsLabelledGesturesOfAnotherUser) {
    const auto data = spotting_data();
    const SpottingSettings settings{.templates = 2, .repeats = 1};
    const auto result = evaluate_spotting(data.sessions, data.labels, data.strokes, settings).value();
    EXPECT_EQ(result.labels, 9U);
    EXPECT_GE(result.best.recall, 0.85);
    EXPECT_GE(result.best.precision, 0.85);
    EXPECT_FALSE(evaluate_spotting(data.sessions, {}, data.strokes, {}));
}

TEST(Spotting, AStrokeWithoutItsLabelIsFalseUnlessItIsIgnored) {
    auto data = spotting_data();
    SpottingSettings settings{.templates = 2, .repeats = 1};
    const auto all = evaluate_spotting(data.sessions, data.labels, data.strokes, settings);
    const auto left_out = data.labels.back();
    data.labels.pop_back();
    const auto without = evaluate_spotting(data.sessions, data.labels, data.strokes, settings);
    settings.ignored = {left_out};
    const auto ignored = evaluate_spotting(data.sessions, data.labels, data.strokes, settings);
    ASSERT_TRUE(all && without && ignored);
    EXPECT_EQ(without->best.wrong, all->best.wrong + 1);
    EXPECT_EQ(ignored->best.wrong, all->best.wrong);
    EXPECT_EQ(ignored->best.right, all->best.right - 1);
}

}  // namespace
}  // namespace thaum::gesture
