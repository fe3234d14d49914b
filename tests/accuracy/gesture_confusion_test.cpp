// Tests how well the shipped gestures (assets/gestures) are recognised in strokes and scribbles of generated
// users.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>

#include "core/file.h"
#include "core/text.h"
#include "gesture/collisions.h"
#include "gesture/generated_users.h"
#include "gesture/gesture_file.h"
#include "gesture/variations.h"

namespace thaum::gesture {
namespace {

const std::filesystem::path shipped = std::filesystem::path(THAUM_SOURCE_DIR) / "assets/gestures";

std::vector<Gesture> shipped_gestures() {
    std::vector<Gesture> gestures;
    for (const auto name : figure_names()) {
        gestures.push_back(load_gesture(shipped / (std::string(name) + ".toml")).value());
    }
    return gestures;
}

struct Figures {
    /// Number of strokes, by [gesture that was drawn][gesture that was recognised]. The last column counts
    /// strokes that were not recognised.
    std::array<std::array<int, figures + 1>, figures> read{};
    int right = 0, right_force = 0, scribbles_taken = 0;
    int drawn = 0, scribbled = 0;
    std::array<int, figures> taken_as{};
};

Figures measure(const Recogniser& recogniser, std::uint64_t seed) {
    Figures f;
    RecogniserSpace space;
    const GeneratedSetSettings settings{.users = 100, .samples = 2, .seed = seed};
    for (const auto& stroke : generated_strokes(settings)) {
        const auto r = recogniser.recognise(stroke.points, space);
        std::size_t g = 0;
        while (figure_names()[g] != stroke.gesture) ++g;
        ++f.read[g][r.accepted ? r.gesture : figures];
        const bool right = r.accepted && r.gesture == g;
        f.right += right;
        const auto meant = stroke.sample.starts_with("gentle") ? ForceClass::gentle : ForceClass::harsh;
        f.right_force += right && r.force == meant;
        ++f.drawn;
    }
    for (const auto& stroke : generated_scribbles(settings)) {
        const auto r = recogniser.recognise(stroke.points, space);
        f.scribbles_taken += r.accepted;
        if (r.accepted) ++f.taken_as[r.gesture];
        ++f.scribbled;
    }
    return f;
}

void print(const Figures& f) {
    for (std::size_t g = 0; g < figures; ++g) {
        std::printf("%-7s", std::string(figure_names()[g]).c_str());
        for (const int count : f.read[g]) std::printf(" %5d", count);
        std::printf("   scribbles %d\n", f.taken_as[g]);
    }
    std::printf("right %.2f %%, with force %.2f %%, scribbles accepted %.2f %%\n", 100.0 * f.right / f.drawn,
                100.0 * f.right_force / f.drawn, 100.0 * f.scribbles_taken / f.scribbled);
}

TEST(GestureConfusion, OtherUsersAreReadAndScribblesAreNot) {
    const auto recogniser = Recogniser::make(shipped_gestures()).value();
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const auto f = measure(recogniser, seed);
        print(f);
        EXPECT_GE(f.right, 0.95 * f.drawn) << "seed " << seed;
        EXPECT_GE(f.right_force, 0.98 * f.right) << "seed " << seed;
        EXPECT_LE(f.scribbles_taken, 0.05 * f.scribbled) << "seed " << seed;
        for (const auto& row : f.read) {
            const int all = row[0] + row[1] + row[2] + row[3] + row[4];
            EXPECT_LE(row[figures], all / 10) << "a gesture that is often read as nothing";
        }
    }
}

/// Twins are a gentle and a harsh gesture of the same shape. They differ only in force: half and twice the
/// force of an ordinary stroke, with a scatter of 15 %. They are recognised from one stroke each by one
/// generated user, among the other shipped gestures.
TEST(GestureConfusion, TwinsOfOneStrokeEachAreToldApartByForce) {
    const auto shipped = shipped_gestures();
    RecogniserSpace space;
    int right = 0, drawn = 0;
    for (std::uint64_t seed = 0; seed < 24; ++seed) {
        Random random = random_stream(seed, 1);
        auto style = random_style(random);
        style.mirrored_circle = false;
        const auto figure = static_cast<Figure>(seed % figures);
        const auto draw = [&](bool harsh) {
            auto stroke = draw_figure(figure, style, Effort::normal, random);
            const double by = (harsh ? 2 : 0.5) * det::exp(0.15 * normal(random));
            for (auto& p : stroke) p.force *= by;
            return stroke;
        };
        auto gestures = shipped;
        auto& gentle = gestures[seed % figures];
        gentle.options.gentle_below = gentle.options.harsh_above = 0;
        gentle.strokes = {draw(false)};
        gestures.push_back({"harsh", gentle.options, {draw(true)}});
        const auto recogniser = Recogniser::make(gestures, {.calibrate = false}).value();
        for (int i = 0; i < 20; ++i, ++drawn) {
            const bool harsh = i % 2 == 1;
            const auto r = recogniser.recognise(draw(harsh), space);
            right += r.gesture == (harsh ? figures : seed % figures);
        }
    }
    EXPECT_GE(right, 0.98 * drawn);
}

/// With one stroke of each gesture by one user, probabilities must be right for strokes of another user.
TEST(GestureConfusion, ProbabilitiesHoldForStrokesOfAnotherUser) {
    const auto shipped = shipped_gestures();
    RecogniserSpace space;
    double shown = 0, even = 0, right = 0, drawn = 0;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        Random random = random_stream(seed, 7);
        const auto user = random_style(random), other = random_style(random);
        auto gestures = shipped;
        for (std::size_t f = 0; f < figures; ++f)
            gestures[f].strokes = {draw_figure(static_cast<Figure>(f), user, Effort::normal, random)};
        const auto recogniser = Recogniser::make(gestures).value();
        for (std::size_t i = 0; i < 10 * figures; ++i, ++drawn) {
            const auto figure = static_cast<Figure>(i % figures);
            const auto r = recogniser.recognise(draw_figure(figure, other, Effort::normal, random), space);
            shown += r.probability;
            even += r.even_probability;
            right += r.gesture == i % figures ? 1 : 0;
        }
    }
    EXPECT_NEAR(shown / drawn, right / drawn, 0.05);
    EXPECT_LT(even / drawn, shown / drawn) << "as if every second stroke meant nothing";
}

/// The probabilities must also hold for gestures of any shape, with users who differ twice as much as the
/// strokes that the recogniser generates to calibrate its probabilities.
TEST(GestureConfusion, ProbabilitiesHoldForUsersWhoDifferMoreThanSyntheticOnes) {
    const VariationSettings users{.tilt = 0.1, .stretch = 0.2, .bend = 0.1};
    constexpr std::size_t shapes = 8;
    RecogniserSpace space;
    double shown = 0, right = 0, drawn = 0;
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        Random random = random_stream(seed, 11);
        const auto style = random_style(random);
        std::vector<std::vector<StrokePoint>> ideas;
        std::vector<Gesture> gestures;
        for (std::size_t g = 0; g < shapes; ++g) {
            ideas.push_back(draw_scribble(style, random));
            gestures.push_back({text(g), {}, {variation_of(ideas[g], random, users)}});
        }
        const auto recogniser = Recogniser::make(gestures).value();
        for (std::size_t i = 0; i < 8 * shapes; ++i, ++drawn) {
            const auto r = recogniser.recognise(variation_of(ideas[i % shapes], random, users), space);
            shown += r.probability;
            right += r.gesture == i % shapes ? 1 : 0;
        }
    }
    EXPECT_NEAR(shown / drawn, right / drawn, 0.05);
}

/// A V that a mouse with steps of 0.1 mm draws at one speed, along two straight lines. Each report is off by
/// up to one count in x and in y, and the force is that of a viscous field. Before and after the stroke the
/// hand rests, and trembles by a normal distribution.
std::vector<StrokePoint> even_vee(Random& random, double rest_before, double rest_after, double tremor) {
    constexpr double count = 1e-4;
    const double rate = 125 * std::exp2(static_cast<double>(random.below(4)));
    const double half = random.uniform(0.3, 0.55), tilt = random.uniform(-0.14, 0.14);
    const double leg = random.uniform(0.03, 0.1) / std::cos(half), speed = random.uniform(0.06, 0.5);
    const double lasts = 2 * leg / speed;
    std::vector<StrokePoint> points;
    for (double t = 0; t < rest_before + lasts + rest_after; t += 1 / rate) {
        const double way = std::clamp(t - rest_before, 0.0, lasts) * speed;
        const bool rests = t < rest_before || t > rest_before + lasts;
        vec3 at =
            rotation({0, 0, 1}, tilt) * vec3(way * std::sin(half), std::abs(way - leg) * std::cos(half), 0);
        for (int axis = 0; axis < 2; ++axis) {
            const double off = rests ? tremor * normal(random) : 0;
            const double jitter = rests ? 0 : static_cast<double>(random.below(3)) - 1;
            at[axis] = count * (std::floor((at[axis] + off) / count + 0.5) + jitter);
        }
        const double step = points.empty() ? 0 : glm::distance(at, points.back().at);
        points.push_back({t, at, stroke_viscosity * step * rate});
    }
    return points;
}

TEST(GestureConfusion, EvenStrokesOfAMouseAreReadAlsoWithRests) {
    const auto recogniser = Recogniser::make(shipped_gestures()).value();
    EXPECT_FALSE(recogniser.counts_force());
    RecogniserSpace space;
    Random random = random_stream(28, 1);
    constexpr int tries = 400;
    int plain = 0, rested = 0;
    for (int i = 0; i < tries; ++i) {
        const auto is_read = [&](const std::vector<StrokePoint>& stroke) {
            const auto r = recogniser.recognise(stroke, space);
            return r.accepted && recogniser.name(r.gesture) == "v";
        };
        plain += is_read(even_vee(random, 0, 0, 0));
        const double before = i % 2 == 0 ? random.uniform(0.5, 20) : 0,
                     after = i % 3 == 0 ? random.uniform(0.5, 20) : 0;
        rested += is_read(even_vee(random, before, after, random.uniform(0, 2e-4)));
    }
    EXPECT_GE(plain, 0.99 * tries);
    EXPECT_GE(rested, 0.99 * tries);
}

TEST(GestureConfusion, TheShippedFilesAreThoseOfTheGenerator) {
    for (const auto& gesture : generated_templates(1)) {
        const auto file = read_text_file(shipped / (gesture.name + ".toml"), max_gesture_bytes).value();
        EXPECT_TRUE(file == to_file(gesture)) << gesture.name << ": run `thaum gesture generate`";
    }
}

TEST(GestureConfusion, NoTwoShippedGesturesCollide) {
    const auto pairs = compare_gestures(shipped_gestures()).value();
    EXPECT_EQ(pairs.size(), 6U);
    for (const auto& pair : pairs) EXPECT_FALSE(pair.collides()) << pair.a << " and " << pair.b;
}

}  // namespace
}  // namespace thaum::gesture
