// Tests how volumes feel: forces that depend on opacity, shells, walls, materials, and scanned surfaces.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/random.h"
#include "core/units.h"
#include "field/analytic.h"
#include "haptics/volume/smooth_grid.h"
#include "haptics/volume/volume_feel.h"
#include "tests/scenes/scanned_volumes.h"

namespace thaum::haptics {
namespace {

using bench::scanned;
using bench::ScannedVolume;
using bench::TouchedModes;
using field::field_of;
using field::Scalar;

/// A simulated tip (the point that the hand moves) with the forces of a volume of densities, such as a scan.
struct FeltVolume {
    VolumeFeel feel{};
    TouchedModes hand{};
    VolumeFelt felt{};

    vec3 move(vec3 to) {
        PrimitiveSet set;
        felt = add_volume_feel(feel, hand.input(), set);
        EXPECT_EQ(set.items().size(), primitives_of(feel));
        return hand.settle(set, to);
    }
    /// Force after the tip has rested at a place for some time.
    vec3 rest(vec3 place) {
        for (int tick = 0; tick < 3; ++tick) move(place);
        return move(place);
    }
};

/// Density grows by 100 per cm below a plane and is 0 above.
const auto ramp = [](vec3 p) { return Scalar{std::max(0.0, -1e4 * p.y), {0, p.y < 0 ? -1e4 : 0, 0}}; };

// ---- forces of a shell, and by opacity --------------------------------------------------------------------

TEST(VolumeFeel, AShellsForceIsExactlyLinearInTheDensity) {
    FeltVolume v;
    v.feel.density = field_of<Scalar>(ramp);
    v.feel.shell = {.low = 20, .high = 80, .stiffness = 3, .retarding = 2, .retarding_always = 0.5};
    v.hand.start({0, 0.001, 0});
    for (const double density : {0.0, 10.0, 20.0, 35.0, 50.0, 65.0, 80.0, 81.0, 200.0}) {
        const double share = density > 20 && density <= 80 ? (density - 20) / 60 : 0;
        const vec3 force = v.rest({0, -density / 1e4, 0});
        EXPECT_LE(glm::distance(force, vec3(0, 3 * share, 0)), 1e-9) << density;
        EXPECT_NEAR(v.felt.viscosity, share > 0 ? 2 * share + 0.5 : 0, 1e-12) << density;
    }
}

TEST(VolumeFeel, StiffnessAndViscosityFollowTheOpacity) {
    FeltVolume v;
    v.feel.density = field_of<Scalar>(ramp);
    v.feel.opacity = {.density = field::window(10, 60, 0, 1),
                      // The density's gradient is 1e4, the middle of this window, so it halves the stiffness.
                      .gradient = field::window(0, 2e4, 0, 1),
                      .stiffness = 2,
                      .retarding = 4,
                      .retarding_always = 0.25};
    v.hand.start({0, 0.001, 0});
    for (const double density : {0.0, 10.0, 35.0, 60.0, 90.0}) {
        const double opacity = 0.5 * std::clamp((density - 10) / 50, 0.0, 1.0) * (density > 0 ? 1 : 0);
        EXPECT_LE(glm::distance(v.rest({0, -density / 1e4, 0}), vec3(0, 2 * opacity, 0)), 1e-9);
        EXPECT_NEAR(v.felt.opacity, opacity, 1e-12);
        EXPECT_NEAR(v.felt.viscosity, 4 * opacity + 0.25, 1e-12);
    }
}

TEST(VolumeFeel, TheInvertedMappingDrawsTheTipIntoAThinStructure) {
    // A fibre along x, whose density falls with the distance r from its axis: 100 exp(-r^2 w^2).
    constexpr double width = 0.002;
    const auto fibre = [](vec3 p) {
        const double d = 100 * det::exp(-(p.y * p.y + p.z * p.z) / (width * width));
        return Scalar{d, -2 * d / (width * width) * vec3(0, p.y, p.z)};
    };
    FeltVolume v;
    v.feel.density = field_of<Scalar>(fibre);
    v.feel.opacity = {.density = field::window(5, 100, 0, 1),
                      .gradient = field::constant(1),
                      .stiffness = 0.5,
                      .attracts = true};
    const vec3 start(0, 0.0015, -0.001);
    v.hand.start(start);
    const vec3 pull = v.rest(start);
    EXPECT_GT(glm::length(pull), 0.1);
    EXPECT_LE(glm::distance(glm::normalize(pull), -glm::normalize(start)), 1e-9);
    // A free hand that follows the pull ends on the fibre. If `attracts` were false, the force would push the
    // hand away from the fibre.
    vec3 tip = start;
    for (int tick = 0; tick < 4000; ++tick) tip += 1e-5 * v.move(tip);
    EXPECT_LE(glm::length(tip), 3e-4);  // tolerance (m): the pull fades out on the fibre
}

// ---- walls and materials in volumes -----------------------------------------------------------------------

VolumeFeel skin_over_bone() {
    VolumeFeel feel;
    feel.density = field_of<Scalar>(ramp);
    feel.walls = {DensityWall{.density = 30, .strength = 0.8, .reach = 0.0008},
                  DensityWall{.density = 100, .strength = 50, .reach = 0.0008}};
    feel.wall_count = 2;
    return feel;
}

TEST(VolumeFeel, AnInvisibleSkinIsFeltUntilAStrongPushGetsThroughToTheBone) {
    FeltVolume v{skin_over_bone(), {}, {}};
    v.feel.opacity = {.density = field::constant(0), .stiffness = 5};  // an opacity of zero everywhere
    v.hand.start({0, 0.002, 0});
    double at_skin = 0, between = 1;
    for (int tick = 0; tick <= 2000; ++tick) {
        const double y = 0.002 - 1e-5 * tick;
        const double force = v.move({0, y, 0}).y;
        if (y > -0.0069) at_skin = std::max(at_skin, force);
        if (y < -0.008 && y > -0.0095) between = std::min(between, force);
    }
    EXPECT_NEAR(at_skin, 0.8, 1e-9);
    EXPECT_LE(between, 1e-12) << "between skin and bone the tip is free";
    EXPECT_NEAR(v.hand.proxy.y, -0.01, 1e-9) << "the bone holds";
    EXPECT_EQ(v.felt.touched, 2U);
}

TEST(VolumeFeel, TheMaterialIndexScalesStiffnessAndViscosity) {
    struct Halves {
        std::uint8_t material(vec3 p) const { return p.x < 0 ? 3 : 7; }
    };
    const Halves halves;
    MaterialTable table{};
    table[3] = {.stiffness = 0.5, .viscosity = 2};
    table[7] = {.stiffness = 0, .viscosity = 0};
    FeltVolume v;
    v.feel.density = field_of<Scalar>(ramp);
    v.feel.material = material_field_of(halves);
    v.feel.materials = &table;
    v.feel.shell = {.low = 0, .high = 100, .stiffness = 2, .retarding = 1};
    v.feel.walls[0] = {.density = 50, .strength = 4, .reach = 0.001};
    v.feel.wall_count = 1;
    v.hand.start({-0.01, 0.001, 0});
    EXPECT_NEAR(v.rest({-0.01, -0.004, 0}).y, 2 * 0.4 * 0.5, 1e-9);
    EXPECT_NEAR(v.felt.viscosity, 2 * 0.4, 1e-12);
    EXPECT_EQ(v.felt.material, 3U);
    double largest = 0;
    v.feel.shell = {};
    for (int tick = 0; tick < 2000; ++tick)
        largest = std::max(largest, v.move({-0.01, -0.004 - 1e-5 * tick, 0}).y);
    EXPECT_NEAR(largest, 2, 1e-9) << "half the strength of the wall";
    v.hand.start({0.01, 0.001, 0});
    EXPECT_LE(glm::length(v.rest({0.01, -0.008, 0})), 1e-12);
}

TEST(VolumeFeel, AmbientForcesAreFeltEverywhere) {
    FeltVolume v;
    v.feel.density = field_of<Scalar>(ramp);
    v.feel.gravity = {0, -0.3, 0};
    v.feel.guides[0] = {.place = {0.02, 0, 0}, .normal = {1, 0, 0}, .strength = 0.6};
    v.feel.guide_count = 1;
    v.hand.start({0.02, 0.01, 0});
    EXPECT_LE(glm::distance(v.rest({0.021, 0.01, 0}), vec3(-0.3, -0.3, 0)), 1e-9);
    EXPECT_LE(glm::distance(v.rest({0.03, 0.01, 0}), vec3(-0.6, -0.3, 0)), 1e-9);
    EXPECT_LE(glm::distance(v.rest({0.019, 0.01, 0}), vec3(0.3, -0.3, 0)), 1e-9);
}

TEST(VolumeFeel, FaultyNumbersGiveNoForceAndTooFewPlacesNone) {
    const auto broken = [](vec3) { return Scalar{std::numeric_limits<double>::quiet_NaN(), vec3(1)}; };
    FeltVolume v{skin_over_bone(), {}, {}};
    v.feel.density = field_of<Scalar>(broken);
    v.feel.opacity = {.density = field::constant(1), .gradient = field::constant(1), .stiffness = 5};
    EXPECT_EQ(v.rest({0, -0.02, 0}), vec3(0));
    EXPECT_EQ(v.felt.viscosity, 0);
    PrimitiveSet full;
    for (std::size_t i = 0; i + 5 < primitive_capacity; ++i) full.add({.kind = PrimitiveKind::point});
    const auto before = full.items().size();
    add_volume_feel(v.feel, {}, full);
    EXPECT_EQ(full.items().size(), before);
}

// ---- smoothing of samples ---------------------------------------------------------------------------------

TEST(SmoothGrid, ReadsALinearFieldExactlyAndOthersWithSecondOrder) {
    const auto wave = [](vec3 p) { return det::sin(40 * p.x) * det::cos(30 * p.y) + det::sin(20 * p.z); };
    const auto filled = [](int n, auto formula) {
        ScannedVolume v{n, 0.1 / n, {}};
        const vec3 first = v.origin();
        for (int k = 0; k < n; ++k) {
            for (int j = 0; j < n; ++j) {
                for (int i = 0; i < n; ++i)
                    v.samples.push_back(static_cast<float>(formula(first + v.spacing * vec3(i, j, k))));
            }
        }
        return v;
    };
    Random random{5};
    const auto flat = filled(24, [](vec3 p) { return 3 * p.x - 2 * p.y + p.z; });
    std::array<double, 3> errors{};
    const std::array volumes{filled(24, wave), filled(48, wave), filled(96, wave)};
    for (int i = 0; i < 500; ++i) {
        const vec3 at(random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03));
        EXPECT_NEAR(flat.smooth()(at).value, 3 * at.x - 2 * at.y + at.z, 1e-8);
        EXPECT_LE(glm::distance(flat.smooth()(at).gradient, vec3(3, -2, 1)), 2e-6);
        for (std::size_t n = 0; n < volumes.size(); ++n)
            errors[n] = std::max(errors[n], std::abs(volumes[n].smooth()(at).value - wave(at)));
    }
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.2);
    EXPECT_NEAR(std::log2(errors[1] / errors[2]), 2, 0.2);
}

TEST(SmoothGrid, IntegersReadAsTheFloatsThatTheyEqual) {
    const ScannedVolume ball = scanned(Ball{{}, 0.02}, 24, 0.0025);
    const std::vector<std::uint8_t> bytes(ball.samples.begin(), ball.samples.end());
    std::vector<std::int16_t> shorts;
    for (const float sample : ball.samples) shorts.push_back(static_cast<std::int16_t>(40 * sample - 3000));
    const std::vector<float> as_floats(shorts.begin(), shorts.end());
    SmoothGrid from_bytes = ball.smooth(), from_shorts = ball.smooth(), from_floats = ball.smooth();
    from_bytes.grid.first = bytes.data();
    from_shorts.grid.first = shorts.data();
    from_floats.grid.first = as_floats.data();
    Random random{9};
    for (int i = 0; i < 2000; ++i) {
        const vec3 at(random.uniform(-0.04, 0.04), random.uniform(-0.04, 0.04), random.uniform(-0.04, 0.04));
        EXPECT_EQ(from_bytes(at).value, ball.smooth()(at).value);
        EXPECT_EQ(from_bytes(at).gradient, ball.smooth()(at).gradient);
        EXPECT_EQ(from_shorts(at).value, from_floats(at).value);
        EXPECT_EQ(from_shorts(at).gradient, from_floats(at).gradient);
    }
}

TEST(SmoothGrid, EqualSamplesPushNobody) {
    for (const float all : {0.1F, 255.0F, -1000.0F}) {
        ScannedVolume even{16, 0.005, {}};
        even.samples.assign(16 * 16 * 16, all);
        const SmoothGrid smooth = even.smooth();
        ModeUse use{find_mode("gradient"), any_field(field::field_of<Scalar>(smooth)), {}};
        use.settings.strength = field::constant(5);
        TouchedModes hand{{use}};
        hand.start(vec3(0));
        Random random{7};
        for (int i = 0; i < 300; ++i) {
            const double x = random.uniform(-0.05, 0.05), y = random.uniform(-0.05, 0.05);
            EXPECT_EQ(smooth({x, y, 0.3 * x}).value, static_cast<double>(all));
            EXPECT_EQ(smooth({x, y, 0.3 * x}).gradient, vec3(0));
            EXPECT_LE(glm::length(hand.move(0.0001 * vec3(i, -i, 1))), 1e-12);
        }
    }
}

TEST(SmoothGrid, StaysFlatOutsideAndReadsAnyStride) {
    const ScannedVolume ball = scanned(Ball{{}, 0.02}, 24, 0.0025);
    SmoothGrid across = ball.smooth();
    std::vector<float> turned(ball.samples.size());
    for (std::size_t i = 0; i < 24; ++i) {
        for (std::size_t j = 0; j < 24; ++j) {
            for (std::size_t k = 0; k < 24; ++k)
                turned[(i * 24 + j) * 24 + k] = ball.samples[(k * 24 + j) * 24 + i];
        }
    }
    across.grid.first = turned.data();
    across.grid.stride = {24 * 24, 24, 1};
    for (int i = 0; i < 300; ++i) {
        const vec3 at = 1e-4 * (3.0 * i) * bench::even_direction(i, 300);
        EXPECT_EQ(ball.smooth()(at).value, across(at).value);
        EXPECT_EQ(ball.smooth()(at).gradient, across(at).gradient);
    }
    EXPECT_EQ(ball.smooth()(vec3(std::nan(""))).value, 0);
    EXPECT_EQ(SmoothGrid{}(vec3(0)).value, 0);
    EXPECT_EQ(ball.smooth()({1, 0, 0}).value, ball.smooth()({0.5, 0, 0}).value);
}

// ---- scanned surfaces -------------------------------------------------------------------------------------

constexpr double spacing = 0.0008, radius = 40 * spacing, depth = 1.0 / 300;

ModeUse scan_wall(const SmoothGrid& smooth) {
    ModeUse use{find_mode("isosurface"), any_field(field_of<Scalar>(smooth)), {}};
    use.settings.strength = field::constant(20);
    use.settings.level = 127.5;
    use.settings.reach = 1.5 * spacing;
    return use;
}

TEST(ScannedSurfaces, TheForceOnASphereIsWithinThreeDegreesOfTheNormal) {
    const ScannedVolume sphere = scanned(Ball{{}, radius}, 128, spacing);
    const SmoothGrid smooth = sphere.smooth();
    std::vector<double> errors;
    for (int i = 0; i < 2000; ++i) {
        const vec3 out = bench::even_direction(i, 2000);
        TouchedModes hand{{scan_wall(smooth)}};
        hand.start((radius + spacing) * out);
        vec3 force(0);
        for (int tick = 0; tick < 20; ++tick)
            force = hand.move(std::max(radius - depth, radius + spacing - 4e-4 * tick) * out);
        ASSERT_GT(glm::length(force), 0.9);
        errors.push_back(glm::length(glm::cross(glm::normalize(force), out)) / radians_per_degree);
    }
    std::ranges::sort(errors);
    EXPECT_LE(errors.back(), 0.8);              // largest error (degrees); 3 are required
    EXPECT_LE(errors[errors.size() / 2], 0.1);  // median error (degrees); 0.5 are required
}

/// Root mean square deviation of the force from its mean over the surrounding 64 ms, as a share of the mean
/// force.
double noise_of(TouchedModes hand, const std::function<vec3(int)>& way, int ticks) {
    std::vector<vec3> forces;
    hand.start(way(0));
    for (int tick = 0; tick < ticks; ++tick) forces.push_back(hand.move(way(tick)));
    double square = 0, sum = 0;
    for (int t = 132; t + 32 < ticks; ++t) {
        vec3 mean(0);
        for (int i = t - 32; i <= t + 32; ++i) mean += forces[static_cast<std::size_t>(i)] / 65.0;
        const vec3 here = forces[static_cast<std::size_t>(t)];
        square += glm::dot(here - mean, here - mean);
        sum += glm::length(here);
    }
    const double count = ticks - 164;
    return std::sqrt(square / count) / (sum / count);
}

TEST(ScannedSurfaces, ATipThatSlidesOnASphereFeelsNoChatter) {
    const ScannedVolume sphere = scanned(Ball{{}, radius}, 128, spacing);
    const SmoothGrid smooth = sphere.smooth();
    const auto way = [](int tick) {
        const double turn = 0.1 / radius * tick_seconds * tick, in = depth * std::min(1.0, tick / 60.0);
        return (radius - in) *
               glm::normalize(vec3(det::cos(turn), det::sin(turn), 0.4 * det::sin(0.7 * turn)));
    };
    EXPECT_LE(noise_of({{scan_wall(smooth)}}, way, 1500), 0.01);
}

TEST(ScannedSurfaces, ATipThatSlidesAlongAHardEdgeFeelsNoVibration) {
    const bench::TurnedBlock block{{.half = vec3(0.024)},
                                   mat3(glm::mat3_cast(rotation(glm::normalize(vec3(1, 2, 0.5)), 0.6)))};
    const ScannedVolume scan = scanned(block, 128, spacing);
    const SmoothGrid smooth = scan.smooth();
    const auto along = [&](double from_bisector, int tick) {
        const double in = 0.024 - depth * std::min(1.0, tick / 60.0);
        return block.turn * vec3(in - from_bisector, in, 1e-4 * tick - 0.014);
    };
    for (const double off : {0.0003, 0.01})  // offsets (m): just beside the bisecting plane, and on the face
        EXPECT_LE(noise_of(
                      {{scan_wall(smooth)}}, [&](int tick) { return along(off, tick); }, 280),
                  0.01)
            << off;
}

}  // namespace
}  // namespace thaum::haptics
