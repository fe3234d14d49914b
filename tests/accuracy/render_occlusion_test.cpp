// Compares form factors (the share of the sky that a block hides from a point) with closed forms and with
// counts of rays.
#include "render/occlusion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace thaum::render {
namespace {

constexpr vec3 up{0, 1, 0};
constexpr double endless = 1e7, close_by = 1e-4;

TEST(FormFactor, ARightAngleTakesExactlyHalf) {
    // A point of the floor close beside an endless wall.
    const Block wall{{-endless, -1, -endless}, {0, endless, endless}};
    EXPECT_NEAR(form_factor(wall, {close_by, 0, 0}, up), 0.5, 1e-9);
    // A point of the wall close above an endless floor.
    const Block floor{{-endless, -1, -endless}, {endless, 0, endless}};
    EXPECT_NEAR(form_factor(floor, {0, close_by, 0}, {1, 0, 0}), 0.5, 1e-9);
}

TEST(FormFactor, TwoWallsLeaveAQuarterInTheirCorner) {
    const Block west{{-endless, 0, -endless}, {0, endless, endless}};
    const Block north{{-endless, 0, -endless}, {endless, endless, 0}};
    const vec3 corner(close_by, 0, close_by);
    EXPECT_NEAR((1 - form_factor(west, corner, up)) * (1 - form_factor(north, corner, up)), 0.25, 1e-8);
}

TEST(FormFactor, ARoofOverTheCornerOfARectangle) {
    // Howell's catalogue of configuration factors, B-3: a small surface parallel to a rectangle, below its
    // corner.
    for (const vec3 size : {vec3(1, 0.2, 1), vec3(3, 0.2, 0.5), vec3(0.1, 0.2, 8)}) {
        const double a = size.x / 2, b = size.z / 2;  // edge lengths divided by the distance of 2 m
        const double ra = std::sqrt(1 + a * a), rb = std::sqrt(1 + b * b);
        const double exact = (a / ra * std::atan(b / ra) + b / rb * std::atan(a / rb)) / (2 * pi);
        // From below only the block's lower face is visible.
        EXPECT_NEAR(form_factor({{0, 2, 0}, vec3(0, 2, 0) + size}, {0, 0, 0}, up), exact, 1e-12);
    }
}

TEST(FormFactor, EqualsTheShareOfRays) {
    const Block block{{0.5, -0.3, -1}, {1.5, 1.2, 0.7}};
    const vec3 point(0, 0.1, 0.2), normal = glm::normalize(vec3(0.3, 0.9, -0.2));
    const vec3 x = glm::normalize(glm::cross(normal, vec3(0, 0, 1))), z = glm::cross(x, normal);
    double before = 1;
    for (const int n : {50, 200, 800}) {
        int met = 0;
        for (int i = 0; i < n; ++i) {
            for (int j = 0; j < n; ++j) {
                // Uniform points in the unit disc, projected up to the hemisphere, follow the cosine law.
                const double r = std::sqrt((i + 0.5) / n), angle = 2 * pi * (j + 0.5) / n;
                const vec3 way =
                    r * std::cos(angle) * x + r * std::sin(angle) * z + std::sqrt(1 - r * r) * normal;
                met += meets(block, point, way);
            }
        }
        const double error = std::abs(met / static_cast<double>(n * n) - form_factor(block, point, normal));
        EXPECT_LT(error, 0.8 / n);
        before = error;
    }
    EXPECT_LT(before, 1e-3);
}

TEST(FormFactor, NothingBelowTheHorizonOrAroundThePointCounts) {
    const Block block{{-1, -3, -1}, {1, -1, 1}};
    EXPECT_EQ(form_factor(block, {0, 0, 0}, up), 0);
    EXPECT_EQ(form_factor(block, {0, -1, 0}, up), 0) << "a block does not shade its own top";
    EXPECT_EQ(form_factor(block, {0, -2, 0}, up), 0) << "inside the block";
    const double whole = form_factor({{-1, 1, -1}, {1, 2, 1}}, {0, 0, 0}, up);
    EXPECT_NEAR(form_factor({{-1, 1, -1}, {0, 2, 1}}, {0, 0, 0}, up), whole / 2, 1e-3);
    EXPECT_NEAR(form_factor({{-1, 1, -1}, {1, 1, 1}}, {0, 0, 0}, up), whole, 1e-12)
        << "a block without height";
    EXPECT_EQ(form_factor({{1, 1, 1}, {1, 1, 1}}, {0, 0, 0}, up), 0) << "a block without size";
    EXPECT_GE(form_factor({{-1, -1, -1}, {0, 1e9, 1}}, {0, 0, 0}, up), 0);
    EXPECT_LE(form_factor({{-1e9, 1e-9, -1e9}, {1e9, 1, 1e9}}, {0, 0, 0}, up), 1);
}

TEST(Meets, ForwardsOnlyAndAlongTheEdgesToo) {
    const Block block{{1, -1, -1}, {2, 1, 1}};
    EXPECT_TRUE(meets(block, {0, 0, 0}, {1, 0, 0}));
    EXPECT_TRUE(meets(block, {0, 0, 0}, {5, 1, 1}));
    EXPECT_FALSE(meets(block, {0, 0, 0}, {-1, 0, 0}));
    EXPECT_FALSE(meets(block, {0, 2, 0}, {1, 0, 0}));
    EXPECT_TRUE(meets(block, {1.5, 0, 0}, {0, 1, 0})) << "from inside the block";
}

}  // namespace
}  // namespace thaum::render
