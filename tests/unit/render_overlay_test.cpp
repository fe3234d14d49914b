// Tests that need no OpenGL context: text layout, key names, frame pacing, culling.
#include <gtest/gtest.h>

#include <chrono>
#include <limits>

#include "core/utf8.h"
#include "render/context.h"
#include "render/detail/batches.h"
#include "render/detail/shapes2d.h"
#include "render/font.h"
#include "render/pace.h"
#include "unit/message_of.h"

namespace thaum::render {
namespace {

TEST(Utf8, DecodesAndMarksFaults) {
    EXPECT_EQ(decode_utf8("a\xC3\xA9\xE2\x82\xAC\xF0\x9F\x94\xA5"), U"a\u00E9\u20AC\U0001F525");
    EXPECT_EQ(decode_utf8("\xC3"), U"\uFFFD");
    EXPECT_EQ(decode_utf8("\xFFz"), U"\uFFFDz");
    EXPECT_EQ(decode_utf8("\xC0\x80"), U"\uFFFD\uFFFD") << "overlong";
    EXPECT_EQ(decode_utf8("\xED\xA0\x80").size(), 3U) << "surrogate";
}

TEST(FontTest, MissingFaceNamesThePackage) {
    const auto message = message_of(Font::load({"/nowhere/a.ttf", "/nowhere/b.ttf"}));
    EXPECT_NE(message.find("/nowhere/b.ttf"), std::string::npos);
    EXPECT_NE(message.find("fonts-dejavu-core"), std::string::npos);
}

TEST(FontTest, FileThatIsNoFontIsNamed) {
    const std::string path = THAUM_SOURCE_DIR "/tests/unit/render_overlay_test.cpp";
    EXPECT_NE(message_of(Font::load({path})).find(path), std::string::npos);
}

TEST(FontTest, MeasuresLinesAndSizes) {
    auto font = Font::load().value();
    const fvec2 one = font.measure("Wizard", 20), two = font.measure("Wizard\nWizard", 20);
    EXPECT_EQ(two.x, one.x);
    EXPECT_EQ(two.y, 2 * one.y);
    EXPECT_GT(font.measure("Wizard", 40).x, 1.8F * one.x);
    EXPECT_GT(font.measure("Wizards", 20).x, one.x);
    EXPECT_EQ(font.measure("", 20).x, 0);
    EXPECT_GT(font.measure("x", std::numeric_limits<float>::quiet_NaN()).x, 0);
}

TEST(FontTest, EveryGlyphLiesInTheLinesBox) {
    auto font = Font::load().value();
    for (const int size : {9, 16, 33, 120}) {
        const auto line = font.lay_out(U"jAVf\u00C5gj|\u00FF", size);
        for (const auto& placed : line.glyphs) {
            const auto& g = font.glyph(placed.character, size);
            EXPECT_GE(placed.x, 0);
            EXPECT_GE(placed.y, 0);
            EXPECT_LE(placed.x + g.width, line.width);
            EXPECT_LE(placed.y + g.height, line.height);
        }
    }
}

TEST(AtlasTest, GrowsAndStartsAnewWhenFull) {
    detail::Atlas atlas;
    Glyph big;
    big.width = 500;
    big.height = 500;
    big.coverage.assign(250000, 7);
    char32_t c = 0;
    while (atlas.place(c, 400, big).x >= 0) ASSERT_LT(++c, 100U);
    EXPECT_EQ(c, 16U);  // the atlas (texture of all glyphs) has room for eight rows of two big glyphs
    EXPECT_GE(atlas.place(0, 400, big).x, 0) << "placed glyphs must stay for this frame";
    atlas.start_frame();
    EXPECT_GE(atlas.place(c, 400, big).x, 0);
}

TEST(OverlayBuild, HostileItemsGiveNoFault) {
    auto font = Font::load().value();
    detail::Atlas atlas;
    std::vector<detail::OverlayVertex> out;
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    Overlay overlay;
    for (const float bad : {nan, inf, -inf, -1.0F, 1e30F}) {
        overlay.items.push_back(RectItem{{bad, 0}, {bad, bad}, fvec4(bad), bad});
        overlay.items.push_back(TriangleItem{{bad, 0}, {0, 0}, {0, bad}, fvec4(bad)});
        overlay.items.push_back(ArcItem{{bad, bad}, bad, bad, bad, bad, fvec4(bad)});
        overlay.items.push_back(ArcItem{{0, 0}, 1, 10, bad, bad, fvec4(1)});
        overlay.items.push_back(LineItem{{bad, 0}, {bad, bad}, bad, fvec4(bad)});
        overlay.items.push_back(TextItem{"\xFF\n", {bad, bad}, bad, fvec4(bad)});
    }
    detail::build(overlay, font, atlas, out);
    EXPECT_LT(out.size(), 100000U);
}

TEST(Keys, NamesAndCodesAreInverse) {
    int named = 0;
    for (int code = 0; code < 400; ++code) {
        const auto name = key_name(code);
        if (name.empty()) continue;
        ++named;
        EXPECT_EQ(key_code(name), code) << name;
    }
    EXPECT_GT(named, 100);
    EXPECT_EQ(key_name(87), "W");
    EXPECT_EQ(key_code("esc"), key_code("Esc"));
    EXPECT_TRUE(key_code("KP_8") && key_code("Space") && key_code("Left"));
    EXPECT_FALSE(key_code("no key"));
    EXPECT_TRUE(key_name(-1).empty());
}

TEST(Pace, DeadlinesDoNotDriftAndStallsAreForgotten) {
    EXPECT_EQ(next_deadline(100, 105, 10), 110);
    EXPECT_EQ(next_deadline(100, 115, 10), 110) << "a little late: the next one catches up";
    EXPECT_EQ(next_deadline(100, 500, 10), 500);
}

TEST(Pace, WaitsForWholePeriods) {
    Pacer pacer(200);
    EXPECT_EQ(pacer.wait(), 0);
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < 10; ++i) pacer.wait();
    const double s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    EXPECT_GT(s, 0.045);
}

TEST(Culling, CountsVisibleInstances) {
    const std::vector<Bounds> meshes{{fvec3(0), 1}};
    const Camera camera{.position = {0, 0, 0}};
    const auto matrix = detail::projection_matrix(camera, 1.5F) * detail::view_matrix(camera);
    const std::vector<Instance> instances{
        {.mesh = 0, .model = translated({0, 0, -10})},   // an object in front of the eye
        {.mesh = 0, .model = translated({0, 0, 10})},    // an object behind the eye
        {.mesh = 0, .model = translated({0, 0, 0.5F})},  // an object around the eye
        {.mesh = 0, .model = translated({50, 0, -10})},  // an object far to the right
        {.mesh = 0, .model = translated({50, 0, -10}) * scaled(fvec3(60))},
        {.mesh = 0, .model = translated({0, 0, -1000})},  // an object beyond the far plane
        {.mesh = 0, .model = fmat4(std::numeric_limits<float>::quiet_NaN())},
        {.mesh = 0, .model = fmat4(std::numeric_limits<float>::infinity())},
    };
    detail::Batches out;
    EXPECT_EQ(detail::collect(instances, {meshes}, {.to_clip = matrix}, out), 1U);
    EXPECT_EQ(out.instances.size(), 3U);
    EXPECT_EQ(out.culled, 5U);
}

TEST(SplitWindow, ViewsTouchAndCover) {
    const auto side = split_window(101, 50, Split::side_by_side),
               stack = split_window(100, 51, Split::top_bottom);
    EXPECT_EQ(side[0].width + side[1].width, 101);
    EXPECT_EQ(side[1].x, side[0].width);
    EXPECT_EQ(stack[0].height + stack[1].height, 51);
    EXPECT_EQ(stack[1].y, stack[0].height);
    EXPECT_EQ(split_window(100, 50, Split::none)[1].width, 0);
}

}  // namespace
}  // namespace thaum::render
