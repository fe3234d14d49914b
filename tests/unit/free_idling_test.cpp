// Tests that casting without a button ignores motion that means nothing: a quarter of an hour of mouse motion
// at a desk, a trembling arm, and recorded motion of people with a mouse. Only the recognition is run,
// without a match.
#include <cmath>

#include "core/random.h"
#include "game/casting/free_reading.h"
#include "gesture/stroke_files.h"
#include "unit/game_duel.h"

namespace thaum::game {
namespace {

constexpr double quarter = 900;  // a quarter of an hour (s)

/// Number of gestures that casting without a button recognises in a sequence of places (m), one for each
/// gameplay tick.
template <class Next>
std::size_t casts_in(double seconds, Next&& next) {
    static const auto data = test::duel_data();
    const auto& rules = *data->casting;
    const auto hand = std::make_unique<FreeHand>();
    const auto space = std::make_unique<ReadingSpace>();
    std::size_t casts = 0;
    Tick latest = 0;
    for (Tick tick = 0; tick < ticks(seconds); tick += gameplay_period) {
        add_place(rules, next(), tick, *hand);
        if (!read_windows(rules, *data->gestures, *space, *hand)) continue;
        const auto& drawn = hand->best;
        const bool sure = drawn.gesture != no_gesture && drawn.miss == Miss::none;
        if (!sure || drawn.probability < drawn.needed || (casts > 0 && tick < latest + rules.free_apart))
            continue;
        ++casts;
        latest = tick;
    }
    return casts;
}

/// A hand that moves in many ways but draws no gesture. Its motions are independent of recognisers, templates
/// and variations.
class Idling {
public:
    Idling(std::uint64_t seed, bool by_arm) : random_(random_stream(seed, 0x1d1e)), by_arm_(by_arm) {}

    /// Place of the hand after another gameplay tick (m).
    vec3 next() {
        if (legs_.empty() && scribbled_ <= 0) begin();
        now_ += gameplay_dt;
        if (scribbled_ > 0) {
            scribble();
        } else {
            go();
        }
        const vec3 at = place_ + tremor();
        constexpr double step = 1e-4;  // distance for one count of a mouse (m)
        return by_arm_ ? at : step * vec3(std::round(at.x / step), std::round(at.y / step), 0);
    }

private:
    /// A straight or bent movement of the hand, or a rest if both ends are the same place.
    struct Leg {
        vec3 to{}, bow{};
        double lasts{};
    };

    double noise() { return random_.uniform(-1, 1); }
    vec3 way(double size) {
        const double angle = random_.uniform(0, 2 * pi);
        return size * vec3(std::cos(angle), std::sin(angle), by_arm_ ? 0.4 * noise() : 0);
    }
    vec3 last() const { return legs_.empty() ? place_ : legs_.back().to; }
    void rest(double seconds) { legs_.push_back({last(), vec3(0), seconds}); }
    /// A minimum-jerk movement, which takes longer the farther it goes (Fitts 1954), followed by a
    /// correction.
    void reach(vec3 by, double hurry = 1) {
        const double size = glm::length(by);
        const double lasts = hurry * (0.12 + 0.11 * std::log2(size / 0.004 + 1)) * random_.uniform(0.8, 1.3);
        legs_.push_back({last() + by, way(0.12 * size * noise()), std::max(lasts, 0.06)});
    }

    void begin() {
        from_ = place_;
        begun_ = now_;
        const double kind = random_.uniform();
        if (kind < 0.45) return point_at();
        if (kind < 0.6) return rest(0.2 - 1.5 * std::log(random_.uniform(0.01, 1)));
        if (kind < 0.68) return turn_the_wheel();
        if (kind < 0.76) return to_and_fro(vec3(0.002 * noise(), random_.uniform(0.01, 0.07), 0), 1);
        if (kind < 0.82) return to_and_fro(vec3(random_.uniform(0.01, 0.08), 0.004 * noise(), 0), 0.7);
        if (kind < 0.9) return open_a_menu();
        scribbled_ = random_.uniform(0.5, 4);
        speed_ = vec3(0);
    }
    void point_at() {
        const vec3 by = way(random_.uniform(0.004, 0.12));
        reach(by);
        if (random_.uniform() < 0.6) reach(0.1 * glm::length(by) * vec3(noise(), noise(), 0));
        rest(random_.uniform(0.05, 1));
    }
    void turn_the_wheel() {
        for (auto i = 3 + random_.below(12); i > 0; --i) {
            reach(way(0.0006));
            rest(random_.uniform(0.05, 0.4));
        }
    }
    void to_and_fro(vec3 by, double hurry) {
        for (auto i = 1 + random_.below(6); i > 0; --i) {
            reach(by * random_.uniform(0.8, 1.2), hurry);
            if (random_.uniform() < 0.4) rest(random_.uniform(0.05, 0.6));
            by = -by;
        }
        rest(random_.uniform(0.1, 0.8));
    }
    void open_a_menu() {
        for (auto i = 2 + random_.below(3); i > 0; --i) {
            const double size = random_.uniform(0.01, 0.06) * (random_.uniform() < 0.3 ? -1 : 1);
            reach(i % 2 == 0 ? vec3(size, 0.003 * noise(), 0) : vec3(0.003 * noise(), -size, 0), 0.8);
        }
        rest(random_.uniform(0.2, 1));
    }

    void go() {
        const auto& leg = legs_.front();
        const double share = std::min((now_ - begun_) / leg.lasts, 1.0);
        const double smooth = share * share * share * (10 - 15 * share + 6 * share * share);
        place_ = glm::mix(from_, leg.to, smooth) + std::sin(pi * smooth) * leg.bow;
        if (share < 1) return;
        from_ = leg.to;
        begun_ = now_;
        legs_.erase(legs_.begin());
    }
    /// Aimless motion: the hand's speed is noise that decays within a tenth of a second.
    void scribble() {
        constexpr double fades = 0.1, pace = 0.25;  // time in which the speed decays (s), usual speed (m/s)
        speed_ += gameplay_dt / fades * -speed_ + pace * std::sqrt(6 * gameplay_dt / fades) * flat_noise();
        place_ += gameplay_dt * speed_;
        scribbled_ -= gameplay_dt;
        if (scribbled_ <= 0) rest(random_.uniform(0.1, 1));
        from_ = place_;
        begun_ = now_;
    }
    vec3 flat_noise() {
        const double x = noise();
        return {x, noise(), 0};
    }
    vec3 tremor() const {
        const double most = by_arm_ ? 3e-4 : 5e-5;  // amplitude of the tremor (m)
        const double a = 2 * pi * 9.1 * now_, b = 2 * pi * 7.3 * now_;
        return most * vec3(std::sin(a), std::sin(b + 1), by_arm_ ? std::sin(0.9 * a + 2) : 0);
    }

    Random random_;
    bool by_arm_;
    std::vector<Leg> legs_;
    vec3 place_{}, from_{}, speed_{};
    double now_ = 0, begun_ = 0;  // current time, and the time at which the current leg began (s)
    double scribbled_ = 0;        // remaining time of aimless motion (s)
};

/// The motion of ten people between the gestures that they drew (public data beside the source tree), joined
/// together: 50 minutes of places, one for each gameplay tick (m).
std::vector<fvec2> recorded_motion() {
    const auto source = std::filesystem::path(THAUM_SOURCE_DIR), folder = source / "../shared/data/gestures";
    const auto sessions = gesture::load_sessions(folder / "machete-mouse-sessions.csv.gz");
    auto strokes = gesture::load_labels(folder / "machete-mouse-sessions.labels.csv");
    const auto attempts = gesture::load_labels(source / "tests/accuracy/unlabelled_strokes.csv");
    std::vector<fvec2> places;
    if (!sessions || !strokes || !attempts) return places;
    strokes->insert(strokes->end(), attempts->begin(), attempts->end());
    constexpr double count = 1e-4;     // distance for one count of a mouse (m)
    constexpr double longest_gap = 2;  // longer times between two reports of a mouse are cut to this (s)
    vec2 at(0);
    for (const auto& session : sessions->sessions) {
        auto drawn = *strokes;
        drawn.erase(
            std::remove_if(drawn.begin(), drawn.end(), [&](const auto& d) { return d.user != session.user; }),
            drawn.end());
        double time = 0;
        for (std::size_t i = 1; i < session.points.size(); ++i) {
            const auto &from = session.points[i - 1], &to = session.points[i];
            if (std::any_of(drawn.begin(), drawn.end(),
                            [&](const auto& d) { return to.t >= d.start - 0.2 && to.t <= d.end + 0.2; }))
                continue;
            at += count * vec2(to.at.x - from.at.x, from.at.y - to.at.y);
            for (time += std::min(to.t - from.t, longest_gap); time >= gameplay_dt; time -= gameplay_dt)
                places.emplace_back(at);
        }
    }
    return places;
}

TEST(FreeIdling, OfAMouseAtADeskCastsNothing) {
    Idling hand(14, false);
    EXPECT_EQ(casts_in(quarter, [&] { return hand.next(); }), 0U);
}

TEST(FreeIdling, OfATremblingArmCastsNothing) {
    Idling hand(13, true);
    EXPECT_EQ(casts_in(quarter, [&] { return hand.next(); }), 0U);
}

TEST(FreeIdling, OfRecordedMiceCastsNothingWhereTheyDrawLoops) {
    const auto places = recorded_motion();
    if (places.empty()) GTEST_SKIP() << "the recorded sessions are not part of the source tree";
    constexpr double lasts = 20;  // length of the part that is processed (s)
    for (const double begin : {535.0, 715.0, 1800.0, 2395.0}) {
        auto next = static_cast<std::size_t>(begin / gameplay_dt);
        ASSERT_LT(next + static_cast<std::size_t>(lasts / gameplay_dt), places.size());
        EXPECT_EQ(casts_in(lasts, [&] { return vec3(places[next++], 0); }), 0U)
            << "from " << begin << " s on";
    }
}

}  // namespace
}  // namespace thaum::game
