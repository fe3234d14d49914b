// Tests of casting without a button: a gesture with the mouse casts a spell, aiming and fighting do not, the
// player is told about a near miss, and a match that is restored at a keyframe continues with the same bits.
#include "game/casting/free_casting.h"

#include <cmath>

#include "core/random.h"
#include "game/casting/casting.h"
#include "gesture/generated_users.h"
#include "gesture/stroke_files.h"
#include "unit/game_duel.h"

namespace thaum::game {
namespace {

/// A match of two players whose input the test gives. The first one casts without a button.
class Free {
public:
    explicit Free(bool freely = true) {
        auto setup = test::two_hands();
        setup.devices[0].casts_freely = freely;
        match = std::make_unique<Simulation>(test::duel_data(), setup);
    }

    /// Moves the mouse to a place (whole counts from where it began) within one tick.
    void move_to(double x, double y) {
        const auto right = static_cast<std::int32_t>(std::lround(x)),
                   up = static_cast<std::int32_t>(std::lround(y));
        frame.devices[0].counts[input::hand::look_right] = right - right_;
        frame.devices[0].counts[input::hand::look_up] = up - up_;
        right_ = right;
        up_ = up;
        match->tick(frame);
        const auto* hand = match->world().find<FreeHand>(wizard_of(match->world(), 0));
        if (hand != nullptr && hand->cast_at != 0 && hand->cast_at + 1 == match->match().played) ++casts_;
        if (match->match().phase == Phase::over) begin_again();
    }
    void rest(double s) {
        for (Tick i = 0; i < ticks(s); ++i) move_to(right_, up_);
    }
    /// Draws a circle from its top as a hand does: slowly at both ends. `radius` is in counts of 0.1 mm.
    void circle(double radius, double s) {
        const double x = right_, y = up_;
        const auto steps = static_cast<double>(ticks(s));
        for (double i = 1; i <= steps; ++i) {
            const double t = i / steps, angle = 2 * pi * t * t * t * (10 - 15 * t + 6 * t * t);
            move_to(x + radius * std::sin(angle), y + radius * (std::cos(angle) - 1));
        }
    }

    vec2 place() const { return {right_, up_}; }
    /// Number of the first player's gestures that were recognised as spells, even if the player lacked the
    /// focus to cast them.
    std::size_t casts() const { return casts_; }

    std::unique_ptr<Simulation> match;
    input::InputFrame frame;

private:
    void begin_again() { match = std::make_unique<Simulation>(test::duel_data(), match->setup()); }

    std::int32_t right_ = 0, up_ = 0;
    std::size_t casts_ = 0;
};

const LastReading& reading_of(const Simulation& match) {
    return match.world().get<LastReading>(wizard_of(match.world(), 0));
}

TEST(FreeCasting, ACircleOfTheMouseCastsAShield) {
    Free play;
    play.rest(0.5);
    play.circle(350, 0.9);
    play.rest(0.6);
    EXPECT_EQ(play.casts(), 1U);
    EXPECT_GE(reading_of(*play.match).probability, play.match->data().casting->free_least_probability);
    EXPECT_GT(play.match->world().get<Health>(wizard_of(play.match->world(), 0)).ward, 0);
}

TEST(FreeCasting, NeedsTheOption) {
    Free play(false);
    play.rest(0.5);
    play.circle(350, 0.9);
    play.rest(0.6);
    EXPECT_EQ(play.casts(), 0U);
}

TEST(FreeCasting, ARecogniserOfMotionIsMadeForThoseWhoCastFreelyAlone) {
    for (const bool freely : {false, true}) {
        Free play(freely);
        const auto& gestures = *play.match->data().gestures;
        play.rest(0.5);
        play.circle(350, 0.9);
        play.rest(0.6);
        play.frame.devices[0].press(input::Button::trace);
        play.circle(350, 0.9);
        play.frame = {};
        play.rest(0.1);
        EXPECT_NE(reading_of(*play.match).gesture, no_gesture) << "the stroke with Trace";
        EXPECT_EQ(gestures.has_motion_recogniser(), freely);
    }
}

TEST(FreeCasting, AHandThatShootsCastsNothing) {
    Free play;
    play.rest(0.5);
    play.frame.devices[0].press(input::Button::fire);
    play.circle(350, 0.9);
    play.rest(0.6);
    EXPECT_EQ(play.casts(), 0U);
}

TEST(FreeCasting, TwoSpellsAreAWhileApart) {
    Free play;
    play.rest(0.5);
    play.circle(350, 0.5);
    play.rest(0.35);
    play.circle(350, 0.5);
    play.rest(0.5);
    EXPECT_EQ(play.casts(), 1U);
    play.rest(1.2);
    play.circle(350, 0.6);
    play.rest(0.6);
    EXPECT_EQ(play.casts(), 2U);
}

/// Draws circles again and again, with pauses, so that some circles are unfinished at a keyframe. Returns the
/// hash of the state at every 128th tick after `from`.
std::vector<std::uint64_t> hashes_of(Free& play, Tick from, Tick until) {
    std::vector<std::uint64_t> hashes;
    for (Tick t = play.match->now(); t < until; ++t) {
        const double p = std::min(1.0, static_cast<double>(t % 2300) / 900);
        const double angle = 2 * pi * p * p * p * (10 - 15 * p + 6 * p * p);
        play.move_to(350 * std::sin(angle), 350 * std::cos(angle));
        if (t >= from && play.match->now() % 128 == 0) hashes.push_back(play.match->state_hash());
    }
    return hashes;
}

TEST(FreeCasting, ARestoredMatchGoesOnWithTheSameBits) {
    constexpr Tick end = 8 * keyframe_interval;
    for (const Tick at : {2 * keyframe_interval, 5 * keyframe_interval, 6 * keyframe_interval}) {
        Free through;
        hashes_of(through, at, at);
        Bytes saved;
        through.match->save(saved);
        Free again;
        hashes_of(again, at, at);  // brings the mouse to the same place as in the first match
        ASSERT_TRUE(again.match->restore(saved, at));
        EXPECT_EQ(hashes_of(through, at, end), hashes_of(again, at, end)) << "restored at tick " << at;
        EXPECT_GE(through.casts(), 1U);
    }
}

struct Tally {
    std::size_t drawn = 0, right = 0, wrong = 0;
};

/// Lets `draw` draw a stroke of a gesture, with a rest before and after it, and counts whether it cast the
/// spell of that gesture or another one.
template <class Draw>
void count_stroke(Free& play, std::string_view gesture, Draw&& draw, Tally& tally) {
    play.rest(1.2);
    const auto before = play.casts();
    draw(play.place());
    play.rest(0.6);
    ++tally.drawn;
    if (play.casts() == before) return;
    const auto name = play.match->data().gestures->name(reading_of(*play.match).gesture);
    ++(name == gesture ? tally.right : tally.wrong);
}

TEST(FreeCasting, FindsTheStrokesOfManyUsersAndSeldomTakesOneForAnother) {
    const auto strokes = gesture::generated_strokes({.users = 20, .samples = 1, .seed = 5});
    const auto data = test::duel_data();
    Free play;
    Tally tally;
    for (const auto& stroke : strokes) {
        if (spell_of(*data, stroke.gesture) == nullptr) continue;
        const auto draw = [&](vec2 begin) {
            for (const auto& p : stroke.points) {
                const vec2 way = 1e4 * vec2(p.at - stroke.points[0].at);  // way of the mouse (counts)
                for (Tick i = 0; i < gameplay_period; ++i) play.move_to(begin.x + way.x, begin.y + way.y);
            }
        };
        count_stroke(play, stroke.gesture, draw, tally);
    }
    ASSERT_GE(tally.drawn, 40U);
    EXPECT_GE(tally.right, tally.drawn * 9 / 10) << "of " << tally.drawn;
    EXPECT_LE(tally.wrong, tally.drawn / 40);
}

/// Point at a share of the way along the outline of a gesture, which is 2 high.
vec2 figure_at(std::string_view name, double share) {
    const auto corner = [](double k) {
        return vec2(std::sin(4 * pi * (k + 0.5) / 5), std::cos(4 * pi * (k + 0.5) / 5));
    };
    if (name == "circle") return {std::sin(2 * pi * share), std::cos(2 * pi * share)};
    if (name == "v") return {-0.7 + 1.4 * share, std::abs(4 * share - 2) - 1};
    if (name == "s") {
        const double a = radians_per_degree * (share < 0.5 ? 30 + 480 * share : 90 - 480 * (share - 0.5));
        return {0.6 * std::cos(a), (share < 0.5 ? 0.5 : -0.5) + 0.5 * std::sin(a)};
    }
    const double side = std::min(4.0, std::floor(5 * share));
    return glm::mix(corner(side), corner(side + 1), 5 * share - side);
}

/// Draws a gesture at a constant speed in steps of some ticks, as when a program moves the mouse.
void draw_by_program(Free& play, std::string_view name, double half, double s, vec2 begin, int step = 10) {
    const auto steps = static_cast<int>(s * 1000 / step);
    for (int i = 1; i <= steps; ++i) {
        const vec2 way = half * (figure_at(name, static_cast<double>(i) / steps) - figure_at(name, 0));
        for (int k = 0; k < step; ++k) play.move_to(begin.x + way.x, begin.y + way.y);
    }
}

TEST(FreeCasting, FindsFiguresOfAnEvenPaceInJumps) {
    Free play;
    Tally tally;
    for (const double half : {250.0, 350.0, 500.0})
        for (const double s : {0.4, 0.7, 1.1, 1.5})
            for (const auto* name : {"circle", "v", "s", "star"})
                count_stroke(
                    play, name, [&](vec2 begin) { draw_by_program(play, name, half, s, begin); }, tally);
    EXPECT_GE(tally.right, tally.drawn * 9 / 10) << "of " << tally.drawn;
    EXPECT_EQ(tally.wrong, 0U);
}

TEST(FreeCasting, FindsFiguresOfAMouseThatIsSeldomHeard) {
    for (const int step : {16, 24, 32, 40}) {
        Free play;
        Tally tally;
        for (const double half : {250.0, 400.0})
            for (const double s : {0.7, 1.1, 1.5})
                for (const auto* name : {"circle", "v", "s", "star"})
                    count_stroke(
                        play, name, [&](vec2 begin) { draw_by_program(play, name, half, s, begin, step); },
                        tally);
        EXPECT_GE(tally.right, tally.drawn * 9 / 10)
            << "of " << tally.drawn << " in steps of " << step << " ms";
        EXPECT_EQ(tally.wrong, 0U);
    }
}

const NearMiss& miss_of(const Simulation& match) {
    return match.world().get<NearMiss>(wizard_of(match.world(), 0));
}

TEST(FreeCasting, TellsWhyACircleCastNothing) {
    Free play;
    const auto reason_after = [&](double radius, double s) {
        play.rest(1.2);
        play.circle(radius, s);
        play.rest(0.4);
        const auto& miss = miss_of(*play.match);
        return miss.at + ticks(0.4) > play.match->match().played ? miss.reason : Miss::none;
    };
    EXPECT_EQ(reason_after(350, 0.9), Miss::none);
    EXPECT_EQ(play.casts(), 1U);
    EXPECT_EQ(reason_after(110, 0.6), Miss::too_small);
    EXPECT_EQ(reason_after(350, 0.12), Miss::too_fast);
    EXPECT_EQ(play.casts(), 1U);
    EXPECT_EQ(play.match->data().gestures->name(miss_of(*play.match).gesture), "circle");
    EXPECT_EQ(reason_after(350, 0.5), Miss::none);
    play.circle(350, 0.5);  // less than a second after the last spell
    play.rest(0.3);
    EXPECT_EQ(miss_of(*play.match).reason, Miss::too_soon);
    EXPECT_EQ(play.casts(), 2U);
}

/// Draws a part of a circle after a pause. Returns the reason why this cast no spell.
Miss reason_after_part(Free& play, double turns, double s, double pause = 1.2) {
    play.rest(pause);
    const auto begin = play.place();
    const auto steps = static_cast<double>(ticks(s));
    for (double i = 1; i <= steps; ++i) {
        const double angle = 2 * pi * turns * i / steps;
        play.move_to(begin.x + 400 * std::sin(angle), begin.y + 400 * (std::cos(angle) - 1));
    }
    const auto casts = play.casts();
    const auto drawn = play.match->match().played;
    play.rest(0.4);
    const auto& miss = miss_of(*play.match);
    const bool missed = miss.at > drawn;
    EXPECT_FALSE(missed && play.casts() > casts);
    return missed ? miss.reason : Miss::none;
}

TEST(FreeCasting, TellsOfAGestureThatWasUnclear) {
    Free play;
    std::size_t unclear = 0;
    for (const double turns : {0.9, 0.85, 0.8, 0.75, 0.7, 0.65, 0.6}) {
        const auto reason = reason_after_part(play, turns, 0.9);
        EXPECT_TRUE(reason == Miss::none || reason == Miss::unclear) << turns;
        unclear += reason == Miss::unclear ? 1 : 0;
    }
    EXPECT_GE(unclear, 1U);
    EXPECT_EQ(reason_after_part(play, 0.3, 0.9), Miss::none) << "an arc is like nothing";
    EXPECT_GE(miss_of(*play.match).probability, play.match->data().casting->free_near_probability);
}

TEST(FreeCasting, WhatFollowsACastIsNoNearMiss) {
    for (const double turns : {0.9, 0.85, 0.8, 0.75, 0.7, 0.65, 0.6}) {
        Free play;
        play.rest(0.5);
        play.circle(350, 0.5);
        play.rest(0.3);
        ASSERT_EQ(play.casts(), 1U);
        EXPECT_NE(reason_after_part(play, turns, 0.4, 0.02), Miss::unclear) << turns;
    }
}

// ---- No cast while fighting -------------------------------------------------------------------------------

/// Places of a mouse that is used for aiming: quick moves to a target with corrections, following a target,
/// and rests.
class Aiming {
public:
    explicit Aiming(std::uint64_t seed) : random_(random_stream(seed, 7)) {}

    fvec2 next() {
        if (left_ == 0) begin();
        --left_;
        const double share = 1 - static_cast<double>(left_) / static_cast<double>(length_);
        if (tracks_) {
            speed_ += 0.02 * (goal_ - speed_) + 0.05 * vec2(noise(), noise());
            at_ += speed_;
            if (left_ % 160 == 0) goal_ = 0.8 * vec2(noise(), 0.35 * noise());
        } else {
            const double smooth = share * share * share * (10 - 15 * share + 6 * share * share);
            at_ = from_ + smooth * (to_ - from_) + bow_ * std::sin(pi * share);
        }
        return fvec2(at_);
    }

private:
    double uniform() { return random_.uniform(); }
    double noise() { return 2 * uniform() - 1; }

    void begin() {
        const double kind = uniform();
        from_ = to_ = at_;
        bow_ = vec2(0);
        tracks_ = kind > 0.65;
        speed_ = goal_ = vec2(0);
        if (tracks_) {
            left_ = ticks(0.5 + 2 * uniform());
        } else if (kind < 0.45) {  // a quick move, mostly sideways, or a correction after it
            const bool correction = kind < 0.2;
            const double size = (correction ? 60 : 700) * (0.15 + uniform());
            to_ += size * vec2(noise(), (correction ? 1 : 0.4) * noise());
            bow_ = 0.08 * size * vec2(noise(), noise());
            left_ = ticks(correction ? 0.08 + 0.1 * uniform() : 0.12 + 0.3 * uniform());
        } else {
            left_ = ticks(0.05 + 0.5 * uniform());
        }
        length_ = left_;
    }

    Random random_;
    vec2 at_{0}, from_{0}, to_{0}, bow_{0}, speed_{0}, goal_{0};
    Tick left_ = 0, length_ = 1;
    bool tracks_ = false;
};

TEST(FreeCasting, TenMinutesOfAimingCastAtMostOnce) {
    Free play;
    Aiming aiming(1);
    for (Tick t = 0; t < ticks(600); ++t) {
        const auto place = aiming.next();
        play.move_to(static_cast<double>(place.x), static_cast<double>(place.y));
    }
    EXPECT_LE(play.casts(), 1U);
}

/// Motion of real mice between gestures (public data beside the source tree). The motion within labelled
/// gestures is left out.
std::vector<fvec2> recorded_places(Tick most) {
    const auto folder = std::filesystem::path(THAUM_SOURCE_DIR) / "../shared/data/gestures";
    const auto sessions = gesture::load_sessions(folder / "machete-mouse-sessions.csv.gz");
    const auto marked = gesture::load_labels(folder / "machete-mouse-sessions.labels.csv");
    std::vector<fvec2> places;
    if (!sessions || !marked) return places;
    fvec2 at(0);
    for (const auto& session : sessions->sessions) {
        const auto labelled = [&](double t) {
            return std::any_of(marked->begin(), marked->end(), [&](const auto& label) {
                return label.user == session.user && t >= label.start - 0.2 && t <= label.end + 0.2;
            });
        };
        for (std::size_t i = 1; i < session.points.size() && places.size() < most; ++i) {
            const auto &from = session.points[i - 1], &to = session.points[i];
            if (labelled(to.t)) continue;
            at += fvec2(vec2(to.at.x - from.at.x, from.at.y - to.at.y));
            const auto length = std::clamp<Tick>(ticks(to.t - from.t), 1, ticks(1.0));
            places.insert(places.end(), length, at);
        }
    }
    return places;
}

TEST(FreeCasting, TenMinutesOfRecordedMiceCastAtMostOnce) {
    const auto places = recorded_places(ticks(600));
    if (places.empty()) GTEST_SKIP() << "no recorded sessions here";
    Free play;
    for (const auto& place : places) {
        play.move_to(static_cast<double>(place.x), static_cast<double>(place.y));
    }
    EXPECT_LE(play.casts(), 1U);
}

TEST(FreeCasting, TenMinutesOfBotsCastAtMostOnce) {
    std::size_t casts = 0;
    Tick played = 0;
    for (std::uint64_t seed = 1; played < ticks(600); ++seed) {
        auto made = make_bot_duel(test::assets(), test::duel_data(), {"level_3", "level_2"}, seed).value();
        auto& duel = made;
        auto setup = duel.match->setup();
        for (auto& device : setup.devices) device.casts_freely = true;
        duel.match = std::make_unique<Simulation>(test::duel_data(), setup);
        std::array<Tick, players> last{};
        while (duel.match->match().phase == Phase::playing && played < ticks(600)) {
            duel.run(8);
            played += 8;
            duel.match->world().view<const Wizard, const FreeHand>().each(
                [&](ecs::Entity, const Wizard& wizard, const FreeHand& hand) {
                    if (hand.cast_at != last.at(wizard.player)) ++casts;
                    last.at(wizard.player) = hand.cast_at;
                });
        }
    }
    EXPECT_LE(casts, 1U);
}

}  // namespace
}  // namespace thaum::game
