// Tests of the volume lab (scans to feel and carve) without a window: what a hand feels, carves, undoes and
// saves.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "core/file.h"
#include "field/analytic.h"
#include "field/nrrd.h"
#include "field/volume_file.h"
#include "game/lab/hand_path.h"
#include "game/lab/volume_lab.h"
#include "game/lab/volume_trace.h"
#include "unit/message_of.h"

namespace thaum::game {
namespace {

namespace fs = std::filesystem;
const fs::path assets = fs::path(THAUM_SOURCE_DIR) / "assets";

VolumeLab lab_of(field::Volume volume, const std::string& device = "premium") {
    return make_volume_lab(std::move(volume), load_volume_lab_data(assets, device).value()).value();
}

VolumeLab made(const std::string& name, int count = 48) {
    return lab_of(*field::make_volume(name, count, 3));
}

void choose(VolumeLab& lab, const std::string& name, double strength, double level) {
    auto mode = lab_mode(lab, name).value();
    mode.settings.strength = field::constant(strength);
    mode.settings.friction = field::constant(0);
    mode.settings.level = level;
    auto settings = lab.settings;
    settings.modes.push_back(mode);
    const auto changed = change_volume_lab(lab, settings);
    ASSERT_TRUE(changed) << changed.error().message;
}

/// Moves the hand evenly to a place, then holds it there.
VolumeLabFigures move(VolumeLab& lab, vec3 to, int travel, int hold, bool carve = false,
                      std::size_t tool = 0) {
    const vec3 from = lab.hand.target;
    VolumeLabFigures figures;
    for (int i = 1; i <= travel + hold; ++i)
        figures = step_volume_lab(
            lab,
            {.target = glm::mix(from, to, std::min(1.0, double(i) / travel)), .carve = carve, .tool = tool});
    return figures;
}

std::size_t tool_named(const VolumeLab& lab, std::string_view name) {
    const auto at = std::ranges::find(lab.data.tools, name, &field::Tool::name);
    EXPECT_NE(at, lab.data.tools.end());
    return static_cast<std::size_t>(at - lab.data.tools.begin());
}

/// Radius of the generated ball as it is placed in the lab (m).
double ball_radius(const VolumeLab& lab) { return 0.4 * field::made_extent * lab.placement.scale; }

TEST(VolumeLab, AnotherDeviceKeepsTheCarvedBody) {
    auto lab = made("sphere");
    choose(lab, "isosurface", 2.5, 127.5);
    move(lab, {0, 0.9 * ball_radius(lab), 0}, 200, 200, true, tool_named(lab, "melt"));
    move(lab, {0, 0.1, 0}, 200, 10);
    ASSERT_TRUE(lab.edited);
    const auto carved = lab.body.density;
    const auto tick = lab.tick;
    const double reach = lab.settings.modes[0].settings.reach, scale = lab.placement.scale;
    auto falcon = load_lab_device(assets, "falcon").value();
    change_device(lab, falcon);
    EXPECT_EQ(lab.body.density, carved);
    EXPECT_EQ(lab.tick, tick);
    EXPECT_NEAR(lab.placement.scale, scale * 0.08 / 0.24, 1e-9);
    EXPECT_NEAR(lab.settings.modes[0].settings.reach, reach * 0.08 / 0.24, 1e-9);
    // The ball is felt at its place in the smaller workspace, and undo restores what was carved.
    EXPECT_LT(glm::length(move(lab, {-1.3 * ball_radius(lab), 0, 0}, 200, 50).force), 0.01);
    EXPECT_GT(glm::length(move(lab, {-0.9 * ball_radius(lab), 0, 0}, 200, 200).force), 0.1);
    step_volume_lab(lab, {.target = lab.hand.target, .history = -1});
    EXPECT_NE(lab.body.density, carved);
}

TEST(VolumeLab, ABallIsFeltWhereItIsDrawn) {
    auto lab = made("sphere");
    choose(lab, "isosurface", 2.5, 127.5);
    for (const vec3 way : {vec3(0, 1, 0), glm::normalize(vec3(1, 2, 0.5)), glm::normalize(vec3(-1, 1, 1))}) {
        const double r = ball_radius(lab);
        lab.hand = haptics::resting_at(1.3 * r * way);
        lab.servo_state = {};
        const auto figures = move(lab, (r - 0.003) * way, 300, 400);
        EXPECT_NEAR(glm::length(figures.proxy), r, 0.03 * r);
        ASSERT_GT(glm::length(figures.force), 0.3);
        EXPECT_GT(glm::dot(glm::normalize(figures.force), way), 0.998)
            << "within 3 degrees of the ball's normal";
    }
}

TEST(VolumeLab, AHandAtRestBeyondAnEdgeFeelsNothing) {
    // The surface meets a face of the volume's box at a slant. Continued outside, it would be above the hand.
    constexpr int n = 29;
    field::Volume volume{.count = {n, n, n}, .spacing = vec3(1e-3)};
    for (int i = 0; i < n * n * n; ++i) {
        const vec3 a = 4.7911 / (0.5e-3 * (n - 1)) * volume.place(i % n, i / n % n, i / (n * n));
        const double sum = std::sin(a.x + 2.6858) * std::cos(a.y) + std::sin(a.y) * std::cos(a.z) +
                           std::sin(a.z) * std::cos(a.x);
        volume.samples.floats().push_back(static_cast<float>(std::clamp(0.5 + 0.5 * sum, 0.0, 1.0)));
    }
    auto lab = lab_of(std::move(volume), "omega3");
    lab.settings.places = {{.scale = 0.7}};
    choose(lab, "isosurface", lab.data.device.peak_force, 0.5);
    const double h = lab.body.spacing.x * lab.placement.scale;
    rest_hand(lab, h * (vec3(27.4201, -1.4349, 18.7889) - 0.5 * (n - 1)));
    EXPECT_LT(glm::length(move(lab, lab.hand.target, 1, 300).force), 1e-9);
}

TEST(VolumeLab, MaterialThatGrowsAtTheHandDoesNotPushItAway) {
    for (const char* device : {"touch", "omega3"}) {
        for (const char* tool : {"construct", "stamp"}) {
            auto lab = lab_of(*field::make_volume("sphere", 48, 3), device);
            const auto& spec = lab.data.device;
            choose(lab, "isosurface", 0.9 * std::min(spec.peak_force, 10.0), 127.5);
            const double r = ball_radius(lab),
                         deep = spec.peak_force * (0.5 / 400 + 0.5 / spec.max_stiffness);
            rest_hand(lab, {0, r + 0.006, 0});
            move(lab, {0, r - deep, 0}, 300, 200);
            double created = 0, most = 0;
            const auto act = [&](int ticks, VolumeLabInput input) {
                input.target = lab.hand.target;
                for (int i = 0; i < ticks; ++i) {
                    const vec3 from = lab.hand.position;
                    const double force = glm::length(step_volume_lab(lab, input).force);
                    input.history = 0;
                    created = std::max(created + glm::dot(lab.hand.force, lab.hand.position - from),
                                       -force * force / (2 * spec.max_stiffness));
                    most = std::max(most, created);
                }
            };
            act(300, {.carve = true, .tool = tool_named(lab, tool)});
            ASSERT_TRUE(lab.edited);
            for (int i = 0; i < 3; ++i) act(100, {.history = -1}), act(100, {.history = 1});
            EXPECT_LE(most, 0.02) << device << ", " << tool;
        }
    }
}

TEST(VolumeLab, NothingIsFeltBesideTheBoxOfAVolume) {
    for (const char* name : {"gradient", "viscosity", "surface", "isosurface"}) {
        auto lab = made("gyroid", 16);
        choose(lab, name, 1, 0);
        const vec3 half = 0.5 * lab.placement.scale * lab.source.extent();
        const vec3 room = 0.5 * lab.data.device.workspace - half;
        int axis = 0;
        for (int a = 1; a < 3; ++a) axis = room[a] > room[axis] ? a : axis;
        const double beside = half[axis] + 0.3 * room[axis];
        double most = 0;
        for (const double side : {-1.0, 1.0}) {
            for (int i = 0; i < 20; ++i) {
                vec3 place = 0.1 * i * half - half;
                place[axis] = side * beside;
                rest_hand(lab, place);
                lab.servo_state = {};
                place[(axis + 1) % 3] += 0.001;
                most = std::max(most, glm::length(move(lab, place, 5, 10).force));
            }
        }
        EXPECT_LE(most, 1e-9) << name;
    }
}

TEST(VolumeLab, APushBeyondTheStrengthPokesThrough) {
    const auto pressed = [](double strength) {
        auto lab = made("sphere");
        choose(lab, "isosurface", strength, 127.5);
        const double r = ball_radius(lab);
        lab.hand = haptics::resting_at({0, 1.2 * r, 0});
        double most = 0;
        for (int i = 0; i < 1500; ++i)
            most = std::max(most, glm::length(step_volume_lab(lab, {.target = {0, r - 1e-5 * i, 0}}).force));
        return std::pair(glm::length(lab.servo_state.proxy) < 0.9 * r, most);
    };
    EXPECT_TRUE(pressed(0.8).first);
    EXPECT_LT(pressed(0.8).second, 1.2);
    EXPECT_FALSE(pressed(100).first) << "this one holds";
}

TEST(VolumeLab, AFlowHoldsTheHandAcrossItAndLetsItGoAlong) {
    auto lab =
        lab_of(field::sampled(field::field_of<field::Vector>(field::RankineVortex{.radius = 1, .speed = 1}),
                              {32, 32, 32}, vec3(0.005)));
    choose(lab, "follow", 1.5, 0);
    lab.hand = haptics::resting_at({0.02, 0, 0});
    const double across = glm::length(move(lab, {0.026, 0, 0}, 200, 200).force);
    lab.hand = haptics::resting_at({0.02, 0, 0});
    lab.servo_state = {};
    ++lab.model.set_number;
    const double along = glm::length(move(lab, {0.02, 0, -0.004}, 200, 200).force);
    EXPECT_GT(across, 0.5);
    EXPECT_LT(along, 0.3 * across);
}

TEST(VolumeLab, WhatIsMeltedIsNoLongerFelt) {
    auto lab = made("sphere");
    choose(lab, "isosurface", 1.0, 127.5);
    const double r = ball_radius(lab);
    lab.hand = haptics::resting_at({0, 1.2 * r, 0});
    const auto before = lab_hash(lab);
    move(lab, {0, r - 0.004, 0}, 200, 1500, true, tool_named(lab, "melt"));
    EXPECT_LT(lab.servo_state.proxy.y, 0.97 * r) << "the tool has melted its way in";
    EXPECT_TRUE(lab.edited);
    EXPECT_NE(lab_hash(lab), before);
}

TEST(VolumeLab, UndoIsExact) {
    auto lab = made("gyroid", 32);
    const auto whole = lab.body.density;
    move(lab, {0, 0, 0}, 200, 200, true, tool_named(lab, "melt"));
    move(lab, {0.01, 0, 0}, 50, 50);
    const auto once = lab.body.density;
    move(lab, {0.02, 0.01, 0}, 50, 200, true, tool_named(lab, "construct"));
    EXPECT_NE(lab.body.density, once);
    step_volume_lab(lab, {.target = lab.hand.target, .history = -1});
    EXPECT_EQ(lab.body.density, once);
    step_volume_lab(lab, {.target = lab.hand.target, .history = -1});
    EXPECT_EQ(lab.body.density, whole);
    step_volume_lab(lab, {.target = lab.hand.target, .history = 1});
    EXPECT_EQ(lab.body.density, once);
}

TEST(VolumeLab, TheSameInputGivesTheSameBits) {
    const auto run = [] {
        auto lab = made("sphere", 32);
        choose(lab, "isosurface", 1, 127.5);
        choose(lab, "viscosity", 0.5, 0);
        move(lab, {0.005, 0, 0.004}, 500, 500, true, tool_named(lab, "squirt"));
        return lab_hash(lab);
    };
    EXPECT_EQ(run(), run());
}

TEST(VolumeLab, FiltersStandBetweenDataAndAMode) {
    auto lab = made("vortices", 32);
    const std::vector<field::Filter> speed{{field::FilterKind::magnitude}, {field::FilterKind::smooth, 1}};
    VolumeLabSettings settings{{*lab_mode(lab, "isosurface", speed), *lab_mode(lab, "follow")}};
    EXPECT_TRUE(settings.modes[1].filters.empty()) << "each mode has its own";
    const auto changed = change_volume_lab(lab, settings);
    ASSERT_TRUE(changed) << changed.error().message;
    step_volume_lab(lab, {});
    const auto smoothings = lab.fields[0]->filtered.smoothings;
    EXPECT_GT(smoothings, 0U);
    for (int i = 0; i < 50; ++i) step_volume_lab(lab, {});
    EXPECT_EQ(lab.fields[0]->filtered.smoothings, smoothings) << "nothing has changed";
    const vec3 place(0.003, 0.002, 0);
    EXPECT_NEAR(lab.fields[0]->placed.scalar(place).value, value_at(lab, place), 0.1 * lab.range.high);
    settings.modes[0].filters = {{field::FilterKind::gradient}};
    EXPECT_FALSE(change_volume_lab(lab, settings)) << "a flow has no gradient";
    settings.modes[0].filters = {};
    EXPECT_FALSE(change_volume_lab(lab, settings)) << "an isosurface of vectors";
    EXPECT_EQ(lab.settings.modes[0].filters.size(), 2U);
}

TEST(VolumeLab, AModeThatReadsScalarsGetsTheSpeedOfAFlow) {
    auto lab = made("vortices", 16);
    const auto mode = lab_mode(lab, "isosurface").value();
    ASSERT_EQ(mode.filters.size(), 1U);
    EXPECT_EQ(mode.filters[0].kind, field::FilterKind::magnitude);
    const auto message = message_of(lab_mode(lab, "nothing"));
    EXPECT_NE(message.find("follow"), std::string::npos) << message;
}

TEST(VolumeLab, MoreModesThanThereIsRoomForAreRefused) {
    auto lab = made("sphere", 16);
    VolumeLabSettings settings;
    for (int i = 0; i < 6; ++i) settings.modes.push_back(*lab_mode(lab, "isosurface"));
    const auto message = message_of(change_volume_lab(lab, settings));
    EXPECT_NE(message.find("room for 16"), std::string::npos) << message;
}

TEST(VolumeLab, HostileVolumesAndHandsDoNoHarm) {
    auto volume = *field::make_volume("sphere", 16, 1);
    for (std::size_t i = 0; i < volume.samples.size(); i += 7) volume.samples.floats()[i] = std::nanf("");
    auto lab = lab_of(std::move(volume));
    for (const char* name : {"gradient", "isosurface", "surface", "viscosity"}) choose(lab, name, 1e6, 100);
    for (int i = 0; i < 3000; ++i) {
        const double far = i % 3 == 0 ? 1e9 : (i % 3 == 1 ? std::nan("") : -1e9);
        const auto f =
            step_volume_lab(lab, {.target = {far, -far, 0.1 * far}, .carve = i % 40 < 20, .tool = 2});
        ASSERT_TRUE(is_finite(f.force) && is_finite(f.proxy)) << i;
        ASSERT_LE(glm::length(f.force), lab.data.device.peak_force * (1 + 1e-9)) << i;
    }
}

TEST(VolumeLab, ARealHeadIsTouchedPokedCarvedAndSaved) {
    const fs::path path = fs::path(THAUM_SOURCE_DIR) / "../shared/data/volumes/head-ct-128.nrrd";
    if (!fs::exists(path)) GTEST_SKIP() << "there is no folder of volumes beside the source tree";
    auto lab = lab_of(*field::read_volume(path));
    // Selects the mode that is felt as a surface where the scan has the value 300, at which bone begins.
    choose(lab, "isosurface", 1.5, 300);
    // Along z the scan runs from the neck to the top of the head.
    double bone = 0.5 * lab.source.extent().z * lab.placement.scale;
    while (value_at(lab, {0, 0, bone}) < 300 && bone > 0) bone -= 1e-4;
    ASSERT_GT(bone, 0);
    lab.hand = haptics::resting_at({0, 0, bone + 0.01});
    lab.servo_state = {};
    const auto touched = move(lab, {0, 0, bone - 0.002}, 400, 400);
    EXPECT_GT(touched.force.z, 0.2) << "the skull pushes back";
    const auto drawn = [&](double off) {
        const vec3 place = touched.proxy + vec3(0, 0, off * volume_of(lab, 0).finest_spacing());
        return lab.body.density_grid(field::Kernel::linear).value(field::to_own(lab.placement, place));
    };
    EXPECT_LT(drawn(0.25), 300) << "on the surface of the bone that is drawn";
    EXPECT_GT(drawn(-0.25), 300);
    const auto carved = move(lab, {0, 0, bone - 0.005}, 400, 1500, true, tool_named(lab, "melt"));
    EXPECT_LT(carved.proxy.z, bone - 0.001) << "a hole";
    TemporaryFolder folder;
    const auto file = folder.path() / "carved.nrrd";
    ASSERT_TRUE(field::write_nrrd(file, volume_now(lab)));
    EXPECT_EQ(field::read_volume(file)->samples, lab.body.density) << "saved and read, every bit";
}

TEST(VolumeLab, AnUneditedBodyKeepsItsTypeInFiles) {
    EXPECT_EQ(volume_now(made("sphere", 16)).stored_as, field::SampleType::uint8);
}

TEST(VolumeLab, ASurfaceBeginsWhereBodyAndAirPart) {
    auto volume = *field::make_volume("sphere", 16, 1);
    volume.samples.floats()[0] = 3000;  // one sample is as dense as a metal filling
    auto lab = lab_of(volume);
    EXPECT_NEAR(lab_mode(lab, "isosurface")->settings.level, 127.5, 20) << "the middle of the range is 1500";
    ASSERT_TRUE(add_volume_beside(lab, volume));
    EXPECT_NEAR(lab_mode(lab, "isosurface", {}, 1)->settings.level, 127.5, 20);
}

TEST(VolumeLab, ATraceHasARowOfTheHeadersColumns) {
    auto lab = made("sphere", 16);
    std::string row;
    append_volume_row(lab, {}, step_volume_lab(lab, {}), row);
    EXPECT_EQ(std::ranges::count(row, ','), std::ranges::count(volume_trace_header(), ','));
}

TEST(VolumeLab, ShorterServoStepsFeelTheSameWallAndBuzzLessOnAStiffOne) {
    for (const int steps : {1, 2, 5}) {
        auto lab = made("sphere");
        choose(lab, "isosurface", 2.5, 127.5);
        set_servo_rate(lab, steps);
        const double r = ball_radius(lab);
        lab.hand = haptics::resting_at({0, 1.2 * r, 0});
        lab.tips.fill(lab.hand.position);
        const auto figures = move(lab, {0, r - 0.004, 0}, 300, 700);
        EXPECT_NEAR(figures.proxy.y, r, 0.03 * r) << steps;
        // The hand's spring and the wall's spring share the displacement of 0.004 m.
        const double k = lab.model.coupling.stiffness, hand = lab.device.stiffness;
        EXPECT_NEAR(figures.force.y, 0.004 * k * hand / (k + hand), 0.15 * figures.force.y) << steps;
        EXPECT_LT(glm::length(lab.hand.velocity), 2e-3) << steps;
    }
    // With a stiffness far above what the device can render, the hand vibrates on the wall; shorter steps
    // reduce the vibration. The benchmark servo_rate measures the limits of stable stiffness.
    const auto fastest = [](int steps) {
        auto lab = made("sphere");
        choose(lab, "isosurface", 1e3, 127.5);
        set_servo_rate(lab, steps);
        lab.model.coupling = {.stiffness = 1e5};
        const double r = ball_radius(lab);
        lab.hand = haptics::resting_at({0, 1.05 * r, 0});
        lab.tips.fill(lab.hand.position);
        move(lab, {0, r - 0.004, 0}, 300, 700);
        double most = 0;
        for (int i = 0; i < 300; ++i) {
            move(lab, {0, r - 0.004, 0}, 1, 0);
            most = std::max(most, glm::length(lab.hand.velocity));
        }
        return most;
    };
    EXPECT_LT(fastest(5), 0.5 * fastest(2));
}

// ---- several volumes in the lab ---------------------------------------------------------------------------

TEST(VolumeLab, AVolumeIsFeltAndSoIsOneBesideItWhereverTheyLie) {
    auto lab = made("sphere");
    ASSERT_TRUE(add_volume_beside(lab, *field::make_volume("sphere", 48, 1)));
    VolumeLabSettings settings;
    for (const std::size_t volume : {0U, 1U}) {
        auto mode = lab_mode(lab, "isosurface", {}, volume).value();
        mode.settings.strength = field::constant(2.5);
        mode.settings.friction = field::constant(0);
        settings.modes.push_back(mode);
    }
    const double r = ball_radius(lab);
    // Two overlapping balls of half the size. Each is felt on its own side, and both hold the hand in the
    // groove between them.
    settings.places = {{.origin = {-0.3 * r, 0, 0}, .scale = 0.5},
                       {.origin = {0.3 * r, 0, 0}, .yaw = 1, .scale = 0.5}};
    const auto set = change_volume_lab(lab, settings);
    ASSERT_TRUE(set) << set.error().message;
    for (const double side : {-1.0, 1.0}) {
        lab.hand = haptics::resting_at({side * 1.2 * r, 0, 0});
        lab.servo_state = {};
        const auto figures = move(lab, {side * (0.8 * r - 0.003), 0, 0}, 300, 400);
        EXPECT_NEAR(figures.proxy.x, side * 0.8 * r, 0.03 * r);
    }
    lab.hand = haptics::resting_at({0, r, 0});
    lab.servo_state = {};
    const double groove = std::sqrt(0.25 - 0.09) * r;
    const auto figures = move(lab, {0, groove - 0.003, 0}, 300, 600);
    EXPECT_NEAR(figures.proxy.y, groove, 0.04 * r);
    EXPECT_NEAR(figures.proxy.x, 0, 0.04 * r);
    EXPECT_GT(figures.force.y, 0.3);
}

TEST(VolumeLab, APlaceMovesFeelAndValueTogether) {
    auto lab = made("gyroid", 32);
    const LabPlace place{.origin = {0.01, -0.02, 0.015}, .yaw = 0.7, .scale = 0.6};
    const vec3 own(0.02, 0.01, -0.03);
    const auto value = value_at(lab, field::to_parent(lab.placement, own));
    ASSERT_TRUE(change_volume_lab(lab, {{}, {}, {}, {place}}));
    EXPECT_NEAR(value_at(lab, field::to_parent(lab.placement, own)), value, 1e-9);
    EXPECT_NEAR(lab.placement.scale, 0.6 * lab.fitted.scale, 1e-15);
    EXPECT_EQ(message_of(change_volume_lab(lab, {{}, {}, {}, {place, place}})),
              "there are more places than volumes");
    EXPECT_FALSE(change_volume_lab(lab, {{}, {}, {}, {{.scale = 0}}}));
    EXPECT_FALSE(change_volume_lab(lab, {{}, {}, {}, {{.origin = {0, std::nan(""), 0}}}}));
}

// ---- the feel of a whole body -----------------------------------------------------------------------------

void feel_as(VolumeLab& lab, std::vector<FeelPart> parts, const field::TransferFunction& opacity = {}) {
    const auto changed = change_volume_lab(lab, {lab.settings.modes, std::move(parts), opacity});
    ASSERT_TRUE(changed) << changed.error().message;
}

FeelPart part(std::string_view name, std::vector<double> numbers) { return feel_part(name, numbers).value(); }

TEST(BodyFeel, AWallHoldsUpToItsForceTimesTheMaterials) {
    for (const char* material : {"crystal", "wax"}) {
        auto lab = made("sphere");
        const auto index = field::material_index(lab.data.materials, material);
        ASSERT_TRUE(index);
        std::ranges::fill(lab.body.material, *index);
        feel_as(lab, {part("wall", {127.5, 1.0})});
        const double r = ball_radius(lab);
        lab.hand = haptics::resting_at({0, 1.2 * r, 0});
        double most = 0;
        for (int i = 0; i < 2500; ++i)
            most = std::max(most, glm::length(step_volume_lab(lab, {.target = {0, r - 1e-5 * i, 0}}).force));
        const double wanted = lab.data.materials[*index].stiffness / lab.data.materials[0].stiffness;
        EXPECT_NEAR(most, wanted, 0.1 * wanted) << material;
    }
}

TEST(BodyFeel, GoesByThePicturesOpacity) {
    const auto inside = [](double opacity) {
        auto lab = made("sphere");
        feel_as(lab, {part("opacity", {1.0, 2.0})}, field::window(0, 255, 0, opacity));
        const vec3 edge(0, ball_radius(lab), 0);
        lab.hand = haptics::resting_at(edge);
        const auto figures = move(lab, edge, 1, 600);
        return std::pair(figures.force.y, lab.model.viscosity);
    };
    const auto [pushed, drag] = inside(1);
    EXPECT_GT(pushed, 0.2) << "out of the ball";
    EXPECT_GT(drag, 0.4);
    EXPECT_EQ(inside(0), std::pair(0.0, 0.0)) << "what cannot be seen is not felt in this way";
}

/// In the middle of a ball that appears the hand feels nothing. The ball gives energy only as the hand
/// leaves.
TEST(BodyFeel, ABallThatAppearsAroundAHandGivesItLittleAsItLeaves) {
    const field::Tool ball{.name = "ball",
                           .operations = {{.method = field::Method::constant,
                                           .extent = {.shape = field::ExtentShape::sphere, .half = vec3(11)},
                                           .changes = {.density = true},
                                           .density = 1}}};
    for (const char* device : {"premium", "omega3"}) {
        auto empty = *field::make_volume("sphere", 40, 3);
        std::ranges::fill(empty.samples.floats(), 0.0F);
        empty.samples.floats()[0] = 1;
        auto lab = lab_of(std::move(empty), device);
        lab.data.tools = {ball};
        lab.servo.limits = haptics::safety_limits(lab.data.device, 1);
        feel_as(lab, {part("opacity", {1.5 * lab.data.device.peak_force, 1.0})}, field::window(0, 1, 0, 1));
        rest_hand(lab, vec3(0));
        double least = 0, given = 0, most = 0;
        for (int i = 0; i < 1100; ++i) {
            const double way = 0.45 * lab.data.device.workspace.y * std::clamp((i - 200) / 400.0, 0.0, 1.0);
            const vec3 from = lab.hand.position;
            step_volume_lab(lab, {.target = {0, way, 0}, .carve = i >= 100 && i < 108});
            given += glm::dot(lab.hand.force, lab.hand.position - from);
            least = std::min(least, given);
            most = std::max(most, given - least);
        }
        EXPECT_TRUE(lab.edited);
        EXPECT_LE(most, 0.02) << device;
    }
}

/// A ball appears around a hand, which first goes in and then out. The hand feels nothing in the middle of
/// the ball. Near its edge, the hand does more work on the way in than the springs store, and the way out
/// must not return that energy twice.
TEST(BodyFeel, ABallThatAppearsGivesBackNoMoreThanTheWayInCost) {
    struct Case {
        const char* device;
        double begin, in;  // first distance of the hand from the ball's surface, and way inwards (m)
    };
    for (const Case& hand : {Case{"premium", 0.1, 0}, {"omega3", 0.1, 0}, {"omega3", 0.008, 0.008}}) {
        auto lab = lab_of(*field::make_volume("sphere", 32, 3), hand.device);
        const auto ball = lab.body.density;
        std::ranges::fill(lab.body.density, 0.0F);
        feel_as(lab, {part("opacity", {lab.data.device.peak_force, 0})}, field::window(0, 255, 0, 1));
        const double radius = ball_radius(lab);
        const double deepest = std::max(0.0, radius - hand.begin - hand.in);
        double place = std::max(0.0, radius - hand.begin), given = 0, most = 0;
        bool goes_in = true;
        vec3 force{};
        for (int i = 0; place < radius + 0.01; ++i) {
            if (i == 300) {
                lab.body.density = ball;
                field::mark_changed(lab.body.bricks, {{0, 0, 0}, lab.body.count});
                ++lab.model.set_number;
            }
            lab.hand = haptics::resting_at({0, place, 0});
            force = step_volume_lab(lab, {}).force;
            goes_in = goes_in && place > deepest;
            const double step = i < 360 ? 0 : goes_in ? -2e-5 : 2e-5;
            place += step;
            given += force.y * step;
            most = std::max(most, given);
        }
        EXPECT_LE(most, 0.02) << hand.device << " from " << hand.begin;
        EXPECT_GT(most, 0.001) << "the ball was felt";
    }
}

TEST(BodyFeel, PartsThatDoNotFitAreRefusedByName) {
    const auto refusal = [](auto&& result) { return result ? std::string() : result.error().message; };
    const std::vector<double> few{1}, bad{5, 4, 1}, minus{1, -1};
    EXPECT_NE(refusal(feel_part("foam", few)).find("opacity, attract"), std::string::npos);
    EXPECT_NE(refusal(feel_part("wall", few)).find("wall: takes 2 to 3 numbers"), std::string::npos);
    EXPECT_NE(refusal(feel_part("shell", bad)).find("below the high"), std::string::npos);
    EXPECT_NE(refusal(feel_part("wall", minus)).find("negative"), std::string::npos);
    const std::vector three(3, part("wall", {1, 1}));
    EXPECT_EQ(refusal(feel_of_parts(three, {}, 1)), "wall: at most 2 act");
    auto flow = made("vortices", 16);
    EXPECT_EQ(refusal(change_volume_lab(flow, {{}, {part("gravity", {0, 1, 0})}, {}})),
              "a flow has no body to feel");
}

TEST(HandPath, ATraceIsPlayedAgainToTheSameState) {
    const auto play = [](auto input_of) {
        auto lab = made("sphere", 24);
        choose(lab, "isosurface", 2.5, 127.5);
        rest_hand(lab, {0, 0.05, 0});
        std::string rows = volume_trace_header();
        for (int i = 0; i < 700; ++i) {
            const VolumeLabInput input = input_of(lab);
            append_volume_row(lab, input, step_volume_lab(lab, input), rows);
        }
        return std::pair(lab_hash(lab), rows);
    };
    const auto first = play([](const VolumeLab& lab) {
        VolumeLabInput input{.target = {0.02 * std::sin(9 * lab.seconds()), 0.05 - 0.07 * lab.seconds(), 0}};
        input.carve = lab.tick > 300 && lab.tick < 500;
        input.tool = tool_named(lab, "melt");
        input.history = lab.tick == 600 ? -1 : 0;
        return input;
    });
    const auto path = parse_hand_trace(first.second, "trace").value();
    const auto again = play([&](const VolumeLab& lab) {
        const auto use = use_at(path, lab.seconds());
        VolumeLabInput input{.target = wanted_place(path, lab.data.device.workspace, lab.seconds())};
        input.carve = use.tool > 0;
        input.tool = use.tool - (input.carve ? 1U : 0U);
        input.history = use.history;
        return input;
    });
    EXPECT_EQ(again.first, first.first);
    EXPECT_EQ(std::ranges::count(again.second, ','), std::ranges::count(first.second, ','));
    EXPECT_FALSE(parse_hand_trace("time_s,tip_x_m\n0.001,0\n", "old"));
    EXPECT_FALSE(parse_hand_trace(volume_trace_header() + "0.001,0,0\n", "cut"));
}

}  // namespace
}  // namespace thaum::game
