// Tests the accuracy of carving: compares removed volumes with closed forms, and checks orders of
// convergence, the change over time at a given strength, symmetry and the conservation of mass.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/carving_rig.h"

namespace thaum::field {
namespace {

/// Integral of exp(-c r^2) over a ball of radius 1.
double bell_in_ball(double c) {
    return std::pow(pi / c, 1.5) * std::erf(std::sqrt(c)) - 2 * pi / c * std::exp(-c);
}

/// Integral of 1 - exp(-amount w) over the ball of radius 1. Here w is the weight of a place at the radius r
/// within a tool that fades out as a Gaussian: w = (exp(-4.5 r^2) - rim) / (1 - rim), where rim = exp(-4.5)
/// makes w zero at the radius 1. Each term of the exponential series is a Gaussian with a closed-form
/// integral.
double melted_volume(double amount) {
    const double rim = std::exp(-4.5), k = amount / (1 - rim);
    double sum = 0, factor = 1;
    for (int n = 0; n < 60; ++n) {
        sum += factor * (n == 0 ? 4 * pi / 3 : bell_in_ball(4.5 * n));
        factor *= -k / (n + 1);
    }
    return 4 * pi / 3 - std::exp(k * rim) * sum;
}

/// Largest relative error of the volume that one use of a tool removes from a solid body, over random
/// positions between voxels.
double volume_error(const Tool& tool, double radius, double seconds, double exact) {
    const int n = 2 * static_cast<int>(radius) + 6;
    Random random = random_stream(24, 2);
    double worst = 0;
    for (int i = 0; i < 20; ++i) {
        Voxels body = block({n, n, n}, 1);
        const vec3 off(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5));
        const Edit e = edit(body.view(), tool, {.place = off * body.spacing, .seconds = seconds});
        const double volume = exact * std::pow(radius * body.spacing.x, 3);
        worst = std::max(worst, std::abs(e.removed / volume - 1));
    }
    return worst;
}

TEST(CarvingAccuracy, TheSeriesOfTheMeltedVolumeAgreesWithANumericalIntegral) {
    const double rim = std::exp(-4.5);
    for (const double amount : {0.01, 1.0, 5.0}) {
        double sum = 0;
        constexpr int steps = 20000;
        for (int i = 0; i < steps; ++i) {
            const double r = (i + 0.5) / steps, w = (std::exp(-4.5 * r * r) - rim) / (1 - rim);
            sum += 4 * pi * r * r * (1 - std::exp(-amount * w)) / steps;
        }
        EXPECT_NEAR(melted_volume(amount) / sum, 1, 1e-8) << amount;
    }
}

TEST(CarvingAccuracy, AGaussianTakesTheVolumeOfTheClosedForm) {
    for (const double amount : {0.05, 1.0, 4.0}) {
        const double exact = melted_volume(amount);
        double error[4]{};
        for (int i = 0; i < 4; ++i) {
            const double radius = 3 << i;
            error[i] = volume_error(density_filter(radius, 0, amount), radius, 1, exact);
        }
        EXPECT_LT(error[0], 0.02) << amount;
        EXPECT_LT(error[2], 2e-4) << amount;
        EXPECT_GT(std::log2(error[0] / error[3]) / 3, 2.0) << amount;
    }
}

TEST(CarvingAccuracy, ASphereTakesItsVolumeAndThatOfItsRim) {
    double error[4]{};
    for (int i = 0; i < 4; ++i) {
        const double radius = 3 << i;
        const Tool tool = density_constant(round_extent(ExtentShape::sphere, radius), 0);
        // The tool fades out over a rim from one voxel below its radius to one above. The exact value is the
        // mean of (4/3) pi r^3 over the radii in that rim.
        error[i] = volume_error(tool, radius, 0, 4 * pi / 3 * (1 + 1 / (radius * radius)));
    }
    EXPECT_LT(error[0], 0.01);
    EXPECT_LT(error[2], 5e-4);
    EXPECT_GT(std::log2(error[0] / error[3]) / 3, 1.5);
}

TEST(CarvingAccuracy, ACarvedSurfaceLiesWhereTheSphereIs) {
    const double radius = 12.3;
    Random random = random_stream(24, 8);
    const auto number = [&] { return random.uniform(-1, 1); };
    for (int round = 0; round < 5; ++round) {
        Voxels body = block({36, 36, 36}, 1);
        const vec3 middle = 0.005 * vec3(number(), number(), number());
        edit(body.view(), density_constant(round_extent(ExtentShape::sphere, radius), 0), {.place = middle});
        const Grid grid = body.density_grid();
        for (int i = 0; i < 500; ++i) {
            const vec3 direction = glm::normalize(vec3(number(), number(), number()));
            double low = radius - 2, high = radius + 2;
            for (int step = 0; step < 30; ++step) {
                const double r = 0.5 * (low + high);
                (grid(middle + 0.01 * r * direction).value < 0.5 ? low : high) = r;
            }
            EXPECT_NEAR(low, radius, 0.015);
            const vec3 normal = glm::normalize(grid(middle + 0.01 * low * direction).gradient);
            EXPECT_GT(glm::dot(normal, direction), std::cos(3 * radians_per_degree));
        }
    }
}

TEST(CarvingAccuracy, ATurnedBoxTakesItsVolume) {
    const Tool tool = density_constant({.shape = ExtentShape::box, .half = {4, 5, 6}}, 0);
    Random random = random_stream(24, 3);
    for (int i = 0; i < 20; ++i) {
        Voxels body = block({30, 30, 30}, 1);
        const vec3 axis = glm::normalize(vec3(random.uniform(-1, 1), random.uniform(-1, 1), 0.7));
        const Edit e =
            edit(body.view(), tool, {.turn = glm::mat3_cast(rotation(axis, random.uniform(0, 6)))});
        EXPECT_NEAR(e.removed / (8 * 4 * 5 * 6 * 1e-6), 1, 0.01) << i;
    }
}

TEST(CarvingAccuracy, TwoHalfStepsAreOneStep) {
    for (const double constant : {0.0, 0.63, 1.0}) {
        Voxels once = random_block({20, 20, 20}, 1), twice = once, many = once;
        const Tool tool = density_filter(7, constant);
        const vec3 place = place_of(once, {9.3, 10.1, 8.7});
        edit(once.view(), tool, {.place = place, .seconds = 0.1});
        for (int i = 0; i < 2; ++i) edit(twice.view(), tool, {.place = place, .seconds = 0.05});
        for (int i = 0; i < 100; ++i) edit(many.view(), tool, {.place = place, .seconds = 0.001});
        for (std::size_t i = 0; i < once.density.size(); ++i) {
            EXPECT_NEAR(twice.density[i], once.density[i], 2.5e-7) << i;
            EXPECT_NEAR(many.density[i], once.density[i], 5e-6) << i;
        }
    }
}

TEST(CarvingAccuracy, AMixedColourDependsOnTheTimeNotOnTheNumberOfEdits) {
    const auto mean_red = [](int edits) {
        Voxels body = block({16, 16, 16}, 1);
        std::ranges::fill(body.colour, Rgb8{0, 0, 0});
        // The tool's weight is almost 1 in the whole body, so the exact result is known.
        Tool tool = density_filter(30, 0, 1);
        tool.operations[0].changes = {.colour = true};
        tool.operations[0].colour = {200, 0, 0};
        for (int i = 0; i < edits; ++i) {
            edit(body.view(), tool, {.seconds = 0.5 / edits, .seed = static_cast<std::uint64_t>(i)});
        }
        double sum = 0;
        for (const Rgb8 c : body.colour) sum += c.r;
        return sum / static_cast<double>(body.colour.size());
    };
    const double once = mean_red(1);
    EXPECT_GT(once, 60);
    EXPECT_NEAR(mean_red(2), once, 0.5);
    // Each edit changes the colour by less than half a step of its 8 bits. Rounding must not lose these
    // changes.
    EXPECT_NEAR(mean_red(500), once, 0.5);
}

TEST(CarvingAccuracy, MirroredDabsGiveMirroredBodies) {
    for (const auto shape : {ExtentShape::gaussian, ExtentShape::sphere, ExtentShape::box}) {
        Voxels body = block({17, 18, 19}, 1), mirrored = body;
        Tool tool = density_filter(5, 0);
        tool.operations[0].extent.shape = shape;
        const vec3 voxel(6.25, 7.5, 9.125);
        edit(body.view(), tool, {.place = place_of(body, voxel), .seconds = 0.05});
        edit(mirrored.view(), tool, {.place = place_of(body, vec3(16, 17, 18) - voxel), .seconds = 0.05});
        const std::size_t last = body.density.size() - 1;
        for (std::size_t i = 0; i <= last; ++i)
            ASSERT_NEAR(body.density[i], mirrored.density[last - i], 1e-6);
    }
}

TEST(CarvingAccuracy, ADabOnAVoxelIsSymmetricInEveryBit) {
    Voxels body = block({15, 15, 15}, 1);
    edit(body.view(), density_filter(6, 0), {.seconds = 0.05});
    const auto at = [&](int i, int j, int k) { return body.density[body.view().at(7 + i, 7 + j, 7 + k)]; };
    for (int i = -7; i <= 7; ++i) {
        for (int j = -7; j <= 7; ++j) {
            for (int k = -7; k <= 7; ++k) {
                EXPECT_EQ(at(i, j, k), at(-i, -j, -k));
                EXPECT_EQ(at(i, j, k), at(i, -j, k));
                EXPECT_NEAR(at(i, j, k), at(j, k, i), 1e-7);
            }
        }
    }
}

TEST(CarvingAccuracy, MassTakenAndBroughtIsTheChangeOfTheBody) {
    Voxels body = random_block({24, 20, 28}, 3);
    Random random = random_stream(24, 4);
    for (int i = 0; i < 200; ++i) {
        const double before = mass_of(body);
        const Tool tool = density_filter(random.uniform(0.5, 9), random.uniform());
        const vec3 place =
            place_of(body, 30.0 * vec3(random.uniform(), random.uniform(), random.uniform()) - 2.0);
        const Edit e = edit(body.view(), tool, {.place = place, .seconds = 0.03});
        EXPECT_GE(e.removed, 0);
        EXPECT_GE(e.added, 0);
        EXPECT_NEAR(mass_of(body) - before, e.added - e.removed, 1e-13);
    }
}

TEST(CarvingAccuracy, ARadiusInMetresIsASphereAlsoWithUnequalSpacings) {
    Voxels body = make_voxels({60, 40, 24}, {0.002, 0.003, 0.005});
    std::ranges::fill(body.density, 1.0F);
    Extent extent = round_extent(ExtentShape::sphere, 0.05);
    extent.in_metres = true;
    const Edit e = edit(body.view(), density_constant(extent, 0), {});
    // The tool fades out beyond its radius, which adds 1 % to the removed volume.
    EXPECT_NEAR(e.removed / (4 * pi / 3 * 0.05 * 0.05 * 0.05), 1.01, 0.002);
    extent.in_metres = false;
    extent.half = vec3(10);
    std::ranges::fill(body.density, 1.0F);
    const Edit voxels = edit(body.view(), density_constant(extent, 0), {});
    EXPECT_NEAR(voxels.removed / (4 * pi / 3 * 0.02 * 0.03 * 0.05), 1.01, 0.002);
}

TEST(CarvingAccuracy, DensitiesOfAScanKeepTheirUnit) {
    Voxels body = block({16, 16, 16}, 1000);
    body.empty = -1000;
    body.full = 3000;
    const vec3 place = place_of(body, {8, 8, 8});
    edit(body.view(), density_filter(5, 0, 1), {.place = place, .seconds = std::log(2.0)});
    // Expected density: half-way from 1000 to -1000.
    EXPECT_NEAR(body.density[body.view().at(8, 8, 8)], 0, 1e-3);
    edit(body.view(), density_constant(round_extent(ExtentShape::sphere, 3), 0.5), {.place = place});
    EXPECT_EQ(body.density[body.view().at(8, 8, 8)], 1000);
    EXPECT_EQ(body.density[0], 1000);
}

}  // namespace
}  // namespace thaum::field
