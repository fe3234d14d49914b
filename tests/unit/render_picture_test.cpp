// Tests of pictures drawn without a display, by their pixels.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "core/file.h"
#include "render/context.h"
#include "render/renderer.h"
#include "unit/message_of.h"
#include "unit/read_png.h"

namespace thaum::render {
namespace {

constexpr int width = 200, height = 120;
const std::filesystem::path assets = THAUM_SOURCE_DIR "/assets";

struct Pixel {
    int r, g, b;
};

Pixel at(const Image& image, int x, int y) {
    const auto i = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                        static_cast<std::size_t>(x));
    return {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]};
}

Pixel middle(const Image& image) { return at(image, image.width / 2, image.height / 2); }

bool reddish(Pixel p) { return p.r > 80 && p.g < p.r / 3 && p.b < p.r / 3; }
bool greenish(Pixel p) { return p.g > 80 && p.r < p.g / 3 && p.b < p.g / 3; }

template <class Test>
int count(const Image& image, Rect in, Test test) {
    int sum = 0;
    for (int y = in.y; y < in.y + in.height; ++y) {
        for (int x = in.x; x < in.x + in.width; ++x) sum += test(at(image, x, y));
    }
    return sum;
}

/// White light from all directions and no fog, so that red objects appear red.
Environment plain_light() {
    Environment e;
    e.sun.colour = fvec3(0);
    e.ambient = {fvec3(1), fvec3(1)};
    e.fog.density = 0;
    e.sky = {fvec3(0.2F), fvec3(0.2F), fvec3(0)};
    return e;
}

class Picture : public testing::Test {
protected:
    void SetUp() override {
        auto made = Offscreen::create(width, height);
        if (!made) GTEST_SKIP() << made.error().message;
        context.emplace(std::move(*made));
        context->make_current();
        renderer.emplace(Renderer::create(assets).value());
        cube = renderer->upload(box(fvec3(0.5F), fvec3(1)));
    }

    ViewScene view(Rect viewport, const std::vector<Instance>& instances) const {
        ViewScene v;
        v.camera.position = fvec3(0);
        v.viewport = viewport;
        v.instances = instances;
        v.environment = plain_light();
        return v;
    }

    Instance cube_at(fvec3 place, fvec3 tint) const {
        return {.mesh = cube, .model = translated(place), .tint = tint, .glow = 0};
    }

    Image drawn(const Frame& frame) {
        renderer->draw(frame);
        return renderer->read_pixels();
    }

    Image drawn(const std::vector<Instance>& instances) {
        return drawn(Frame{.width = width, .height = height, .views = {view(whole, instances)}});
    }

    static constexpr Rect whole{0, 0, width, height};
    const fvec3 red{1, 0, 0}, green{0, 1, 0};
    std::optional<Offscreen> context;
    std::optional<Renderer> renderer;
    MeshId cube{};
};

TEST_F(Picture, LowIsPlainFromHalfAsFarAsMedium) {
    const float size = 4;
    const auto grey = fvec3(0.5F);
    const MeshId stone = renderer->upload(
        Patchwork{{.full = box(fvec3(size), grey, 0.1F), .plain = box(fvec3(size), grey), .detail = 0.1F}});
    const auto triangles = [&](Quality quality, float distance) {
        const std::vector<Instance> one{{.mesh = stone, .model = translated({0, 0, -distance})}};
        drawn({.width = width, .height = height, .views = {view(whole, one)}, .quality = quality});
        return renderer->statistics().triangles;
    };
    // Angle of a pixel (rad).
    const float pixel = 2 * std::tan(Camera{}.fov_y / 2) / static_cast<float>(height);
    const float beyond_half = 0.75F * 0.1F / pixel + 2 * size;
    EXPECT_EQ(triangles(Quality::low, 2 * size), triangles(Quality::medium, 2 * size));
    EXPECT_LT(triangles(Quality::low, beyond_half), triangles(Quality::medium, beyond_half));
}

TEST_F(Picture, MeasuringItsPassesChangesNoPixel) {
    const std::vector<Instance> one{cube_at({0, 0, -1.5F}, red)};
    for (const auto quality : {Quality::low, Quality::medium, Quality::high}) {
        Frame frame{.width = width, .height = height, .views = {view(whole, one)}, .quality = quality};
        frame.overlay.items.emplace_back(RectItem{.low = {0, 0}, .high = {4, 4}});
        const auto usual = drawn(frame);
        EXPECT_EQ(renderer->pass_times(), PassTimes{});
        renderer->measure_passes(true);
        const auto measured = drawn(frame);
        const auto& times = renderer->pass_times();
        renderer->measure_passes(false);
        EXPECT_EQ(measured.rgb, usual.rgb);
        for (const auto pass : {Pass::selection, Pass::meshes, Pass::overlay}) EXPECT_GT(times[pass], 0);
    }
}

TEST_F(Picture, SplitViewsColourOnlyTheirOwnHalf) {
    for (const auto split : {Split::side_by_side, Split::top_bottom}) {
        for (const float scale : {1.0F, 0.5F}) {
            const auto rects = split_window(width, height, split);
            const std::vector<Instance> reds{cube_at({0, 0, -1.5F}, red)},
                greens{cube_at({0, 0, -1.5F}, green)};
            const Frame frame{.width = width,
                              .height = height,
                              .views = {view(rects[0], reds), view(rects[1], greens)},
                              .internal_scale = scale};
            const auto image = drawn(frame);
            EXPECT_GT(count(image, rects[0], reddish), 500);
            EXPECT_EQ(count(image, rects[1], reddish), 0);
            EXPECT_GT(count(image, rects[1], greenish), 500);
            EXPECT_EQ(count(image, rects[0], greenish), 0);
        }
    }
}

TEST_F(Picture, AStretchedViewShowsNothingOfItsNeighbour) {
    // Each view is inside a large cube of one colour, so that only that colour may show up to its edge.
    auto wall = box(fvec3(10), fvec3(1));
    for (std::size_t i = 0; i + 2 < wall.indices.size(); i += 3)
        std::swap(wall.indices[i], wall.indices[i + 1]);
    const auto mesh = renderer->upload(wall);
    const std::vector<Instance> reds{{.mesh = mesh, .model = fmat4(1), .tint = red, .glow = 1}},
        greens{{.mesh = mesh, .model = fmat4(1), .tint = green, .glow = 1}};
    for (const auto split : {Split::side_by_side, Split::top_bottom}) {
        for (const float scale : {0.6F, 0.8F}) {
            const auto rects = split_window(width, height, split);
            const auto image = drawn({.width = width,
                                      .height = height,
                                      .views = {view(rects[0], reds), view(rects[1], greens)},
                                      .internal_scale = scale});
            EXPECT_EQ(count(image, rects[0], [](Pixel p) { return p.r > 80 && p.g == 0; }),
                      rects[0].width * rects[0].height);
            EXPECT_EQ(count(image, rects[1], [](Pixel p) { return p.g > 80 && p.r == 0; }),
                      rects[1].width * rects[1].height);
        }
    }
}

TEST_F(Picture, TheFirstViewIsOnTopAndRightIsRight) {
    const auto rects = split_window(width, height, Split::top_bottom);
    const std::vector<Instance> one{cube_at({2, 0, -3}, red)};
    const auto image = drawn({.width = width, .height = height, .views = {view(rects[0], one)}});
    EXPECT_GT(count(image, {width / 2, 0, width / 2, height / 2}, reddish), 20);
    EXPECT_EQ(count(image, {0, 0, width / 2, height}, reddish), 0);
    const auto below = at(image, 50, height - 5);
    EXPECT_EQ(below.r + below.g + below.b, 0) << "pixels outside all views must be black";
}

TEST_F(Picture, NearHidesFar) {
    const auto near = cube_at({0, 0, -2}, red), far = cube_at({0, 0, -6}, green);
    for (const auto& order : {std::vector{near, far}, std::vector{far, near}}) {
        const auto image = drawn(order);
        EXPECT_TRUE(reddish(middle(image)));
        EXPECT_EQ(count(image, whole, greenish), 0);
    }
}

TEST_F(Picture, FogHidesDistantThings) {
    const std::vector<Instance> one{cube_at({0, 0, -20}, 3.0F * red)};
    auto v = view(whole, one);
    v.camera.fov_y = 0.1F;
    v.environment.fog = {.colour = fvec3(0.2F), .density = 0.001F};
    const auto clear = drawn({.width = width, .height = height, .views = {v}});
    EXPECT_TRUE(reddish(middle(clear)));
    v.environment.fog.density = 0.3F;
    const auto foggy = drawn({.width = width, .height = height, .views = {v}});
    const auto fog = middle(foggy), sky = at(foggy, 2, 2);
    EXPECT_NEAR(fog.r, sky.r, 2);
    EXPECT_NEAR(fog.g, sky.g, 2);
}

TEST_F(Picture, LightsReachTheirRadiusAndGlowNeedsNone) {
    auto v = view(whole, {});
    v.environment.ambient = {fvec3(0), fvec3(0)};
    std::vector<Instance> one{cube_at({0, 0, -2}, fvec3(1))};
    v.instances = one;
    PointLight light{.position = {0, 0, 0}, .colour = fvec3(3), .radius = 1.4F};
    v.lights = {&light, 1};
    const auto brightness = [&] {
        return at(drawn({.width = width, .height = height, .views = {v}}), width / 2, height / 2).g;
    };
    EXPECT_EQ(brightness(), 0) << "the cube's face is 1.5 m off";
    light.radius = 4;
    const int lit = brightness();
    EXPECT_GT(lit, 40);
    light.colour = fvec3(6);
    EXPECT_GT(brightness(), lit);
    v.lights = {};
    one[0].glow = 1;
    EXPECT_GT(brightness(), 180);
}

/// A cube above a floor, with the sun straight above and a little light from all directions.
class Shadowed : public Picture {
protected:
    void SetUp() override {
        Picture::SetUp();
        if (IsSkipped()) return;
        floor = renderer->upload(box({4, 0.1F, 4}, fvec3(1)));
        fixed = {{.mesh = floor, .model = translated({0, -1.1F, -4})}};
    }

    /// A frame seen from above, which also shows the cubes in `moving`.
    Frame frame_of(Quality quality) {
        all = fixed;
        all.insert(all.end(), moving.begin(), moving.end());
        auto v = view(whole, all);
        v.camera.position = {0, 5, -4};
        v.camera.orientation = glm::angleAxis(-1.5707963F, fvec3(1, 0, 0));
        v.environment.ambient = {fvec3(0.05F), fvec3(0.05F)};
        // The sun shines a little from the left, so the cube's shadow appears on its right.
        v.environment.sun = {glm::normalize(fvec3(-1, 1, 0)), fvec3(1.5F)};
        return {
            .width = width, .height = height, .views = {v}, .quality = quality, .casters = {fixed, moving}};
    }

    /// Brightness of the floor at x (m) to the right of the middle, 6.1 m below the camera.
    int brightness(Quality quality, float x) {
        const auto image = drawn(frame_of(quality));
        const float pixels_per_m = 0.5F * height / std::tan(0.6F) / 6.0F;
        return at(image, width / 2 + static_cast<int>(std::lround(x * pixels_per_m)), height / 2).g;
    }

    MeshId floor{};
    std::vector<Instance> fixed, moving, all;
};

TEST_F(Shadowed, FallsOppositeTheSunAndNowhereElse) {
    for (const auto quality : {Quality::medium, Quality::high}) {
        moving = {cube_at({0, 1, -4}, fvec3(1))};  // the middle of the cube's shadow is 2 m to the right
        const int lit = brightness(quality, -1.6F), shaded = brightness(quality, 2);
        EXPECT_GT(lit, 2 * shaded) << static_cast<int>(quality);
        EXPECT_GT(shaded, 5) << "ambient light must remain in the shadow";
        EXPECT_NEAR(brightness(quality, 3.2F), lit, 3);
    }
    EXPECT_NEAR(brightness(Quality::low, 2), brightness(Quality::low, -1.6F), 3)
        << "low quality has no shadow map";
}

TEST_F(Shadowed, AShadowThatMovedOnLeavesNoTrace) {
    moving = {cube_at({0, 1, -4}, fvec3(1))};
    const int before = brightness(Quality::medium, 2);
    moving[0] = cube_at({-1.5F, 1, -4}, fvec3(1));
    const int after = brightness(Quality::medium, 2), under = brightness(Quality::medium, 0.5F);
    EXPECT_GT(after, 2 * before);
    EXPECT_NEAR(under, before, 3);
    moving.clear();
    EXPECT_NEAR(brightness(Quality::medium, 0.5F), after, 3);
}

TEST_F(Shadowed, CostsNothingWhileNothingMoves) {
    moving = {cube_at({0, 1, -4}, fvec3(1))};
    drawn(frame_of(Quality::medium));
    EXPECT_EQ(renderer->statistics().shadow_draws, 2U);
    EXPECT_EQ(renderer->statistics().shadow_triangles, 24U);
    drawn(frame_of(Quality::medium));
    EXPECT_EQ(renderer->statistics().shadow_draws, 0U);
    moving[0].model[3].x += 0.01F;
    drawn(frame_of(Quality::medium));
    EXPECT_EQ(renderer->statistics().shadow_draws, 1U) << "fixed things must not be drawn again";
    renderer->replace(floor, box({3, 0.1F, 3}, fvec3(1)));
    drawn(frame_of(Quality::medium));
    EXPECT_EQ(renderer->statistics().shadow_draws, 2U) << "a mesh has changed";
    drawn(frame_of(Quality::low));
    EXPECT_EQ(renderer->statistics().shadow_draws, 0U);
}

TEST_F(Shadowed, OnlyMovedThingsAndTheirOldPlacesAreDrawnAgain) {
    const auto near = cube_at({0, 1, -4}, fvec3(1));
    moving = {near, cube_at({0.2F, 1.2F, -4}, fvec3(1)), cube_at({-2.5F, 1, -4}, fvec3(1))};
    drawn(frame_of(Quality::medium));
    const int shaded = brightness(Quality::medium, 2);
    moving[2].model[3].x += 0.01F;
    drawn(frame_of(Quality::medium));
    EXPECT_EQ(renderer->statistics().shadow_triangles, 12U);
    moving[1].model[3].x += 5;
    drawn(frame_of(Quality::medium));
    EXPECT_EQ(renderer->statistics().shadow_triangles, 24U)
        << "the shadow of the first place must be drawn again";
    EXPECT_NEAR(brightness(Quality::medium, 2), shaded, 3);
    moving = {near};
    EXPECT_NEAR(brightness(Quality::medium, 2), shaded, 3);
    moving = {};
    EXPECT_GT(brightness(Quality::medium, 2), 2 * shaded);
}

TEST_F(Shadowed, CastersThatAreNotNumbersCastNothing) {
    moving = {cube_at({0, 1, -4}, fvec3(1)), cube_at({1, 1, -4}, fvec3(1))};
    moving[1].model[3][1] = std::numeric_limits<float>::quiet_NaN();
    const int shaded = brightness(Quality::medium, 2);
    EXPECT_GT(brightness(Quality::medium, -1.6F), 2 * shaded);
}

TEST_F(Shadowed, LowQualityUsesTheShadeOfTheInstance) {
    moving = {cube_at({0, 0.5F, -4}, fvec3(1))};
    const auto top = [&] { return middle(drawn(frame_of(Quality::low))).g; };
    const int sunny = top();
    moving[0].sun = 0;
    EXPECT_LT(3 * top(), sunny);
}

TEST_F(Picture, ShadesMultiplyTheColourBelowThem) {
    const std::vector<Instance> one{cube_at({0, 0, -2}, fvec3(1))};
    MeshData sheet = transformed(box({0.4F, 0.4F, 0.01F}, fvec3(0.5F)), fmat4(1));
    const auto id = renderer->upload(sheet);
    Instance shade{.mesh = id, .model = translated({0, 0, -1.45F})};
    Frame frame{.width = width, .height = height, .views = {view(whole, one)}};
    const int before = middle(drawn(frame)).g;
    frame.views[0].shades = {&shade, 1};
    EXPECT_NEAR(middle(drawn(frame)).g, 0.5 * before, 2);
    shade.tint = fvec3(0);
    EXPECT_NEAR(middle(drawn(frame)).g, before, 1);
}

TEST_F(Picture, MistsHideMostWhereTheyFaceTheEyeAndNothingAtTheirOutline) {
    const auto ball = renderer->upload(sphere(1, 32, fvec3(1)));
    for (const auto quality : {Quality::low, Quality::medium, Quality::high}) {
        const std::vector<Instance> one{cube_at({0, 0, -6}, fvec3(1))};
        Frame frame{.width = width, .height = height, .views = {view(whole, one)}, .quality = quality};
        const int before = middle(drawn(frame)).r;
        Instance mist{.mesh = ball, .model = translated({0, 0, -3}), .tint = fvec3(0), .glow = 1};
        frame.views[0].mists = {&mist, 1};
        const auto whole_mist = drawn(frame);
        mist.glow = 0.5F;
        const int half = middle(drawn(frame)).r;
        mist.glow = 0;
        EXPECT_EQ(middle(drawn(frame)).r, before);
        const int hidden = middle(whole_mist).r;
        ASSERT_GT(std::abs(hidden - before), 20);
        // With half the glow, the brightness changes about half as much: in linear light at high quality,
        // otherwise in display values.
        EXPECT_GT(std::abs(half - before), 0.3 * std::abs(hidden - before));
        EXPECT_LT(std::abs(half - before), 0.8 * std::abs(hidden - before));
        // A solid object in front of the mist hides the mist.
        mist.glow = 1;
        mist.model = translated({0, 0, -8});
        EXPECT_NEAR(middle(drawn(frame)).r, before, 1);
    }
}

TEST_F(Picture, BloomShinesBeyondBrightEdgesAndCanBeTurnedOff) {
    auto bright = cube_at({0, 0, -6}, fvec3(3));
    bright.glow = 1;
    const std::vector<Instance> one{bright};
    Frame frame{.width = width, .height = height, .views = {view(whole, one)}, .quality = Quality::high};
    const auto beside = [&] { return at(drawn(frame), width / 2 + 13, height / 2).g; };
    const int with = beside();
    frame.bloom = false;
    EXPECT_GT(with, beside() + 10);
    frame.quality = Quality::medium;
    const auto medium = drawn(frame);
    frame.quality = Quality::high;
    const auto high = drawn(frame);
    EXPECT_NEAR(at(high, 3, 3).g, at(medium, 3, 3).g, 2)
        << "the tone curve is the same, wherever it is applied";
    EXPECT_NEAR(middle(high).g, middle(medium).g, 2);
}

TEST_F(Picture, LowUsesFourLightsAndTheOthersEight) {
    auto v = view(whole, {});
    v.environment.ambient = {fvec3(0), fvec3(0)};
    const std::vector<Instance> one{cube_at({0, 0, -2}, fvec3(1))};
    v.instances = one;
    std::vector<PointLight> lights(max_lights,
                                   PointLight{.position = {0, 0, 0}, .colour = fvec3(0), .radius = 6});
    lights[5].colour = fvec3(3);
    v.lights = lights;
    Frame frame{.width = width, .height = height, .views = {v}};
    EXPECT_EQ(middle(drawn(frame)).g, 0);
    for (const auto quality : {Quality::medium, Quality::high}) {
        frame.quality = quality;
        EXPECT_GT(middle(drawn(frame)).g, 40);
    }
}

TEST_F(Picture, FineLinesLoseTheirContrastFarOff) {
    auto dark = box(fvec3(0.5F), fvec3(0.2F));
    for (auto& v : dark.vertices) v.far_away = 5;
    const auto id = renderer->upload(dark);
    const auto seen = [&](float distance) {
        const std::vector<Instance> one{{.mesh = id, .model = translated({0, 0, -distance})}};
        return middle(drawn(one)).g;
    };
    EXPECT_LT(seen(1.5F) + 50, seen(30));
}

TEST_F(Picture, CountsDrawsAndSkipsTheUnseen) {
    std::vector<Instance> instances;
    for (int i = 0; i < 10; ++i) instances.push_back(cube_at({0, 0, -5.0F - static_cast<float>(i)}, red));
    for (int i = 0; i < 7; ++i) instances.push_back(cube_at({0, 0, 5.0F + static_cast<float>(i)}, red));
    drawn(instances);
    const auto& s = renderer->statistics();
    EXPECT_EQ(s.instances_drawn, 10U);
    EXPECT_EQ(s.instances_culled, 7U);
    EXPECT_EQ(s.draws, 3U) << "one mesh, the sky and the view into the window";
    EXPECT_EQ(s.triangles, 10U * 12);
    instances.assign(5, cube_at({0, 0, 5}, red));
    drawn(instances);
    EXPECT_EQ(renderer->statistics().draws, 2U) << "unseen things cost no call";
}

TEST_F(Picture, ThingsThatAreNotNumbersAreNotDrawn) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    auto broken = cube_at({0, 0, -2}, red);
    broken.model[3][1] = nan;
    const auto image = drawn({broken, cube_at({0, 0, -3}, green)});
    EXPECT_GT(count(image, whole, greenish), 50);
    EXPECT_EQ(count(image, whole, reddish), 0);
    // An invalid camera shows nothing useful but must not end the program.
    const std::vector<Instance> one{cube_at({0, 0, -2}, red)};
    auto v = view(whole, one);
    v.camera.position.x = nan;
    v.camera.fov_y = nan;
    drawn({.width = width, .height = height, .views = {v}});
    EXPECT_GT(count(drawn(one), whole, reddish), 50) << "the next picture is whole again";
}

TEST_F(Picture, FrameWithoutSizeOrViewsIsHarmless) {
    renderer->draw(Frame{});
    EXPECT_TRUE(renderer->read_pixels().rgb.empty());
    const auto image = drawn({.width = width, .height = height});
    EXPECT_EQ(count(image, whole, [](Pixel p) { return p.r + p.g + p.b > 0; }), 0);
}

TEST_F(Picture, ReplacedMeshIsDrawn) {
    const std::vector<Instance> one{cube_at({0, 0, -2}, red)};
    const int before = count(drawn(one), whole, reddish);
    renderer->replace(cube, box(fvec3(0.25F), fvec3(1)));
    EXPECT_LT(count(drawn(one), whole, reddish), before / 2);
    renderer->replace(cube, {});
    EXPECT_EQ(count(drawn(one), whole, reddish), 0);
}

TEST_F(Picture, TextStaysInItsMeasuredBox) {
    for (const auto align : {Align::left, Align::centre, Align::right}) {
        const std::string text = "jfÅ gy\nA|";
        const fvec2 size = renderer->measure(text, 18);
        Frame frame{.width = width, .height = height};
        frame.overlay.items.push_back(TextItem{text, {100, 30}, 18, fvec4(1), align});
        const auto image = drawn(frame);
        const float part = align == Align::left ? 0.0F : align == Align::centre ? 0.5F : 1.0F;
        // Half a pixel is rounded if the width is odd, so the box gets one more pixel on each side.
        const Rect box{static_cast<int>(100 - part * size.x) - 1, 30, static_cast<int>(size.x) + 2,
                       static_cast<int>(size.y)};
        const auto inked = [](Pixel p) { return p.r > 0; };
        EXPECT_GT(count(image, box, inked), 100);
        EXPECT_EQ(count(image, whole, inked), count(image, box, inked));
    }
}

TEST_F(Picture, TextIsSharp) {
    Frame frame{.width = width, .height = height};
    frame.overlay.items.push_back(TextItem{"HHH", {20.4F, 20.3F}, 24, fvec4(1)});
    const auto image = drawn(frame);
    const int full = count(image, whole, [](Pixel p) { return p.r > 250; });
    const int grey = count(image, whole, [](Pixel p) { return p.r > 5 && p.r <= 250; });
    EXPECT_GT(full, 2 * grey);
}

TEST_F(Picture, OverlayShapesCoverTheirArea) {
    Frame frame{.width = width, .height = height};
    auto& items = frame.overlay.items;
    const auto covered = [&] {
        const auto image = drawn(frame);
        double sum = 0;
        for (const auto byte : image.rgb) sum += byte;
        return sum / (3 * 255);
    };
    items = {RectItem{{10, 20}, {40, 30}}};
    EXPECT_NEAR(covered(), 300, 0.5);
    items = {TriangleItem{{10, 10}, {70, 20}, {30, 80}}};
    EXPECT_NEAR(covered(), 0.5 * (60 * 70 - 20 * 10), 25);
    items = {LineItem{{10, 10}, {90, 70}, 3}};
    EXPECT_NEAR(covered(), 300, 10);
    items = {ArcItem{{100, 60}, 30, 40, 0, 3.14159265F / 2}};
    EXPECT_NEAR(covered(), 3.14159 / 4 * (1600 - 900), 12);
    const auto image = drawn(frame);
    EXPECT_GT(at(image, 125, 35).r, 250) << "a quarter from 12 to 3 o'clock is at the upper right";
    EXPECT_EQ(at(image, 75, 85).r, 0);
    items = {RectItem{.low = {20, 20}, .high = {80, 60}, .colour = fvec4(1), .corner = 10}};
    EXPECT_NEAR(covered(), 2400 - (4 - 3.14159) * 100, 10);
}

TEST_F(Picture, OverlayBlendsInOrder) {
    Frame frame{.width = width, .height = height};
    frame.overlay.items = {RectItem{{0, 0}, {50, 50}, fvec4(1, 0, 0, 1)},
                           RectItem{{0, 0}, {50, 50}, fvec4(0, 1, 0, 0.5F)}};
    const auto p = at(drawn(frame), 25, 25);
    EXPECT_NEAR(p.r, 128, 2);
    EXPECT_NEAR(p.g, 128, 2);
}

TEST_F(Picture, OverlayIsSharpAtAnyInternalScale) {
    Frame frame{.width = width, .height = height, .views = {view(whole, {})}, .internal_scale = 0.25F};
    frame.overlay.items = {RectItem{{51, 51}, {52, 52}, fvec4(1, 0, 0, 1)}};
    const auto image = drawn(frame);
    EXPECT_EQ(count(image, whole, reddish), 1);
    EXPECT_TRUE(reddish(at(image, 51, 51)));
}

TEST_F(Picture, PngComesBackAsItWas) {
    const auto image = drawn({cube_at({0, 0.3F, -2}, red)});
    const TemporaryFolder folder;
    const auto path = folder.path() / "test.png";
    const auto written = write_png(path, image);
    ASSERT_TRUE(written) << written.error().message;
    const auto read = read_png(path).value();
    EXPECT_EQ(read.width, width);
    EXPECT_EQ(read.height, height);
    EXPECT_EQ(read.rgb, image.rgb);
}

TEST(ImageFile, UnwritablePlaceIsNamed) {
    EXPECT_NE(message_of(write_png("/nowhere/at/all.png", {1, 1, {1, 2, 3}})).find("/nowhere/at/all.png"),
              std::string::npos);
}

class BrokenShader : public Picture {
protected:
    void SetUp() override {
        Picture::SetUp();
        if (IsSkipped()) return;
        std::filesystem::copy(assets / "shaders", folder / "shaders",
                              std::filesystem::copy_options::recursive);
    }

    std::string error() {
        const auto made = Renderer::create(folder);
        EXPECT_FALSE(made);
        return made ? "" : made.error().message;
    }
    const TemporaryFolder own;
    const std::filesystem::path folder = own.path();
};

TEST_F(BrokenShader, EveryFileIsNamedWhenItDoesNotCompile) {
    for (const char* name :
         {"mesh.vert", "mesh.frag", "light.glsl", "shadow.glsl", "tone.glsl", "sky.vert", "flat.frag",
          "shadow.vert", "shadow.frag", "shade.vert", "mist.vert", "mist.frag", "screen.vert", "bright.frag",
          "blur.frag", "compose.frag", "overlay.vert", "overlay.frag", "shape.frag"}) {
        const auto path = folder / "shaders" / name;
        std::ofstream(path) << "#version 330 core\nvoid main() {\n    no such thing;\n}\n";
        const auto message = error();
        EXPECT_NE(message.find(path.string()), std::string::npos) << message;
        EXPECT_NE(message.find('3'), std::string::npos) << "the line: " << message;
        EXPECT_EQ(message.find('\n'), std::string::npos);
        std::filesystem::copy_file(assets / "shaders" / name, path,
                                   std::filesystem::copy_options::overwrite_existing);
    }
}

TEST_F(BrokenShader, MissingFileIsNamed) {
    std::filesystem::remove(folder / "shaders" / "flat.frag");
    EXPECT_NE(error().find("flat.frag"), std::string::npos);
}

}  // namespace
}  // namespace thaum::render
