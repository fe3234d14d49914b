// Compares streamlines with closed forms (circles, the helix of a Beltrami flow, hyperbolas), and checks the
// order of convergence.
#include "field/streamline.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace thaum::field {
namespace {

/// A flow that turns about y at 2 rad/s and rises.
struct Turning {
    double rise = 0;
    Vector operator()(vec3 p) const {
        return {{2 * p.z, rise, -2 * p.x}, {vec3(0, 0, 2), vec3(0), vec3(-2, 0, 0)}};
    }
};

/// The flow of Arnold, Beltrami and Childress, whose curl is the flow itself.
struct Beltrami {
    double a = 1, b = 0.7, c = 0.4;
    Vector operator()(vec3 p) const {
        return {
            {a * std::sin(p.z) + c * std::cos(p.y), b * std::sin(p.x) + a * std::cos(p.z),
             c * std::sin(p.y) + b * std::cos(p.x)},
            {vec3(0, -c * std::sin(p.y), a * std::cos(p.z)), vec3(b * std::cos(p.x), 0, -a * std::sin(p.z)),
             vec3(-b * std::sin(p.x), c * std::cos(p.y), 0)}};
    }
};

/// A flow towards the plane x = 0 and away along y.
struct Stagnation {
    Vector operator()(vec3 p) const { return {{-p.x, p.y, 0}, {vec3(-1, 0, 0), vec3(0, 1, 0), vec3(0)}}; }
};

std::vector<StreamPoint> traced(const auto& flow, vec3 seed, const StreamlineSettings& settings,
                                StreamEnd end = StreamEnd::length) {
    std::vector<StreamPoint> out;
    EXPECT_EQ(trace(field_of<Vector>(flow), seed, settings, out), end);
    return out;
}

TEST(Streamline, ClosesItsCircleWithOrderFour) {
    const Turning flow;
    const double radius = 0.3, length = 2 * pi * radius;
    std::array<double, 3> error{};
    for (std::size_t i = 0; i < error.size(); ++i) {
        const double h = length / (80 << i);
        const auto line =
            traced(flow, {radius, 0.1, 0}, {.length = length, .tolerance = 0, .longest_step = h});
        error.at(i) = glm::distance(line.back().place, vec3(radius, 0.1, 0));
        EXPECT_NEAR(line.back().way, length, 1e-12);
    }
    EXPECT_LT(error[0], 1e-6 * radius);
    EXPECT_NEAR(std::log2(error[0] / error[1]), 4, 0.2);
    EXPECT_NEAR(std::log2(error[1] / error[2]), 4, 0.2);
}

TEST(Streamline, OfABeltramiFlowConvergesWithOrderFour) {
    const Beltrami flow;
    const vec3 seed(0.3, -1.1, 0.8);
    const auto exact = traced(flow, seed, {.length = 4, .tolerance = 0, .longest_step = 4.0 / 4000});
    double before = 0;
    for (const int steps : {20, 40, 80}) {
        const auto line = traced(flow, seed, {.length = 4, .tolerance = 0, .longest_step = 4.0 / steps});
        const double error = glm::distance(line.back().place, exact.back().place);
        if (before > 0) {
            EXPECT_NEAR(std::log2(before / error), 4, 0.4) << steps;
        }
        before = error;
    }
    EXPECT_LT(before, 1e-5);
}

TEST(Streamline, KeepsItsToleranceWithFewSteps) {
    const Beltrami flow;
    const vec3 seed(0.3, -1.1, 0.8);
    const auto exact = traced(flow, seed, {.length = 4, .tolerance = 0, .longest_step = 4.0 / 4000});
    std::size_t points = 0;
    for (const double tolerance : {1e-5, 1e-7, 1e-9}) {
        const auto line = traced(
            flow, seed, {.length = 4, .tolerance = tolerance, .longest_step = 4, .shortest_step = 1e-6});
        // The tolerance grows along the line: errors of steps add up, and neighbouring lines diverge.
        EXPECT_LT(glm::distance(line.back().place, exact.back().place),
                  20 * tolerance * static_cast<double>(line.size()));
        EXPECT_GT(line.size(), points) << "a smaller tolerance takes more steps";
        EXPECT_LT(line.size(), 400U);
        points = line.size();
    }
}

TEST(Streamline, FollowsItsHyperbolaThroughFastAndSlowParts) {
    const auto line =
        traced(Stagnation{}, {1, 1e-3, 0.5}, {.length = 5, .tolerance = 1e-9, .longest_step = 0.5});
    for (const auto& point : line) {
        EXPECT_NEAR(point.place.x * point.place.y, 1e-3, 1e-7);
        EXPECT_EQ(point.place.z, 0.5);
        EXPECT_NEAR(point.speed, std::hypot(point.place.x, point.place.y), 1e-12);
    }
    EXPECT_GT(line.back().place.y, 3);
}

TEST(Streamline, RunsBothWays) {
    const Beltrami flow;
    const vec3 seed(0.3, -1.1, 0.8);
    const StreamlineSettings ahead{.length = 2, .tolerance = 1e-10};
    auto back = ahead;
    back.upstream = true;
    const auto there = traced(flow, seed, ahead);
    const auto again = traced(flow, there.back().place, back);
    EXPECT_LT(glm::distance(again.back().place, seed), 1e-7);
    EXPECT_NEAR(glm::dot(again.back().along, there.front().along), -1, 1e-9);
}

TEST(Streamline, TurnsAcrossWithTheMatter) {
    // On the axis of a turning and rising flow, a ribbon turns by 2 rad/s while it rises by 0.5 m/s.
    const Turning flow{.rise = 0.5};
    const auto line = traced(flow, vec3(0), {.length = 0.25, .tolerance = 1e-8});
    const auto &first = line.front(), &last = line.back();
    EXPECT_NEAR(last.place.y, 0.25, 1e-12);
    const vec3 expected = rotation({0, 1, 0}, 2 * 0.25 / 0.5) * first.across;
    EXPECT_LT(glm::distance(last.across, expected), 1e-9);
    for (const auto& point : traced(Beltrami{}, {0.3, -1.1, 0.8}, {.length = 3})) {
        EXPECT_NEAR(glm::dot(point.across, point.along), 0, 1e-12);
        EXPECT_NEAR(glm::length(point.across), 1, 1e-12);
    }
}

TEST(Streamline, EndsWhereTheFieldDoes) {
    const auto still = [](vec3) { return Vector{}; };
    EXPECT_TRUE(traced(still, vec3(0), {}, StreamEnd::still).empty());
    const auto nan = [](vec3 p) {
        return Vector{vec3(p.x < 0.5 ? 1.0 : std::numeric_limits<double>::quiet_NaN(), 0, 0), {}};
    };
    const auto line = traced(nan, vec3(0), {}, StreamEnd::still);
    EXPECT_NEAR(line.back().place.x, 0.5, 1e-3);
    const auto away = [](vec3) { return Vector{vec3(1, 0, 0), {}}; };
    const auto cut = traced(away, vec3(0), {.high = vec3(0.3)}, StreamEnd::outside);
    EXPECT_LE(cut.back().place.x, 0.3);
    EXPECT_GT(cut.back().place.x, 0.27);
    EXPECT_TRUE(traced(away, vec3(1), {.high = vec3(0.3)}, StreamEnd::outside).empty());
    EXPECT_EQ(traced(away, vec3(0), {.max_points = 7}, StreamEnd::points).size(), 7U);
    EXPECT_TRUE(
        traced(away, vec3(std::numeric_limits<double>::infinity()), {.high = vec3(9)}, StreamEnd::outside)
            .empty());
}

}  // namespace
}  // namespace thaum::field
