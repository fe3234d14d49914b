// Tests of transfer functions: values at and between points, jumps, hostile numbers, and drawing freehand.
#include "field/transfer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/random.h"
#include "unit/message_of.h"

namespace thaum::field {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double endless = std::numeric_limits<double>::infinity();

TransferFunction through(const std::vector<vec2>& points) { return transfer_function(points).value(); }

/// Sorted points with random jumps and distances from 1e-9 to 1e9.
TransferFunction random_function(Random& random) {
    std::vector<vec2> points(1 + random.below(max_transfer_points));
    double x = random.uniform(-1e3, 1e3);
    for (vec2& p : points) {
        p = {x, random.uniform(-1, 1) * det::pow(10, random.uniform(-6, 6))};
        if (random.below(4) != 0) x += det::pow(10, random.uniform(-9, 9));
    }
    return through(points);
}

std::span<const vec2> points_of(const TransferFunction& f) { return std::span(f.points).first(f.count); }

TEST(TransferFunction, IsExactAtItsPointsAndConstantBeyond) {
    Random random = random_stream(1, 1);
    for (int run = 0; run < 500; ++run) {
        const TransferFunction f = random_function(random);
        const auto points = points_of(f);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const bool last = i + 1 == points.size() || points[i + 1].x > points[i].x;
            if (last) {
                EXPECT_EQ(f(points[i].x), points[i].y);
            }
        }
        const double below = std::nextafter(points.front().x, -endless);
        const double above = std::nextafter(points.back().x, endless);
        for (const double x : {below, -1e200, -endless, no_number}) EXPECT_EQ(f(x), points.front().y) << x;
        for (const double x : {above, 1e200, endless}) EXPECT_EQ(f(x), points.back().y) << x;
    }
}

TEST(TransferFunction, EachPieceIsMonotoneAndWithinItsEnds) {
    Random random = random_stream(2, 2);
    for (int run = 0; run < 500; ++run) {
        const TransferFunction f = random_function(random);
        const auto points = points_of(f);
        for (std::size_t i = 1; i < points.size(); ++i) {
            const vec2 a = points[i - 1], b = points[i];
            double before = a.x, y = a.y;
            // Includes the last numbers before the end, where rounding could exceed the end's value.
            std::vector<double> places{std::nextafter(b.x, a.x),
                                       std::nextafter(std::nextafter(b.x, a.x), a.x)};
            for (int n = 0; n < 20; ++n) places.push_back(random.uniform(a.x, b.x));
            std::ranges::sort(places);
            for (const double x : places) {
                if (x <= before || x >= b.x) continue;
                const double next = f(x);
                EXPECT_TRUE(b.y >= a.y ? next >= y && next <= b.y : next <= y && next >= b.y)
                    << x << ": " << next << " after " << y;
                before = x;
                y = next;
            }
        }
    }
}

TEST(TransferFunction, LinesAreLinear) {
    const TransferFunction f = through({{-2, 1}, {0, 5}, {4, -3}});
    EXPECT_DOUBLE_EQ(f(-1), 3);
    EXPECT_DOUBLE_EQ(f(-0.5), 4);
    EXPECT_DOUBLE_EQ(f(1), 3);
    EXPECT_DOUBLE_EQ(f(3.5), -2);
}

TEST(TransferFunction, TwoPointsAtOnePlaceMakeAJump) {
    const TransferFunction f = through({{0, 1}, {2, 1}, {2, 7}, {3, 7}});
    EXPECT_EQ(f(std::nextafter(2.0, 0.0)), 1);
    EXPECT_EQ(f(2), 7);
    EXPECT_EQ(f(std::nextafter(2.0, 3.0)), 7);
    const TransferFunction step = window(5, 5, -1, 1);
    EXPECT_EQ(step(std::nextafter(5.0, 0.0)), -1);
    EXPECT_EQ(step(5), 1);
}

TEST(TransferFunction, AWindowIsARamp) {
    const TransferFunction f = window(100, 300, 0, 2);
    EXPECT_EQ(f(-1e9), 0);
    EXPECT_EQ(f(100), 0);
    EXPECT_EQ(f(200), 1);
    EXPECT_EQ(f(300), 2);
    EXPECT_EQ(f(1e9), 2);
    EXPECT_EQ(window(300, 100, 2, 0)(150), 0.5);
    EXPECT_EQ(constant(3)(-7), 3);
    EXPECT_EQ(TransferFunction{}(4), 0);
}

TEST(TransferFunction, HugeAndMissingNumbersStayFinite) {
    const std::array nasty{no_number, endless, -endless, 1e308, -1e308, 1e-320, 0.0};
    for (const double a : nasty) {
        for (const double b : nasty) {
            for (const double x : nasty) {
                EXPECT_TRUE(std::isfinite(window(a, b, a, b)(x))) << a << ' ' << b << ' ' << x;
                TransferFunction f = window(0, 1, 0, 1);
                draw(f, a, b, 0.1);
                draw(f, a, b, x);
                draw_stroke(f, {a, b}, {x, a}, 0.1);
                draw_stroke(f, {0, b}, {1, a}, x);
                EXPECT_TRUE(std::isfinite(f(x)));
                EXPECT_TRUE(transfer_function(points_of(f))) << a << ' ' << b << ' ' << x;
            }
        }
    }
}

TEST(TransferFunction, PointsThatMakeNoneAreRefused) {
    const auto message = [](const std::vector<vec2>& points) {
        return message_of(transfer_function(points));
    };
    EXPECT_NE(message({}).find("at least one"), std::string::npos);
    EXPECT_NE(message(std::vector<vec2>(33)).find("33 points, more than 32"), std::string::npos);
    EXPECT_NE(message({{0, 0}, {1, no_number}}).find("point 2"), std::string::npos);
    EXPECT_NE(message({{0, 0}, {2, 0}, {1, 0}}).find("point 3"), std::string::npos);
    EXPECT_NE(message({{1e101, 0}}).find("point 1"), std::string::npos);
    EXPECT_EQ(message(std::vector<vec2>(32)), "");
}

TEST(TransferFunction, DrawingChangesOneColumnAlone) {
    TransferFunction f = window(0, 1, 0, 1);
    draw(f, 0.52, 3, 0.1);
    EXPECT_EQ(f(5 * 0.1), 3);
    EXPECT_DOUBLE_EQ(f(0.45), (0.4 + 3) / 2);
    for (int column = -3; column <= 13; ++column) {
        const double x = column * 0.1;
        if (column != 5) {
            EXPECT_DOUBLE_EQ(f(x), std::clamp(x, 0.0, 1.0)) << column;
        }
    }
    EXPECT_DOUBLE_EQ(f(0.85), 0.85);
    EXPECT_EQ(f(-5), 0);
    EXPECT_EQ(f(5), 1);
}

TEST(TransferFunction, AStrokeKeepsWhatTheMouseDrew) {
    // A parabola is drawn from right to left at three speeds of the mouse (the lengths of its steps). It must
    // replace the points that the function has there.
    const auto curve = [](double x) { return 4 * x * (1 - x); };
    for (const double step : {0.003, 0.02, 0.11}) {
        TransferFunction f = through({{0, 9}, {0.31, -9}, {0.31, 9}, {1, -9}});
        for (double x = 1; x > 0; x -= step)
            draw_stroke(f, {x, curve(x)}, {std::max(0.0, x - step), curve(std::max(0.0, x - step))}, 0.05);
        EXPECT_LE(f.count, max_transfer_points);
        for (double x = 0; x <= 1; x += 0.01) EXPECT_NEAR(f(x), curve(x), 0.13) << step;
        EXPECT_EQ(f(-1), 9) << "left of the stroke nothing changes";
    }
}

TEST(TransferFunction, AFullFunctionKeepsItsShape) {
    // A saw-tooth curve of 8 teeth is drawn in steps of 1/200 of its width, which are more points than a
    // function can hold. Its corners are the points that should be kept.
    const auto saw = [](double x) { return std::abs(x * 8 - std::round(x * 8)); };
    TransferFunction f = constant(0);
    for (int i = 0; i <= 200; ++i) {
        draw(f, i / 200.0, saw(i / 200.0), 1 / 200.0);
        ASSERT_LE(f.count, max_transfer_points);
        ASSERT_TRUE(transfer_function(points_of(f)));
    }
    double worst = 0;
    for (int i = 0; i <= 1000; ++i) worst = std::max(worst, std::abs(f(i / 1000.0) - saw(i / 1000.0)));
    EXPECT_LE(worst, 0.03);
}

}  // namespace
}  // namespace thaum::field
