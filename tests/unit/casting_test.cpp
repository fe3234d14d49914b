// Tests of the recognition of drawn strokes, and of strokes in a match.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>

#include "game/casting/casting.h"
#include "game/components/hand_state.h"
#include "game/data/reading.h"
#include "gesture/generated_users.h"
#include "unit/copied_assets.h"
#include "unit/game_duel.h"
#include "unit/message_of.h"

namespace thaum::game::test {
namespace {

using gesture::Figure;
using gesture::StrokePoint;

/// Data of the default match, loaded once.
std::shared_ptr<const MatchData> data() {
    static const auto loaded = duel_data();
    return loaded;
}

const GestureSet& shipped() { return *data()->gestures; }

DrawnStroke drawn(std::span<const StrokePoint> points) {
    DrawnStroke stroke;
    const double step = gameplay_dt;
    for (double t = 0; t <= points.back().t && stroke.count < max_drawn_points; t += step) {
        std::size_t i = 1;
        while (i + 1 < points.size() && points[i].t < t) ++i;
        const auto &a = points[i - 1], &b = points[i];
        const double share = b.t > a.t ? std::clamp((t - a.t) / (b.t - a.t), 0.0, 1.0) : 0;
        const vec3 at = glm::mix(a.at, b.at, share);
        stroke.points[stroke.count++] = {static_cast<float>(at.x), static_cast<float>(at.y),
                                         static_cast<float>(at.z),
                                         static_cast<float>(a.force + share * (b.force - a.force))};
    }
    return stroke;
}

/// Circles of 6 cm, 0.8 s each. A positive number of turns goes clockwise from the top.
DrawnStroke circles(double turns) {
    std::vector<StrokePoint> points;
    const int steps = static_cast<int>(100 * std::abs(turns));
    for (int i = 0; i <= steps; ++i) {
        const double angle = 2 * pi * turns * i / steps;
        points.push_back({0.008 * i, {0.03 * std::sin(angle), 0.03 * std::cos(angle), 0}, 0.8});
    }
    return drawn(points);
}

TEST(Casting, TurnsOfACircleAreCounted) {
    ReadingSpace space;
    for (const double turns : {1.0, -1.0, 2.0, 3.0, -3.0, 5.0}) {
        const auto reading = read_drawn(shipped(), circles(turns), space);
        ASSERT_NE(reading.stroke.gesture, no_gesture) << turns;
        EXPECT_EQ(shipped().gestures()[reading.stroke.gesture].name, "circle") << turns;
        EXPECT_NEAR(reading.stroke.turns, turns, 0.02);
        EXPECT_NEAR(reading.stroke.force, 0.8, 1e-6);
        EXPECT_GT(reading.stroke.probability, 0.75);
    }
}

TEST(Casting, AnOpenStrokeHasNoTurns) {
    Random random{3};
    ReadingSpace space;
    for (const auto figure : {Figure::v, Figure::s}) {
        const auto points =
            gesture::draw_figure(figure, gesture::random_style(random), gesture::Effort::gentle, random);
        EXPECT_EQ(read_drawn(shipped(), drawn(points), space).stroke.turns, 0);
    }
}

TEST(Casting, AStarIsNotTwoCircles) {
    Random random{11};
    ReadingSpace space;
    int right = 0;
    for (int i = 0; i < 40; ++i) {
        const auto points = gesture::draw_figure(Figure::star, gesture::random_style(random),
                                                 gesture::Effort::normal, random);
        const auto read = read_drawn(shipped(), drawn(points), space).stroke.gesture;
        right += read != no_gesture && shipped().gestures()[read].name == "star" ? 1 : 0;
    }
    EXPECT_GE(right, 38);
}

std::string_view name_of(Figure figure) { return gesture::figure_names()[static_cast<std::size_t>(figure)]; }

/// The same stroke as a slow device reports it: the hand's position changes only in every `every`-th point.
DrawnStroke told_seldom(DrawnStroke stroke, std::uint32_t every) {
    const double viscosity = data()->casting->viscosity;
    const auto place = [&](std::uint32_t i) {
        return vec3(stroke.points[i].x, stroke.points[i].y, stroke.points[i].z);
    };
    for (std::uint32_t i = 1; i < stroke.count; ++i) {
        auto& p = stroke.points[i];
        if (i % every != 0) p = stroke.points[i - 1];
        p.force = static_cast<float>(viscosity * glm::distance(place(i - 1), place(i)) / gameplay_dt);
    }
    return stroke;
}

TEST(Casting, ReadsAStrokeOfADeviceThatTellsItsPlaceSeldom) {
    Random random{5};
    ReadingSpace space;
    for (const auto figure : {Figure::circle, Figure::v, Figure::s, Figure::star}) {
        std::size_t smooth = 0;
        std::array<std::size_t, 2> seldom{};
        for (int i = 0; i < 20; ++i) {
            auto style = gesture::random_style(random);
            style.flat = true;
            const auto stroke = drawn(gesture::draw_figure(figure, style, gesture::Effort::gentle, random));
            const auto is_read = [&](const DrawnStroke& one) {
                const auto read = read_drawn(shipped(), one, space).stroke.gesture;
                return read != no_gesture && shipped().gestures()[read].name == name_of(figure) ? 1U : 0U;
            };
            smooth += is_read(stroke);
            for (const std::uint32_t k : {0U, 1U}) {
                // A device that reports a position every 24 or 32 ms.
                const auto told = told_seldom(stroke, k + 3);
                seldom.at(k) += is_read(told);
                EXPECT_NEAR(mean_force_of(told), mean_force_of(stroke), 0.25 * mean_force_of(stroke));
            }
        }
        for (const auto right : seldom) EXPECT_GE(right + 2, smooth) << name_of(figure);
    }
}

TEST(Casting, SpreadsJumpsButNeitherSlowMotionNorRests) {
    const auto spread = [](std::vector<vec3> places) {
        spread_jumps(places, 0.008);
        return places;
    };
    const vec3 a(0), b(0.004, 0, 0);
    EXPECT_EQ(spread({a, a, a, a, b, b})[3], 0.75 * b);
    const std::vector<vec3> slow{a, a, a, vec3(1e-4, 0, 0), vec3(1e-4, 0, 0), vec3(2e-4, 0, 0)};
    EXPECT_EQ(spread(slow), slow);
    const std::vector<vec3> rest{a, a, a, a, a, a, a, a, b, b};
    EXPECT_EQ(spread(rest), rest);
    EXPECT_TRUE(spread({}).empty());
}

TEST(Casting, BadStrokesMeanNothing) {
    ReadingSpace space;
    const CastingRules& rules = *data()->casting;
    DrawnStroke none;
    EXPECT_TRUE(is_slip(rules, none));
    EXPECT_EQ(read_drawn(shipped(), none, space).stroke.gesture, no_gesture);
    DrawnStroke one;
    one.count = 1;
    EXPECT_TRUE(is_slip(rules, one));
    EXPECT_EQ(read_drawn(shipped(), one, space).stroke.gesture, no_gesture);
    DrawnStroke still;
    still.count = max_drawn_points;
    EXPECT_TRUE(is_slip(rules, still));
    EXPECT_EQ(read_drawn(shipped(), still, space).stroke.gesture, no_gesture);
    auto broken = circles(1);
    for (const std::uint32_t i : {40U, broken.count - 1}) {
        broken.points[i].x = std::numeric_limits<float>::quiet_NaN();
        EXPECT_EQ(read_drawn(shipped(), broken, space).stroke.gesture, no_gesture);
    }
    auto huge = circles(1);
    for (auto& p : huge.points) p.x *= 1e30F, p.y *= 1e30F;
    EXPECT_NO_FATAL_FAILURE(read_drawn(shipped(), huge, space));
}

/// A match of two scripted players; the test moves the device of the first.
struct Drawer {
    Simulation match{data(), two_hands()};
    input::InputFrame frame{};

    input::DeviceSample& hand() { return frame.devices[0]; }
    ecs::Entity wizard() { return wizard_of(match.world(), 0); }
    /// Draws circles with a radius of `counts` (of the mouse) for some ticks, each circle in `period` ticks.
    void circle(int ticks, int period, double counts) {
        for (int i = 0; i < ticks; ++i) {
            const double angle = 2 * pi * i / period;
            hand().counts[input::hand::look_right] = static_cast<int>(std::lround(counts * std::cos(angle)));
            hand().counts[input::hand::look_up] = static_cast<int>(std::lround(-counts * std::sin(angle)));
            match.tick(frame);
        }
        hand().counts = {};
    }
    void wait(int ticks) {
        for (int i = 0; i < ticks; ++i) match.tick(frame);
    }
};

TEST(Casting, AStrokeOfAnyLengthHasRoom) {
    Drawer drawer;
    drawer.wait(8);
    drawer.hand().press(input::Button::trace);
    drawer.circle(20'000, 800, 3);
    const auto& stroke = drawer.match.world().get<DrawnStroke>(drawer.wizard());
    EXPECT_LE(stroke.count, max_drawn_points);
    EXPECT_GT(stroke.every, 1U);
    EXPECT_NEAR(stroke.count * stroke.every * 8.0, 20'000, 200);
}

/// Draws a star 10 cm wide with the button Trace held, in steps of 8 ms like a slow mouse, and returns what
/// was recognised.
LastReading read_star(Drawer& drawer, int jumps) {
    const auto place = [](double share) {
        const auto corner = [](double k) {
            return 500.0 * vec2(std::sin(4 * pi * (k + 0.5) / 5), std::cos(4 * pi * (k + 0.5) / 5));
        };
        const double side = std::min(4.0, std::floor(5 * share));
        return glm::mix(corner(side), corner(side + 1), 5 * share - side);
    };
    drawer.wait(200);
    drawer.hand().press(input::Button::trace);
    drawer.wait(100);
    for (int i = 1; i <= jumps; ++i) {
        const auto from = glm::round(place((i - 1.0) / jumps)), to = glm::round(place(1.0 * i / jumps));
        drawer.hand().counts[input::hand::look_right] = static_cast<std::int32_t>(to.x - from.x);
        drawer.hand().counts[input::hand::look_up] = static_cast<std::int32_t>(to.y - from.y);
        drawer.wait(1);
        drawer.hand().counts = {};
        drawer.wait(7);
    }
    drawer.wait(150);
    drawer.hand().buttons = 0;
    drawer.wait(50);
    return drawer.match.world().get<LastReading>(drawer.wizard());
}

TEST(Casting, AStarMayBeFastButNotTooFast) {
    Drawer drawer;
    drawer.wait(8);
    for (const int jumps : {38, 60, 120}) {  // strokes that last 0.3 to 1 s
        const auto reading = read_star(drawer, jumps);
        ASSERT_NE(reading.gesture, no_gesture) << jumps;
        EXPECT_EQ(shipped().name(reading.gesture), "star");
    }
    const auto reading = read_star(drawer, 25);  // in 0.2 s: so fast that the hand cuts the corners
    EXPECT_EQ(reading.gesture, no_gesture);
    EXPECT_EQ(shipped().name(reading.nearest), "star");
    EXPECT_TRUE(is_too_fast(*data()->casting, reading.force)) << reading.force;
    EXPECT_FALSE(is_too_fast(*data()->casting, read_star(drawer, 120).force));
}

TEST(Casting, TheHandIsBackWhereItWas) {
    Drawer drawer;
    drawer.wait(8);
    for (int times = 0; times < 20; ++times) {
        drawer.hand().press(input::Button::trace);
        drawer.circle(407 + times, 700, 4);  // an open curve, which ends at another place than it began
        drawer.hand().buttons = 0;
        drawer.wait(33);
        EXPECT_EQ(drawer.match.world().get<HandState>(drawer.wizard()).home, vec3(0)) << times;
        EXPECT_FALSE(drawer.match.world().has<DrawnStroke>(drawer.wizard()));
    }
}

TEST(Casting, TheDeadDrawNothing) {
    Drawer drawer;
    drawer.wait(8);
    drawer.hand().press(input::Button::trace);
    drawer.circle(200, 800, 4);
    drawer.match.world_to_change().get<Health>(drawer.wizard()).points = 0;
    drawer.circle(100, 800, 4);
    EXPECT_FALSE(drawer.match.world().has<DrawnStroke>(drawer.wizard()));
    drawer.hand().buttons = 0;
    drawer.wait(20);
    drawer.hand().press(input::Button::trace);
    drawer.wait(20);
    EXPECT_FALSE(drawer.match.world().has<DrawnStroke>(drawer.wizard()));
}

TEST(Casting, TheSpaceIsViscousWhileAStrokeIsDrawn) {
    Drawer drawer;
    drawer.wait(8);
    drawer.hand().press(input::Button::trace);
    drawer.circle(400, 800, 4);
    const HandState hand = drawer.match.world().get<HandState>(drawer.wizard());
    EXPECT_EQ(hand.servo.viscosity, data()->casting->viscosity);
    EXPECT_LT(glm::dot(hand.servo.safety.output, hand.device.velocity), 0);
    drawer.hand().buttons = 0;
    drawer.wait(20);
    EXPECT_EQ(drawer.match.world().get<HandState>(drawer.wizard()).servo.viscosity, 0);
}

TEST(Casting, ARecallGoesOnFromAKeyframeToTheSameBits) {
    Simulation match(data(), two_hands());
    auto& world = match.world_to_change();
    const auto wizard = wizard_of(world, 0);
    const vec3 from = std::as_const(world).get<Motion>(wizard).position;
    ecs::Entity thing;
    world.view<const Prop, const Body>().each([&](ecs::Entity e, const Prop&, const Body& body) {
        if (body.mass > 0 && body.mass < 20) thing = e;
    });
    ASSERT_TRUE(thing);
    const auto key_chord = [&](int t) {  // the keys that cast the star's spell without drawing
        input::InputFrame frame;
        if (t >= 1900 && t < 1960) frame.devices[0].press(input::Button::trace);
        frame.devices[0].wand = t >= 1930 && t < 1940 ? 4 : 0;
        return frame;
    };
    for (int t = 0; t < 1900; ++t) match.tick(key_chord(t));
    world.get<LastProp>(wizard).thing = thing;
    auto& motion = world.get<Motion>(thing);
    motion = {};
    motion.position = from * vec3(0.3, 1, 0.3);
    match.physics().set_state(thing.index, motion);
    for (int t = 1900; t < 2048; ++t) match.tick(key_chord(t));
    ASSERT_GT(glm::length(std::as_const(world).get<Motion>(thing).velocity), 1) << "it flies";
    Bytes saved;
    match.save(saved);
    Simulation restored(data(), two_hands());
    ASSERT_TRUE(restored.restore(saved, match.now()));
    EXPECT_EQ(restored.state_hash(), match.state_hash());
    for (int t = 0; t < 200; ++t) {
        match.tick({});
        restored.tick({});
        ASSERT_EQ(restored.state_hash(), match.state_hash()) << t;
    }
}

TEST(Casting, TwoGesturesOfOneNameAreRefusedWithTheirFiles) {
    const CopiedAssets copied;
    const auto gestures = copied.path / "gestures";
    std::filesystem::copy_file(gestures / "circle.toml", gestures / "ring.toml");
    EXPECT_EQ(message_of(load_match_data(copied.path, {})),
              "assets/gestures/ring.toml: has the name 'circle', as assets/gestures/circle.toml has; "
              "change one, or delete a file");
}

TEST(Casting, ARuleSetWithoutSpellsHasNoStrokes) {
    const auto classic = load_match_data(assets(), {.rules = "classic"}).value();
    EXPECT_EQ(classic.gestures, nullptr);
    EXPECT_TRUE(classic.spells.empty());
    Simulation match(std::make_shared<const MatchData>(classic), two_hands());
    input::InputFrame frame;
    frame.devices[0].press(input::Button::trace);
    for (int i = 0; i < 100; ++i) match.tick(frame);
    EXPECT_EQ(match.world().count<DrawnStroke>(), 0U);
    EXPECT_EQ(match.world().count<Focus>(), 0U);
}

}  // namespace
}  // namespace thaum::game::test
