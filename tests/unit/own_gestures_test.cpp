// Tests of gestures that players have drawn themselves: from the player's profile (the stored own gestures)
// through a match and its log to a replay without that profile.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "core/file.h"
#include "core/text.h"
#include "game/casting/casting.h"
#include "game/data/reading.h"
#include "game/match/playback.h"
#include "game/range/range.h"
#include "game/settings/own_gestures.h"
#include "game/settings/player_name.h"
#include "gesture/gesture_file.h"
#include "gesture/variations.h"
#include "unit/game_duel.h"
#include "unit/message_of.h"

namespace thaum::game {
namespace {

using game::test::two_hands;

std::shared_ptr<const game::MatchData> own_data() {
    static const auto loaded = game::test::duel_data();
    return loaded;
}

/// Motion of the mouse in one tick (counts) while a hand draws a triangle in 800 ticks.
vec2 triangle_counts(int tick) {
    const int side = tick / 267;
    return side == 0 ? vec2(3, 5) : side == 1 ? vec2(3, -5) : vec2(-6, 0);
}

/// A triangle as a hand with a mouse draws it, recorded as the gesture "circle".
gesture::Gesture triangle() {
    gesture::Gesture g{.name = "circle", .options = {.rotation = 0.3}, .strokes = {}};
    std::vector<gesture::StrokePoint> points;
    vec3 at(0);
    for (int i = 0; i < 800; ++i) {
        const vec2 counts = triangle_counts(i);
        at += 1e-5 * vec3(counts.x, counts.y, 0);
        if (i % 8 == 0) points.push_back({0.001 * i, at, 0.7});
    }
    g.strokes = {points, points, points};
    return g;
}

/// Frame of a tick in which player 1 draws the triangle with the button Trace held.
input::InputFrame triangle_frame(int tick) {
    input::InputFrame frame;
    const int at = tick - 100;
    if (at < 0 || at >= 800) return frame;
    frame.devices[0].press(input::Button::trace);
    const vec2 counts = triangle_counts(at);
    frame.devices[0].counts[input::hand::look_right] = static_cast<int>(counts.x);
    frame.devices[0].counts[input::hand::look_up] = static_cast<int>(counts.y);
    return frame;
}

/// Name of the gesture that was recognised; empty: none.
std::string read_gesture_of(const game::Simulation& match) {
    const auto& last = match.world().get<game::LastReading>(game::wizard_of(match.world(), 0));
    if (last.at == 0 || last.gesture == game::no_gesture) return {};
    return match.data().gestures->gestures()[last.gesture].name;
}

game::MatchSetup setup_with(std::vector<input::ProfileData> profile) {
    auto setup = two_hands();
    const auto used = game::use_profile(*own_data(), std::move(profile), setup);
    EXPECT_TRUE(used) << (used ? "" : used.error().message);
    return setup;
}

TEST(OwnGestures, AreKeptForEachPlayerAndName) {
    const TemporaryFolder folder;
    Settings settings;
    settings.players[1].name = "Zoë";
    const auto first = own_gestures_folder(folder.path() / "settings.toml", settings, 0),
               second = own_gestures_folder(folder.path() / "settings.toml", settings, 1);
    EXPECT_EQ(first, folder.path() / "gestures/player-1");
    EXPECT_NE(first, second);
    ASSERT_TRUE(save_own_gesture(first, triangle()));
    std::vector<std::string> faults;
    const auto own = load_own_gestures(first, *own_data(), 0, faults);
    ASSERT_EQ(own.size(), 1U);
    EXPECT_EQ(own[0], game::profile_of(triangle(), 0));
    EXPECT_TRUE(load_own_gestures(second, *own_data(), 1, faults).empty());
    EXPECT_TRUE(faults.empty());
    EXPECT_TRUE(forget_own_gesture(first, "circle"));
    EXPECT_FALSE(forget_own_gesture(first, "circle"));
    EXPECT_TRUE(load_own_gestures(first, *own_data(), 0, faults).empty());
    EXPECT_FALSE(save_own_gesture({}, triangle()));
    EXPECT_TRUE(own_gestures_folder({}, settings, 0).empty());
}

TEST(OwnGestures, AFaultyFileIsNamedAndTheOthersCount) {
    const TemporaryFolder folder;
    ASSERT_TRUE(save_own_gesture(folder.path(), triangle()));
    std::ofstream(folder.path() / "v.toml") << "version = 1\nname = \"v\"\n";
    std::ofstream(folder.path() / "star.toml") << gesture::to_file(triangle());
    std::ofstream(folder.path() / "else.toml") << "no gesture of the game, so nobody reads it";
    std::vector<std::string> faults;
    const auto own = load_own_gestures(folder.path(), *own_data(), 0, faults);
    ASSERT_EQ(own.size(), 1U);
    EXPECT_EQ(own[0].name, "circle");
    ASSERT_EQ(faults.size(), 2U);
    EXPECT_NE((faults[0] + faults[1]).find("v.toml"), std::string::npos);
    EXPECT_NE((faults[0] + faults[1]).find("its text is of a gesture 'circle'"), std::string::npos);
}

/// The same gesture under another name.
gesture::Gesture renamed(gesture::Gesture gesture, std::string name) {
    gesture.name = std::move(name);
    return gesture;
}

TEST(OwnGestures, ACopyOfAnotherGestureIsRefusedWithTheReason) {
    const auto& data = *own_data();
    const auto shipped = data.gestures->gestures();
    const auto v = std::find_if(shipped.begin(), shipped.end(), [](const auto& g) { return g.name == "v"; });
    const auto refusal = [&](const gesture::Gesture& gesture, const std::vector<input::ProfileData>& profile,
                             std::uint32_t player = 0) {
        return message_of(check_own_gesture(gesture, data, profile, player));
    };
    EXPECT_EQ(refusal(triangle(), {}), "");
    const auto copied = refusal(renamed(*v, "star"), {});
    EXPECT_EQ(copied.find("it is too like V: "), 0U) << copied;
    EXPECT_NE(copied.find(" % of "), std::string::npos) << copied;
    for (const auto& one : shipped) {
        for (const auto& other : shipped) {
            if (one.name == other.name) continue;
            const auto words = refusal(renamed(one, other.name), {});
            EXPECT_EQ(words.find(text("it is too like ", capitalised(one.name), ": ")), 0U)
                << one.name << " drawn for " << other.name << ": " << words;
        }
    }
    EXPECT_EQ(refusal(triangle(), {game::profile_of(triangle(), 0)}), "") << "it replaces an older one";
    // Only this player's own gestures count: a player whose own star is a triangle may draw the default star
    // as a circle.
    const auto star =
        std::find_if(shipped.begin(), shipped.end(), [](const auto& g) { return g.name == "star"; });
    const std::vector<input::ProfileData> own{game::profile_of(renamed(triangle(), "star"), 0)};
    EXPECT_EQ(refusal(renamed(*star, "circle"), own, 0), "");
    EXPECT_EQ(refusal(renamed(*star, "circle"), own, 1).find("it is too like Star: "), 0U);
    EXPECT_EQ(refusal(renamed(triangle(), "v"), own, 0).find("it is too like Star: "), 0U);
}

/// A curve that a hand draws in 1.2 s, 6 cm wide at most.
template <class Curve>
gesture::Gesture gesture_along(std::string name, Curve&& curve) {
    std::vector<gesture::StrokePoint> points;
    for (int i = 0; i <= 150; ++i) points.push_back({0.008 * i, 0.03 * curve(i / 150.0), 0.7});
    return {.name = std::move(name), .options = {.rotation = 0.26, .planar = true}, .strokes = {points}};
}

TEST(OwnGestures, AreRefusedOnlyIfStrokesWouldBeMistaken) {
    const auto& data = *own_data();
    // A triangle resembles other shapes, but a match never takes one for the other.
    for (const auto* name : {"circle", "s", "star", "v"}) {
        const auto own = renamed(triangle(), name);
        const auto fits = check_own_gesture(own, data, {}, 0);
        EXPECT_TRUE(fits) << name << ": " << (fits ? "" : fits.error().message);
        const auto setup = setup_with({game::profile_of(own, 0)});
        const auto& set = *setup.gestures[0];
        gesture::RecogniserSpace space;
        Random random = random_stream(41, 0);
        int mistaken = 0;
        for (int i = 0; i < 200; ++i) {
            const auto stroke = gesture::variation_of(own.strokes[0], random);
            const auto read = game::recognise_drawn(set.recogniser(), stroke, space);
            mistaken += read.accepted && set.name(read.gesture) != name;
        }
        EXPECT_LE(mistaken, 2) << name;
    }
    // The check must find that a narrow V is too similar to the game's V, although the few recorded strokes
    // are more similar to each other.
    const auto narrow = gesture_along(
        "circle", [](double u) { return u < 0.5 ? vec3(0.7 * u, -2 * u, 0) : vec3(0.7 * u, 2 * u - 2, 0); });
    for (const auto* name : {"circle", "s", "star"}) {
        const auto message = message_of(check_own_gesture(renamed(narrow, name), data, {}, 0));
        EXPECT_EQ(message.find("it is too like V: "), 0U) << message;
    }
    // A match would recognise the turns of a spiral one by one, as circles.
    const auto spiral =
        gesture_along("s", [](double u) { return u * vec3(std::cos(6 * pi * u), std::sin(6 * pi * u), 0); });
    const auto fits = check_own_gesture(spiral, data, {}, 0);
    ASSERT_FALSE(fits);
    EXPECT_NE(fits.error().message.find("it is too like Circle: "), std::string::npos)
        << fits.error().message;
    EXPECT_NE(fits.error().message.find("of such strokes are taken for it"), std::string::npos)
        << fits.error().message;
}

TEST(OwnGestures, ThatDoNotFitTogetherAreLeftOutInOneLine) {
    // The gestures circle and star each have more than half of the strokes that all gestures together may
    // have, so only one of them fits in.
    auto many = triangle();
    while (many.strokes.size() <= gesture::max_templates / 2) {
        many.strokes.push_back(triangle().strokes.front());
        while (many.strokes.back().size() > 4) many.strokes.back().pop_back();
    }
    const TemporaryFolder folder;
    for (const auto* name : {"circle", "star", "v"})
        ASSERT_TRUE(
            save_own_gesture(folder.path(), renamed(name == std::string("v") ? triangle() : many, name)));
    std::vector<std::string> faults;
    const auto own = load_own_gestures(folder.path(), *own_data(), 0, faults);
    ASSERT_EQ(own.size(), 2U);
    EXPECT_EQ(own[0].name, "circle");
    EXPECT_EQ(own[1].name, "v");
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_NE(
        faults[0].find("star.toml: it is left out, since it does not fit beside the other own gestures"),
        std::string::npos)
        << faults[0];
    game::MatchSetup setup;
    EXPECT_TRUE(game::use_profile(*own_data(), own, setup)) << "the others count";
}

TEST(OwnGestures, StandForTheShippedOneOfThisPlayerOnly) {
    const auto setup = setup_with({game::profile_of(triangle(), 0)});
    ASSERT_NE(setup.gestures[0], nullptr);
    EXPECT_EQ(setup.gestures[1], nullptr);
    const auto shipped = own_data()->gestures->gestures(), own = setup.gestures[0]->gestures();
    ASSERT_EQ(own.size(), shipped.size());
    for (std::size_t i = 0; i < own.size(); ++i) {
        EXPECT_EQ(own[i].name, shipped[i].name);
        EXPECT_EQ(own[i].strokes.size() == 3 && own[i].strokes[0].size() == 100, own[i].name == "circle");
    }
    game::Simulation with(own_data(), setup), without(own_data(), two_hands());
    for (int t = 0; t < 1000; ++t) {
        with.tick(triangle_frame(t));
        without.tick(triangle_frame(t));
    }
    EXPECT_EQ(read_gesture_of(with), "circle");
    EXPECT_EQ(read_gesture_of(without), "");
    EXPECT_NE(with.state_hash(), without.state_hash());
}

TEST(OwnGestures, ALogReplaysWithoutTheProfile) {
    const TemporaryFolder folder;
    const auto profile = folder.path() / "gestures", file = folder.path() / "log.thaumlog";
    ASSERT_TRUE(save_own_gesture(profile, triangle()));
    std::vector<std::string> faults;
    std::uint64_t state = 0;
    {
        game::Simulation match(own_data(), setup_with(load_own_gestures(profile, *own_data(), 0, faults)));
        auto log = input::LogWriter::create(file, log_header(match.data(), match.setup(), {"human", "human"}),
                                            input::WhenBehind::wait)
                       .value();
        for (int t = 0; t < 1200; ++t) game::tick_and_record(match, triangle_frame(t), &log);
        ASSERT_EQ(read_gesture_of(match), "circle");
        state = match.state_hash();
        ASSERT_TRUE(close_log(log, match));
    }
    std::filesystem::remove_all(profile);
    auto playback = game::Playback::open(file, game::test::assets()).value();
    while (playback.step()) {}
    EXPECT_FALSE(playback.divergence());
    EXPECT_EQ(playback.match().state_hash(), state);
    EXPECT_EQ(read_gesture_of(playback.match()), "circle");
    EXPECT_EQ(playback.log().header().profile.size(), 1U);
}

TEST(OwnGestures, WrongProfileDataOfALogIsNamed) {
    auto header = log_header(*own_data(), two_hands(), {"human", "human"});
    const auto fault = [&](input::ProfileData item) {
        header.profile = {std::move(item)};
        return message_of(game::match_of_log(header, game::test::assets()), "none");
    };
    const auto good = game::profile_of(triangle(), 1);
    EXPECT_EQ(fault(good), "none");
    auto wrong = good;
    wrong.kind = "network";
    EXPECT_EQ(fault(wrong), "profile data of the unknown kind 'network'");
    wrong = good;
    wrong.name = "loop";
    EXPECT_EQ(fault(wrong), "gesture 'loop' of player 2: the game has no gesture of this name");
    wrong = good;
    wrong.name = "v";
    EXPECT_EQ(fault(wrong), "gesture 'v' of player 2: its text is of a gesture 'circle'");
    wrong = good;
    wrong.bytes.resize(wrong.bytes.size() / 2);
    EXPECT_NE(fault(wrong).find("gesture 'circle' of player 2"), std::string::npos);
    wrong.bytes.clear();
    EXPECT_NE(fault(wrong).find("gesture 'circle' of player 2"), std::string::npos);
    wrong = good;
    wrong.bytes.resize(std::size_t{2} << 20U);
    EXPECT_NE(fault(wrong).find("more than 1048576 bytes"), std::string::npos);
    header.rule_set = "classic";
    header.files = game::load_match_data(game::test::assets(), {.rules = "classic"})->files;
    header.kinds.clear();
    EXPECT_NE(fault(good).find("no gestures"), std::string::npos);
}

TEST(OwnGestures, OnTheRangeChangeBetweenTwoTicks) {
    const auto data = game::load_range(game::test::assets(), {}).value();
    auto range =
        game::make_range(data, game::bot_device(game::practising, "level_1"), game::DummyKind::still, 3);
    for (int t = 0; t < 100; ++t) range.tick({});
    const auto before = range.match->now();
    ASSERT_TRUE(range.use_gestures({game::profile_of(triangle(), game::practising)}));
    EXPECT_EQ(range.match->now(), before);
    EXPECT_NE(range.match->setup().gestures[game::practising], nullptr);
    range.adopt(data);
    EXPECT_NE(range.match->setup().gestures[game::practising], nullptr) << "files that are read again";
    auto wrong = game::profile_of(triangle(), game::practising);
    wrong.bytes.clear();
    EXPECT_FALSE(range.use_gestures({wrong}));
    EXPECT_NE(range.match->setup().gestures[game::practising], nullptr);
    ASSERT_TRUE(range.use_gestures({}));
    EXPECT_EQ(range.match->setup().gestures[game::practising], nullptr);
}

}  // namespace
}  // namespace thaum::game
