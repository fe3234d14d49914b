// Tests of resampling, normalisation, the dot product by which paper 000 compares strokes, and the elastic
// distance compared with a plain computation.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.h"
#include "gesture/elastic.h"
#include "gesture/trials/dot.h"
#include "gesture/variations.h"
#include "unit/gesture_shapes.h"

namespace thaum::gesture {
namespace {

Shape shape_of(const Course& stroke, Channels channels = {false, true}) {
    static ShapeSpace space;
    Shape shape;
    EXPECT_TRUE(make_shape(stroke, channels, space, shape));
    return shape;
}

TEST(GestureDot, ResampledPointsAreEquallySpaced) {
    // The parabola is drawn at uneven speed: its points are farther apart towards the end.
    const auto stroke = drawn([](double u) { return vec3(u * u, 2 * u, 0.5 * u * u); }, 500);
    const auto points = equally_spaced(stroke);
    std::vector<double> steps;
    for (std::size_t i = 1; i < dot_points; ++i)
        steps.push_back(glm::length(points[i].at - points[i - 1].at));
    const auto [least, most] = std::minmax_element(steps.begin(), steps.end());
    EXPECT_LT(*most / *least, 1.001);
    EXPECT_EQ(points.front().at, stroke.front().at);
    EXPECT_LT(glm::length(points.back().at - stroke.back().at), 1e-12);
}

TEST(GestureDot, AStrokeTimesItselfIsOneAndTimesItsOppositeLess) {
    StrokeVector a{}, b{};
    for (const auto& stroke : {circle(), vee(), ess()}) {
        ASSERT_TRUE(make_vector(stroke, {}, a));
        EXPECT_NEAR(dot_product(a, a), 1, 1e-14);
    }
    ASSERT_TRUE(make_vector(circle(0, 1), {}, a));
    ASSERT_TRUE(make_vector(circle(0, -1), {}, b));
    EXPECT_LT(dot_product(a, b), 0.1);
}

TEST(GestureDot, PlaceSizeAndSpeedDoNotCount) {
    StrokeVector a{}, b{};
    ASSERT_TRUE(make_vector(ess(), {}, a));
    ASSERT_TRUE(make_vector(moved(ess(), {3, -7, 2}, 40, 0.2), {}, b));
    EXPECT_NEAR(dot_product(a, b), 1, 1e-12);
}

TEST(GestureShape, PlaceAndSizeDoNotCount) {
    const auto a = shape_of(ess()), b = shape_of(moved(ess(), {300, -700, 0}, 64));
    for (std::size_t i = 0; i < shape_points * planar_channels; ++i)
        EXPECT_NEAR(a.values[i], b.values[i], 2e-4F) << i;
    EXPECT_NEAR(b.size / a.size, 64, 1e-3);
}

TEST(GestureShape, IsCentredAndOfUnitSize) {
    const auto s = shape_of(moved(vee(), {5, 5, 0}, 3));
    double x = 0, y = 0, squares = 0;
    for (std::size_t i = 0; i < shape_points; ++i) {
        const float* v = &s.values[i * planar_channels];
        x += static_cast<double>(v[0]);
        y += static_cast<double>(v[1]);
        squares += static_cast<double>(v[0] * v[0] + v[1] * v[1]);
    }
    EXPECT_NEAR(x, 0, 1e-4);
    EXPECT_NEAR(y, 0, 1e-4);
    EXPECT_NEAR(squares / shape_points, 1, 1e-4);
}

TEST(GestureShape, ARestBeforeOrAfterTheStrokeHasNoEffect) {
    auto stroke = vee();
    Course rested(50, StrokePoint{0, stroke[0].at, 0});
    for (std::size_t i = 0; i < rested.size(); ++i) rested[i].t = 0.01 * static_cast<double>(i);
    for (auto p : stroke) rested.push_back({p.t + 0.5, p.at, p.force});
    for (int i = 1; i < 10; ++i) rested.push_back({1.5 + 0.01 * i, stroke.back().at, 0});
    EXPECT_LT(elastic_distance(shape_of(stroke), shape_of(rested)), 1.5e-3F);
    EXPECT_NEAR(shape_of(rested).start_t, 0.5, 0.02);
    EXPECT_NEAR(shape_of(rested).end_t, 1.5, 0.02);
}

/// The stroke with rests. During the rests the hand trembles with white noise of the standard deviation
/// `tremor`, sampled at the stroke's rate.
Course with_rests(const Course& stroke, double before, double within, double after, double tremor) {
    Random random = random_stream(8, 8);
    const double step = stroke[1].t - stroke[0].t;
    Course result;
    double t = 0;
    const auto rest = [&](vec3 at, double s) {
        for (const double end = t + s; t < end; t += step)
            result.push_back({t, at + tremor * vec3(normal(random), normal(random), 0), 0});
    };
    rest(stroke.front().at, before);
    for (std::size_t i = 0; i < stroke.size(); ++i, t += step) {
        result.push_back({t, stroke[i].at, stroke[i].force});
        if (i == stroke.size() / 2) rest(stroke[i].at, within);
    }
    rest(stroke.back().at, after);
    return result;
}

/// A rest must be found from its first point to its last. If it were searched only in a stroke with fewer
/// points, or only some tenths of a second after the start, tremor would remain at the stroke's ends.
TEST(GestureShape, ARestIsLeftOutFromItsFirstPointToItsLast) {
    for (const auto& stroke : {vee(1001), ess(1001), circle(0, 1, 1001)}) {
        for (const double s : {1.0, 12.0}) {
            const auto rested = shape_of(with_rests(stroke, s, 0, s, 0.008));
            EXPECT_NEAR(rested.start_t, s, 0.025) << s;
            EXPECT_NEAR(rested.end_t, s + 1, 0.025) << s;
        }
    }
}

TEST(GestureShape, RestsOfATremblingHandHaveNoEffect) {
    for (const std::size_t points : {61U, 126U, 1001U}) {
        for (const auto& stroke : {vee(points), ess(points)}) {
            const auto plain = shape_of(stroke);
            for (const double tremor : {0.0, 0.004, 0.006}) {
                for (const double s : {0.0, 0.4, 1.0, 20.0}) {
                    const auto far = [&](const Course& rested) {
                        return elastic_distance(plain, shape_of(rested));
                    };
                    EXPECT_LT(far(with_rests(stroke, s, 0, 0, tremor)), 0.03F) << s << " s before";
                    EXPECT_LT(far(with_rests(stroke, 0, 0, s, tremor)), 0.03F) << s << " s after";
                    EXPECT_LT(far(with_rests(stroke, s, 0, s, tremor)), 0.03F) << s << " s at both ends";
                    EXPECT_LT(far(with_rests(stroke, 0, s, 0, tremor)), 0.04F) << s << " s within";
                }
            }
            const auto rested = shape_of(with_rests(stroke, 20, 5, 20, 0.004));
            EXPECT_NEAR(rested.start_t, 20, 0.1);
            EXPECT_NEAR(rested.end_t, 26, 0.15);
            EXPECT_NEAR(rested.seconds, 1.1, 0.15);
        }
    }
}

TEST(GestureShape, NothingButARestIsReadAsItIs) {
    Course rest(300, StrokePoint{0, {1, 1, 0}, 0});
    Random random = random_stream(1, 8);
    for (std::size_t i = 0; i < rest.size(); ++i)
        rest[i] = {0.01 * static_cast<double>(i), {0.01 * normal(random), 0.01 * normal(random), 0}, 0};
    EXPECT_GT(shape_of(rest).size, 0);
    for (auto& p : rest) p.at *= 1e300;
    ShapeSpace space;
    Shape shape;
    EXPECT_FALSE(make_shape(rest, {}, space, shape));
}

TEST(GestureShape, ForceInAnotherUnitIsTheSame) {
    auto newtons = drawn([](double u) { return vec3(u, u * u, 0); });
    for (auto& p : newtons) p.force = 1 + det::sin(6 * p.t);
    auto grams = newtons;
    for (auto& p : grams) p.force *= 101.97;
    EXPECT_LT(elastic_distance(shape_of(newtons), shape_of(grams)), 1e-6F);
}

/// The elastic distance by its recurrence, computed plainly over all pairs of points; the engine visits only
/// pairs of nearly equal index.
double full_distance(const Shape& a, const Shape& b) {
    constexpr std::size_t n = shape_points;
    std::vector<std::vector<double>> sum(n + 1, std::vector<double>(n + 1, 1e30));
    sum[0][0] = 0;
    for (std::size_t i = 1; i <= n; ++i) {
        for (std::size_t j = 1; j <= n; ++j) {
            double s = 0;
            for (std::size_t c = 0; c < a.channels; ++c) {
                const auto d = static_cast<double>(a.values[(i - 1) * a.channels + c] -
                                                   b.values[(j - 1) * b.channels + c]);
                s += d * d;
            }
            sum[i][j] = s / (1 + 2 * s) + std::min({sum[i - 1][j - 1], sum[i - 1][j], sum[i][j - 1]});
        }
    }
    return sum[n][n] / n;
}

TEST(GestureElastic, EqualsAFullComparisonOfSimilarStrokesAndIsNeverLess) {
    Random random = random_stream(4, 2);
    int equal = 0;
    for (int i = 0; i < 40; ++i) {
        const auto a = shape_of(ess()), b = shape_of(variation_of(ess(), random, careful)),
                   c = shape_of(variation_of(vee(), random, careful));
        EXPECT_GE(static_cast<double>(elastic_distance(a, b)), full_distance(a, b) - 1e-6);
        EXPECT_GE(static_cast<double>(elastic_distance(a, c)), full_distance(a, c) - 1e-6);
        equal += std::abs(static_cast<double>(elastic_distance(a, b)) - full_distance(a, b)) < 1e-5;
    }
    EXPECT_GE(equal, 35);
}

TEST(GestureElastic, EightAtOnceHaveTheBitsOfOne) {
    Random random = random_stream(7, 1);
    for (const bool depth : {false, true}) {
        const Channels channels{depth, true};
        EightShapes templates, strokes;
        std::vector<Shape> shapes;
        for (std::size_t k = 0; k < lanes; ++k) {
            shapes.push_back(shape_of(variation_of(k % 2 == 0 ? ess() : vee(), random, careful), channels));
        }
        std::array<const float*, lanes> values;
        for (std::size_t k = 0; k < lanes; ++k) values[k] = shapes[k].values.data();
        set_lanes(templates, shapes[0].channels, values);
        const auto stroke = shape_of(variation_of(ess(), random, careful), channels);
        values.fill(stroke.values.data());
        set_lanes(strokes, stroke.channels, values);
        const auto one = elastic_distances(stroke, templates),
                   eight = elastic_distances(strokes, templates, stroke.channels);
        for (std::size_t k = 0; k < lanes; ++k) {
            EXPECT_EQ(one[k], elastic_distance(stroke, shapes[k])) << k;
            EXPECT_EQ(eight[k], one[k]) << k;
        }
    }
}

TEST(GestureElastic, ADistanceToItselfIsZeroAndBothWaysAreEqual) {
    const auto a = shape_of(ess()), b = shape_of(circle());
    EXPECT_EQ(elastic_distance(a, a), 0);
    EXPECT_FLOAT_EQ(elastic_distance(a, b), elastic_distance(b, a));
    EXPECT_GT(elastic_distance(a, b), 0.2F);
}

FineShape fine_shape_of(const Course& stroke, FineKind kind = {{false, true}}) {
    static ShapeSpace space;
    Shape shape;
    FineShape fine{};
    EXPECT_TRUE(make_shape(stroke, kind.channels, space, shape));
    EXPECT_TRUE(make_fine_shape(space, 0, space.count - 1, kind, fine));
    return fine;
}

/// Root mean square of one channel (a coordinate, a part of the direction, the turn or the force) of a flat
/// stroke's fine shape.
double size_of(const FineShape& shape, std::size_t channel) {
    double sum = 0;
    for (std::size_t i = 0; i < fine_points; ++i)
        sum += std::pow(static_cast<double>(shape[i * planar_channels + channel]), 2.0);
    return std::sqrt(sum / fine_points);
}

TEST(GestureFineShape, HalfOfTheDifferenceOfTheAxesIsTakenAway) {
    auto wide = circle();
    for (auto& p : wide) p.at.x *= 2;
    const auto even = fine_shape_of(wide), plain = fine_shape_of(wide, {{false, true}, false});
    EXPECT_NEAR(size_of(even, 0) / size_of(even, 1), std::sqrt(size_of(plain, 0) / size_of(plain, 1)), 1e-3);
    EXPECT_NEAR(size_of(plain, 0) / size_of(plain, 1), 2, 0.3);
    for (const auto& shape : {even, plain})
        EXPECT_NEAR(std::hypot(size_of(shape, 0), size_of(shape, 1)), 1, 1e-4);
}

TEST(GestureFineShape, AFlatAxisIsNotBlownUp) {
    const auto line = fine_shape_of(drawn([](double u) { return vec3(u, 1e-4 * u * u, 0); }));
    EXPECT_LT(size_of(line, 1), 1e-3);
}

TEST(GestureFineShape, EightDistancesAreThoseOfPlainLoopsInEveryLane) {
    const auto stroke = fine_shape_of(ess());
    const std::array shapes{fine_shape_of(circle()), fine_shape_of(vee()), stroke};
    EightFineShapes eight, strokes;
    std::array<const float*, lanes> values, same;
    for (std::size_t k = 0; k < lanes; ++k) values[k] = shapes[k % 3].data();
    same.fill(stroke.data());
    set_lanes(eight, planar_channels, values);
    set_lanes(strokes, planar_channels, same);
    const auto one = elastic_distances(stroke, eight, planar_channels);
    EXPECT_EQ(one, elastic_distances(strokes, eight, planar_channels));
    for (std::size_t k = 0; k < lanes; ++k)
        EXPECT_EQ(one[k], (elastic_distance<fine_points>(stroke.data(), values[k], planar_channels)));
    EXPECT_EQ(one[2], 0);
    EXPECT_GT(one[0], 0.1F);
}

}  // namespace
}  // namespace thaum::gesture
