// Surfaces of sampled bodies: a hand feels what a picture shows of them
// (haptics/volume/detail/body_search.h).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/random.h"
#include "core/units.h"
#include "field/block_averages.h"
#include "haptics/volume/level_contact.h"
#include "haptics/volume/volume_feel.h"
#include "tests/scenes/scanned_volumes.h"

namespace thaum::haptics {
namespace {

using bench::TouchedModes;
using field::field_of;
using field::Scalar;

constexpr double stiffness = 1000, level = 0.5, fine = 0.001;

/// Samples around the origin, with the averages from which their gradients are computed.
struct Body {
    std::array<int, 3> count{};
    vec3 spacing{fine};
    std::vector<float> samples{};
    field::BlockAverages averages{};

    template <class Sample>
    Body(std::array<int, 3> n, vec3 apart, Sample sample) : count(n), spacing(apart) {
        for (int k = 0; k < n[2]; ++k) {
            for (int j = 0; j < n[1]; ++j) {
                for (int i = 0; i < n[0]; ++i)
                    samples.push_back(static_cast<float>(sample(spacing * vec3(i, j, k) - half())));
            }
        }
        averages = field::make_block_averages(grid());
    }
    vec3 half() const { return 0.5 * spacing * vec3(count[0] - 1, count[1] - 1, count[2] - 1); }
    field::Grid grid() const {
        const std::ptrdiff_t row = count[0];
        return {samples.data(), count, {1, row, row * count[1]}, -half(), spacing, field::Kernel::linear};
    }
    SmoothGrid felt() const { return {grid(), averages.grid(grid()), {0, 1}, averages.coarse_steps}; }
    /// Whether the surface's shader draws the point as solid.
    bool is_drawn(vec3 p) const {
        const vec3 h = half();
        return std::abs(p.x) <= h.x && std::abs(p.y) <= h.y && std::abs(p.z) <= h.z &&
               grid().value(p) >= level;
    }
};

auto ball_at(vec3 middle, double radius, double edge) {
    return [=](vec3 p) { return std::clamp(0.5 + (radius - glm::distance(p, middle)) / edge, 0.0, 1.0); };
}

TouchedModes hand_on(const SmoothGrid& felt) {
    ModeUse use{find_mode("isosurface"), any_field(field_of<Scalar>(felt)), {}};
    use.settings.strength = field::constant(50);
    use.settings.level = level;
    use.settings.reach = 2 * fine;
    return {{use}, stiffness};
}

/// Moves a hand at constant speed and returns the force after a rest at the end.
vec3 pushed(TouchedModes& hand, vec3 from, vec3 to, int ticks, double* most = nullptr) {
    hand.start(from);
    vec3 force(0);
    for (int t = 1; t <= ticks + 5; ++t) {
        force = hand.move(glm::mix(from, to, std::min(1.0, static_cast<double>(t) / ticks)));
        if (most != nullptr) *most = std::max(*most, glm::length(force));
    }
    return force;
}

TEST(DrawnBody, ACutFaceIsAWallWithThePlanesNormal) {
    const Body full({16, 12, 20}, vec3(fine), [](vec3 p) { return 4 + 300 * p.x + 100 * p.y; });
    const SmoothGrid felt = full.felt();
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            vec3 out(0), foot(0.0013, -0.0021, 0.0017);
            out[axis] = side;
            foot[axis] = side * full.half()[axis];
            auto hand = hand_on(felt);
            const vec3 force = pushed(hand, foot + 0.005 * out, foot - 0.001 * out, 100);
            EXPECT_LE(glm::distance(force, stiffness * 0.001 * out), 1e-6);
            double beside = 0;
            vec3 across(0);
            across[(axis + 1) % 3] = 0.02;
            pushed(hand, foot + across + 0.005 * out, foot + across - 0.005 * out, 100, &beside);
            EXPECT_LE(beside, 1e-12) << "beside the box";
        }
    }
}

TEST(DrawnBody, ItIsFeltWhereItIsDrawnAndNowhereElse) {
    // A ball that the box cuts off, a mask of samples 0 or 1, slices three times as thick as the samples are
    // wide, and a body that fills its whole box.
    const std::array bodies{
        Body({24, 24, 24}, vec3(fine), ball_at({0.006, 0.003, 0}, 0.009, fine)),
        Body({24, 24, 24}, vec3(fine), ball_at({0.001, 0.0004, 0.0007}, 0.008, 1e-9)),
        Body({24, 24, 8}, {fine, fine, 3 * fine}, ball_at({0, 0.004, 0.01}, 0.009, fine)),
        Body({10, 12, 14}, vec3(fine), [](vec3) { return 1.0; }),
    };
    Random random{7};
    for (const Body& body : bodies) {
        const SmoothGrid felt = body.felt();
        const vec3 wide = body.half() + vec3(4 * fine);
        const auto anywhere = [&](vec3 reach) {
            return reach * vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        };
        for (int drawn = 0, free = 0; drawn < 60 || free < 60;) {
            const vec3 from = anywhere(wide), to = from + anywhere(vec3(4 * fine));
            if (body.is_drawn(from)) continue;
            const bool ends_in = body.is_drawn(to) && body.is_drawn(glm::mix(from, to, 0.97));
            bool passes = false;
            for (int i = 0; i <= 60 && !passes; ++i) {
                const vec3 at = glm::mix(from, to, i / 60.0);
                for (int c = 0; c < 27; ++c)
                    passes |= body.is_drawn(at + 0.15 * fine * vec3(c % 3 - 1, c / 3 % 3 - 1, c / 9 - 1));
            }
            if (passes && !ends_in) continue;
            auto hand = hand_on(felt);
            double most = 0;
            const vec3 force = pushed(hand, from, to, 40, &most);
            if (ends_in) EXPECT_GT(glm::length(force), 1e-9);
            if (!ends_in) EXPECT_LE(most, 1e-12);
            ++(ends_in ? drawn : free);
        }
    }
}

// The plane of a surface goes on without end, but a thin edge of a body between two faces of its box ends.
TEST(DrawnBody, BesideAThinEdgeOnAFaceOfTheBoxNothingIsFelt) {
    // Solid in the last tenth of a sample before the face x, so the edge's normal lies along the face y.
    const Body edge({12, 12, 12}, vec3(fine), [&](vec3 p) { return 0.5 + 0.05 * (p.x / fine - 5.4); });
    const SmoothGrid felt = edge.felt();
    const vec3 corner = fine * vec3(5.5, 5.5, 0);
    for (const double past : {0.1, 0.2, 0.4, 0.6, 0.9}) {
        auto hand = hand_on(felt);
        double most = 0;
        pushed(hand, corner + fine * vec3(past + 0.1, 1.5, 0), corner + fine * vec3(past, -0.8, 0.1), 100,
               &most);
        EXPECT_LE(most, 1e-12) << past << " samples beside the face x";
        hand = hand_on(felt);
        EXPECT_GT(glm::length(pushed(hand, corner + fine * vec3(-0.05, 1.5, 0),
                                     corner + fine * vec3(-0.05, -0.3, 0), 100)),
                  0.01);
    }
}

// The plane of a fast hand may lag farther than the reach of the search. Some of these hands would then be
// let go of within the body.
TEST(DrawnBody, AFastHandStaysInABodyOfThickSlices) {
    const Body body({24, 24, 8}, {fine, fine, 3 * fine}, ball_at({0, 0.004, 0.01}, 0.009, fine));
    const SmoothGrid felt = body.felt();
    Random random{1000};
    const auto anywhere = [&](vec3 reach) {
        return reach * vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    };
    for (int drawn = 0; drawn < 900;) {
        const vec3 from = anywhere(body.half() + vec3(4 * fine)), to = from + anywhere(vec3(4 * fine));
        if (body.is_drawn(from) || !body.is_drawn(to) || !body.is_drawn(glm::mix(from, to, 0.97))) continue;
        auto hand = hand_on(felt);
        EXPECT_GT(glm::length(pushed(hand, from, to, 40)), 1e-9) << drawn;
        ++drawn;
    }
}

TEST(DrawnBody, AMagnetHoldsAHandThatSlidesFastAcrossSamples) {
    const Body floor({48, 12, 12}, vec3(fine), [](vec3 p) { return 0.5 - 0.5 * p.y / fine; });
    const SmoothGrid felt = floor.felt();
    ModeUse use{find_mode("isosurface"), any_field(field_of<Scalar>(felt)), {}};
    use.settings.strength = field::constant(50);
    use.settings.level = level;
    use.settings.reach = 2 * fine;
    use.settings.magnet = 1;
    TouchedModes hand{{use}, stiffness};
    pushed(hand, {-0.015, -0.0005, 0}, {-0.015, 0.0003, 0}, 100);
    // A step of a sample and a half in a tick, at a height at which the magnet holds
    for (int t = 1; t <= 15; ++t) {
        const vec3 force = hand.move({-0.015 + 0.0015 * t, 0.0003, 0});
        EXPECT_LT(force.y, -0.1) << t;
    }
}

TEST(DrawnBody, ASheetOfOneSampleIsFeltInEveryDirection) {
    Random random{3};
    for (int i = 0; i < 40; ++i) {
        const vec3 normal = bench::even_direction(i, 40);
        const double at = random.uniform(-3, 3) * fine;
        const Body sheet({24, 24, 24}, vec3(fine), [&](vec3 p) {
            return std::clamp(1 - std::abs(glm::dot(p, normal) - at) / fine, 0.0, 1.0);
        });
        const SmoothGrid felt = sheet.felt();
        auto hand = hand_on(felt);
        const vec3 force = pushed(hand, (at + 0.004) * normal, (at - 0.0006) * normal, 200);
        EXPECT_GT(glm::dot(force, normal), 0.6) << i;
    }
}

/// Largest angle between force and normal, on a ball with a radius of 20 samples (degrees).
double worst_direction(const Body& body, vec3 middle) {
    constexpr double radius = 20 * fine;
    const SmoothGrid felt = body.felt();
    double worst = 0;
    for (int i = 0; i < 200; ++i) {
        const vec3 out = bench::even_direction(i, 200);
        auto hand = hand_on(felt);
        const vec3 force =
            pushed(hand, middle + (radius + 0.004) * out, middle + (radius - 0.003) * out, 100);
        worst = std::max(worst, glm::length(glm::cross(force, out)) / glm::length(force));
    }
    return std::asin(worst) / radians_per_degree;
}

TEST(DrawnBody, MasksAndSlicesFarApartHaveSmoothDirections) {
    const vec3 middle(0.21 * fine, 0.37 * fine, -0.13 * fine);
    const auto soft = ball_at(middle, 20 * fine, fine), hard = ball_at(middle, 20 * fine, 1e-9);
    EXPECT_LE(worst_direction({{64, 64, 64}, vec3(fine), soft}, middle), 1.5);
    EXPECT_LE(worst_direction({{64, 64, 22}, {fine, fine, 3 * fine}, soft}, middle), 3);
    EXPECT_LE(worst_direction({{64, 64, 64}, vec3(fine), hard}, middle), 6);
    EXPECT_LE(worst_direction({{64, 64, 22}, {fine, fine, 3 * fine}, hard}, middle), 6);
}

/// Height of a place above a surface (m), and the normal there.
struct Above {
    double height{};
    vec3 out{};
};

/// Samples of slices three times as thick as the samples are wide. Each is the share of its voxel that lies
/// below a surface.
template <class Surface>
Body sliced(std::array<int, 3> count, Surface surface) {
    const vec3 voxel(fine, fine, 3 * fine);
    return {count, voxel, [&](vec3 p) {
                const Above above = surface(p);
                return std::clamp(0.5 - above.height / glm::dot(voxel, glm::abs(above.out)), 0.0, 1.0);
            }};
}

/// Angle between a surface's normal and the force 1 mm below a place on it (degrees).
double direction_error(TouchedModes& hand, vec3 place, vec3 out) {
    const vec3 force = pushed(hand, place + 0.004 * out, place - 0.001 * out, 100);
    return std::asin(glm::length(glm::cross(force, out)) / glm::length(force)) / radians_per_degree;
}

TEST(DrawnBody, APlaneOfSlicesKeepsItsDirectionNearTheBox) {
    // A kernel that repeats the last average beyond the box makes slopes flatter near the box. With such a
    // kernel, the force was up to 10.6 degrees off in 40 such places.
    constexpr double side = 31.5 * fine;
    double worst = 0;
    // Direction 0 is skipped: it is parallel to the slices, so all slices are equal, with few values like a
    // mask.
    for (int i = 1; i < 24; ++i) {
        const vec3 out = bench::even_direction(i, 24);
        vec3 place(0);
        place[i % 3] = (i % 2 == 0 ? 1 : -1) * (side - 6 * fine);
        const Body body = sliced({64, 64, 22}, [&](vec3 p) { return Above{glm::dot(p - place, out), out}; });
        const SmoothGrid felt = body.felt();
        auto hand = hand_on(felt);
        worst = std::max(worst, direction_error(hand, place, out));
    }
    EXPECT_LE(worst, 3);
}

TEST(DrawnBody, AThickRingOfSlicesKeepsItsDirection) {
    // With averages over blocks of two slices, which a mask needs, the force was up to 5.7 degrees off here.
    constexpr double radius = 32 * fine, tube = 18 * fine;
    const vec3 middle(0.0002, -0.0007, 0.0004), axis = glm::normalize(vec3(0.3, 0.5, 0.8));
    const Body body = sliced({112, 112, 38}, [&](vec3 p) {
        const vec3 q = p - middle, flat = q - glm::dot(q, axis) * axis;
        const vec3 from_core = q - radius / std::max(glm::length(flat), 1e-9) * flat;
        return Above{glm::length(from_core) - tube, from_core / std::max(glm::length(from_core), 1e-9)};
    });
    const SmoothGrid felt = body.felt();
    auto hand = hand_on(felt);
    double worst = 0;
    const vec3 x = glm::normalize(glm::cross(axis, vec3(1, 0, 0))), y = glm::cross(axis, x);
    for (int i = 0; i < 200; ++i) {
        const double around = 2 * pi * i / 200, across = 2.4 * i;
        const vec3 away = det::cos(around) * x + det::sin(around) * y;
        const vec3 out = det::cos(across) * away + det::sin(across) * axis;
        worst = std::max(worst, direction_error(hand, middle + radius * away + tube * out, out));
    }
    EXPECT_LE(worst, 3);
}

/// Largest change of force per tick (N) for a tip that slides with 1 N, at 50 mm/s, on a ball with a radius
/// of 32 samples.
double max_step(const Body& body, double stiff = stiffness) {
    constexpr double radius = 32 * fine, speed = 5e-5;
    const double deep = 1 / stiff;
    const SmoothGrid felt = body.felt();
    double largest = 0;
    for (int way = 0; way < 4; ++way) {
        const vec3 from = bench::even_direction(way, 4);
        const vec3 to = glm::normalize(glm::cross(from, vec3(0.3, 1, 0.5)));
        auto hand = hand_on(felt);
        hand.stiffness = stiff;
        vec3 before = pushed(hand, (radius + 2 * fine) * from, (radius - deep) * from, 100);
        for (int tick = 1; tick < 800; ++tick) {
            const double turn = speed * tick / radius;
            const vec3 force = hand.move((radius - deep) * (det::cos(turn) * from + det::sin(turn) * to));
            if (tick > 50) largest = std::max(largest, glm::distance(force, before));
            before = force;
        }
    }
    return largest;
}

TEST(DrawnBody, ATipThatSlidesFeelsNoStepsOfSamples) {
    constexpr double most = 0.02;
    constexpr std::array<int, 3> cube{72, 72, 72}, half{72, 72, 36}, slices{72, 72, 24};
    const vec3 apart(fine, fine, 3 * fine);
    EXPECT_LE(max_step({cube, vec3(fine), ball_at({}, 32 * fine, fine)}), 0.005);
    EXPECT_LE(max_step({cube, vec3(fine), ball_at({}, 32 * fine, 1e-9)}), most) << "mask";
    EXPECT_LE(max_step({slices, apart, ball_at({}, 32 * fine, 1.5 * fine)}), most) << "slices";
    EXPECT_LE(max_step({slices, apart, ball_at({}, 32 * fine, fine)}), most) << "hard slices";
    EXPECT_LE(max_step({slices, apart, ball_at({}, 32 * fine, 1e-9)}), most) << "mask of slices";
    EXPECT_LE(max_step({half, {fine, fine, 2 * fine}, ball_at({}, 32 * fine, 1e-9)}), most)
        << "mask of slices less far apart";
    EXPECT_LE(max_step({cube, vec3(fine), ball_at({}, 32 * fine, 1e-9)}, 3000), 0.07)
        << "mask by a stiff device";
    const auto shell = [](double thick, double height) {
        return [=](vec3 p) {
            return std::max(0.0, height * (1 - std::abs(glm::length(p) - 32 * fine) / thick));
        };
    };
    EXPECT_LE(max_step({cube, vec3(fine), shell(fine, 1.3)}), most) << "shell of one sample";
    EXPECT_LE(max_step({cube, vec3(fine), shell(1.5 * fine, 1)}), most) << "thin shell";
    Random random{5};
    EXPECT_LE(max_step({cube, vec3(fine),
                        [&](vec3 p) {
                            const double share = ball_at({}, 32 * fine, 1.5 * fine)(p);
                            return share + random.uniform(-0.25, 0.25) > level ? 1.0 : 0.0;
                        }}),
              most)
        << "mask of noise";
}

TEST(DrawnBody, SamplesThatAreNotFiniteCountAsTheyAreDrawn) {
    constexpr double radius = 20 * fine;
    const auto ball = ball_at({}, radius, fine);
    for (const double outside : {std::nan(""), -HUGE_VAL}) {
        for (const double inside : {1.0, HUGE_VAL}) {
            const Body scan({52, 52, 52}, vec3(fine), [&](vec3 p) {
                const double height = glm::length(p) - radius;
                return height > fine ? outside : height < -fine ? inside : ball(p);
            });
            const SmoothGrid felt = scan.felt();
            for (int i = 0; i < 40; ++i) {
                const vec3 out = bench::even_direction(i, 40);
                auto hand = hand_on(felt);
                const vec3 force = pushed(hand, (radius + 0.004) * out, (radius - 0.001) * out, 100);
                EXPECT_LE(glm::distance(force, out), 0.15) << outside << " " << inside << " " << i;
            }
        }
    }
}

TEST(DrawnBody, TheNormalTurnsOverTheEdgeOfACutWithoutAJump) {
    const vec3 middle(0, 0, 0.005);
    constexpr double radius = 0.015, step = 1e-5;
    const Body cut({40, 40, 20}, vec3(fine), ball_at(middle, radius, fine));
    const SmoothGrid felt = cut.felt();
    const double face = cut.half().z, high = face - middle.z, edge = std::sqrt(radius * radius - high * high);
    const double begin = std::asin(edge / radius);
    vec3 before(0, 0, 1);
    for (int i = -300; i < 300; ++i) {
        // The path goes from the flat face, where the box cuts off the ball, over the edge and down the ball.
        const double turn = begin + std::max(i, 0) * step / radius;
        const vec3 out(det::sin(turn), 0, det::cos(turn));
        const vec3 place = i < 0 ? vec3(edge + i * step, 0, face) : middle + radius * out;
        const LevelContact contact = find_contact({field_of<Scalar>(felt), level, false, 2 * fine},
                                                  place + 1e-6 * before, place - 1e-4 * before);
        ASSERT_GE(contact.count, 1U) << i;
        const vec3 normal = contact.planes[0].normal;
        EXPECT_LE(glm::distance(normal, before), 0.06) << i;
        before = normal;
        if (i == -300) EXPECT_LE(glm::distance(normal, vec3(0, 0, 1)), 1e-12);
        if (i == 299) EXPECT_LE(glm::distance(normal, out), 0.06);
    }
}

/// The proxy is where the tip was one tick ago, and so lags behind an approaching tip. No friction may hold
/// the proxy there.
TEST(DrawnBody, ATipInFrontOfABodyMeetsNoFriction) {
    const Body ball({24, 24, 24}, vec3(fine), ball_at(vec3(0), 0.007, fine));
    const SmoothGrid felt = ball.felt();
    auto hand = hand_on(felt);
    hand.uses[0].settings.friction = field::constant(0.3);
    const VolumeFeel feel{.density = field_of<Scalar>(felt),
                          .walls = {{{.density = level, .strength = 50, .friction = 0.3, .reach = 2 * fine}}},
                          .wall_count = 1};
    for (const double radius : {0.0085, 0.008, 0.0072, 0.0069}) {
        const vec3 out = glm::normalize(vec3(1, 2, -0.5));
        const ModeInput input{.proxy = (radius + 1e-4) * out, .tip = radius * out, .stiffness = stiffness};
        PrimitiveSet mode, wall;
        add_modes(hand.uses, input, mode);
        add_volume_feel(feel, input, wall);
        const double of_mode = mode.items()[2].strength, of_wall = wall.items()[3].strength;
        if (radius > 0.007) {
            EXPECT_EQ(of_mode, 0) << radius;
            EXPECT_EQ(of_wall, 0) << radius;
        } else {
            EXPECT_GT(of_mode, 0.02);
            EXPECT_GT(of_wall, 0.02);
        }
    }
}

TEST(DrawnBody, AveragesFollowEdits) {
    auto voxels = field::make_voxels({20, 21, 9}, {fine, fine, 2.4 * fine});
    const field::Grid grid = voxels.density_grid(field::Kernel::linear);
    auto averages = field::make_block_averages(grid, &voxels.bricks);
    ASSERT_FALSE(averages.samples.empty());
    voxels.density[3 + 20 * (7 + 21 * 4)] = 1;
    field::mark_changed(voxels.bricks, {{3, 7, 4}, {4, 8, 5}});
    field::update(averages, grid, voxels.bricks);
    EXPECT_EQ(averages.samples, field::make_block_averages(grid).samples);
    EXPECT_EQ(averages.newest, voxels.bricks.newest);
    EXPECT_TRUE(field::make_block_averages(field::Grid{}).samples.empty());
}

}  // namespace
}  // namespace thaum::haptics
