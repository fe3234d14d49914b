// Measures whether the marks that warn of danger stand out from the picture behind them, for normal vision
// and for three kinds of colour blindness. Each mark is drawn over ten scenes, from the dark corner to the
// glowing brew. Everywhere along a mark, some part of it must have a contrast of 3 : 1 to the same pixel of
// the picture without the HUD (WCAG 2.1, 1.4.11).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "game/bots/bot.h"
#include "game/hud/hud.h"
#include "game/hud/layout.h"
#include "render/colour.h"
#include "render/context.h"
#include "unit/hud_rig.h"

namespace thaum::game::contrast_tests {
namespace {

using hud_tests::match_data;

constexpr render::Size window{1280, 720};
constexpr double min_contrast = 3;

/// How a kind of eye sees a colour, in linear light: Machado, Oliveira and Fernandes, A Physiologically-based
/// Model for Simulation of Color Vision Deficiency (2009), severity 1. Rows give red, green and blue.
struct Eyes {
    std::string_view name;
    std::array<fvec3, 3> rows;
};
const Eyes kinds_of_eyes[] = {
    {"usual", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
    {"protanopia",
     {{{0.152286F, 1.052583F, -0.204868F},
       {0.114503F, 0.786281F, 0.099216F},
       {-0.003882F, -0.048116F, 1.051998F}}}},
    {"deuteranopia",
     {{{0.367322F, 0.860646F, -0.227968F},
       {0.280085F, 0.672501F, 0.047413F},
       {-0.011820F, 0.042940F, 0.968881F}}}},
    {"tritanopia",
     {{{1.255528F, -0.076749F, -0.178779F},
       {-0.078411F, 0.930809F, 0.147602F},
       {0.004733F, 0.691367F, 0.303900F}}}},
};

/// Relative luminance (ITU-R BT.709) of a colour in linear light, as eyes of one kind see it.
double luminance(fvec3 linear, const Eyes& eyes) {
    const auto seen = [&](std::size_t row) {
        return std::clamp(static_cast<double>(glm::dot(eyes.rows[row], linear)), 0.0, 1.0);
    };
    return 0.2126 * seen(0) + 0.7152 * seen(1) + 0.0722 * seen(2);
}

double contrast(double a, double b) { return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05); }

fvec3 linear_at(const render::Image& image, fvec2 place) {
    const int x = std::clamp(static_cast<int>(place.x), 0, image.width - 1),
              y = std::clamp(static_cast<int>(place.y), 0, image.height - 1);
    const auto at = 3 * static_cast<std::size_t>(y * image.width + x);
    const auto channel = [&](std::size_t c) {
        return static_cast<float>(linear_from_srgb(image.rgb[at + c] / 255.0));
    };
    return {channel(0), channel(1), channel(2)};
}

/// One scene, drawn with and without the HUD.
struct Drawn {
    render::Image with, without;
};

/// Places on a line that crosses a mark from one side to the other (px).
using Across = std::vector<fvec2>;

/// Places from `inner` to `outer` (px) in the direction `angle`, clockwise from straight up (rad).
Across along_ray(fvec2 centre, float angle, float inner, float outer) {
    Across places;
    for (float r = inner; r <= outer; r += 0.5F)
        places.push_back(centre + r * fvec2(std::sin(angle), -std::cos(angle)));
    return places;
}

double best_contrast(const Drawn& drawn, const Across& places, const Eyes& eyes) {
    double best = 1;
    for (const auto& place : places)
        best = std::max(best, contrast(luminance(linear_at(drawn.with, place), eyes),
                                       luminance(linear_at(drawn.without, place), eyes)));
    return best;
}

struct Standing {
    const char* where;
    vec3 feet, at;
};
constexpr Standing ten_scenes[] = {
    {"the sunny wall", {-9, 0, 1.3}, {-20, 2, 3}},
    {"the dark corner", {13.5, 0, -12.5}, {20, 1.2, -19}},
    {"the sky", {-9, 0, 6}, {-4, 14, -2}},
    {"the brew from near", {-2.2, 0, 1.4}, {0, 0.9, 0}},
    {"the bowl from afar", {-8, 0, 6}, {0, 0.9, 0}},
    {"the ground in the sun", {-6, 0, 5}, {-7.5, 0, 3.5}},
    {"the pit", {6, 0, 2}, {9, -2, 3}},
    {"the shady wall", {15, 0, 10}, {20, 1.5, 12}},
    {"the whole court", {-17, 0, 15}, {10, 1, -8}},
    {"crates", {11, 0, 1.5}, {13, 0.5, 1.5}},
};

class Contrast : public hud_tests::ArenaDrawingTest {
protected:
    Contrast() : ArenaDrawingTest(window) {}
    void SetUp() override {
        ArenaDrawingTest::SetUp();
        layout = *lay_out(settings, window, match_data()->wands.size()).views[0];
    }

    Picture standing(const Standing& place) const {
        auto picture = hud_tests::picture_of(*hud_tests::new_match());
        hud_tests::stand(picture, match_data()->wizard, 0, place.feet, place.at);
        return picture;
    }

    Drawn drawn(const Picture& picture) {
        auto frame = make_frame(arena_scene, picture, settings, window, memory);
        renderer->draw(frame);
        auto with = renderer->read_pixels();
        frame.overlay = {};
        renderer->draw(frame);
        return {std::move(with), renderer->read_pixels()};
    }

    /// Expects that on each line of `mark` some place has the required contrast for all eyes.
    static void expect_seen(const Drawn& drawn, const std::vector<Across>& mark, const char* where) {
        for (const auto& eyes : kinds_of_eyes)
            for (std::size_t i = 0; i < mark.size(); ++i)
                EXPECT_GE(best_contrast(drawn, mark[i], eyes), min_contrast)
                    << where << ", " << eyes.name << ", place " << i << " of " << mark.size();
    }

    HudSettings settings{.watch = Watch::first};
    ViewLayout layout;
    FrameMemory memory;
};

TEST_F(Contrast, OfTheArcThatShowsWhereAHurtCameFrom) {
    for (const auto& place : ten_scenes) {
        auto picture = standing(place);
        auto& w = picture.wizards[0];
        w.senses.hurts = 1;
        w.senses.marks[0] = {.age_s = 0.2,
                             .towards = rotation({0, 1, 0}, w.vitals.yaw) * vec3(1, 0, 0)};  // from the right
        std::vector<Across> arc;
        for (float aside = -0.33F; aside <= 0.33F; aside += 0.03F)
            arc.push_back(along_ray(layout.centre, static_cast<float>(pi / 2) + aside,
                                    layout.ring * (1 - 14.0F / 66), layout.ring));
        expect_seen(drawn(picture), arc, place.where);
    }
}

TEST_F(Contrast, OfLowHealth) {
    const fvec2 centre = (layout.health.low + layout.health.high) / 2.0F;
    const float u = layout.unit;
    for (const auto& place : ten_scenes) {
        auto picture = standing(place);
        picture.wizards[0].vitals.health = 20;
        const auto images = drawn(picture);
        std::vector<Across> arc, heart;
        for (float angle = -2.3F; angle < -1.5F; angle += 0.05F)
            arc.push_back(along_ray(centre, angle, 24 * u, 38 * u));
        for (float x = -4; x <= 4; x += 1)
            heart.push_back(along_ray(centre + u * fvec2(x, -14), 0, 0, 12 * u));
        expect_seen(images, arc, place.where);
        expect_seen(images, heart, place.where);
    }
}

/// Test of the measure itself: without an edge, a mark is invisible to some eyes on some backgrounds.
TEST(ContrastMeasure, RedOnBrickIsLostToSomeEyes) {
    const auto red = fvec3(render::colour(0xFF4A3A, 1.0F)), brick = fvec3(render::colour(0xA4686C, 1.0F));
    EXPECT_LT(contrast(luminance(red, kinds_of_eyes[0]), luminance(brick, kinds_of_eyes[0])), min_contrast);
    EXPECT_LT(contrast(luminance(red, kinds_of_eyes[1]), luminance(brick, kinds_of_eyes[1])), min_contrast);
    for (const auto& eyes : kinds_of_eyes) {
        EXPECT_NEAR(luminance({1, 1, 1}, eyes), 1, 1e-5) << eyes.name << " sees white as white";
        EXPECT_NEAR(contrast(luminance({1, 1, 1}, eyes), luminance({0, 0, 0}, eyes)), 21, 1e-3);
    }
}

}  // namespace
}  // namespace thaum::game::contrast_tests
