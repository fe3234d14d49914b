// Tests of the likely spell that the HUD names while a stroke is drawn: when it is named, that it stays, and
// how it is shown.
#include "game/hud/likely_spell.h"

#include <cmath>

#include "game/data/teams.h"
#include "game/hud/casting_overlay.h"
#include "gesture/generated_users.h"
#include "unit/casting_rig.h"

namespace thaum::game::hud_tests {
namespace {

TEST(LikelySpell, IsToldFromHalfOfItsStroke) {
    const auto picture = new_casting_picture();
    auto casting = picture.wizards[0].casting;
    for (const auto& spell : picture.shown->spells) {
        draw_part(casting, spell.gesture, 0.5);
        EXPECT_EQ(likely_spell(casting, *picture.shown), &spell) << spell.name;
    }
}

TEST(LikelySpell, StaysOnceItIsTold) {
    const auto picture = new_casting_picture();
    auto casting = picture.wizards[0].casting;
    double told = 0, changes = 0, all = 0;
    const auto strokes = gesture::generated_strokes({.users = 6, .samples = 1, .seed = 5});
    for (const auto& stroke : strokes) {
        const SpellPresentation* before = nullptr;
        for (double share = 0.3; share <= 1; share += 0.025) {
            draw_points(casting.stroke, gesture::beginning_of(stroke.points, share));
            const auto* current = likely_spell(casting, *picture.shown);
            changes += before != nullptr && current != before;
            told += current != nullptr;
            all += 1;
            before = current;
        }
    }
    EXPECT_GE(told / all, 0.83);
    EXPECT_LE(changes / static_cast<double>(strokes.size()), 0.15);
}

TEST(LikelySpell, DependsOnTheStrokeAlone) {
    const auto picture = new_casting_picture();
    auto casting = picture.wizards[0].casting, other = casting;
    for (const auto& stroke : gesture::generated_strokes({.users = 2, .samples = 1, .seed = 9})) {
        const SpellPresentation* followed = nullptr;
        for (double share = 0.02; share <= 0.7; share += 0.02) {
            draw_points(casting.stroke, gesture::beginning_of(stroke.points, share));
            followed = likely_spell(casting, *picture.shown);
            draw_part(other, "star", share);
            likely_spell(other, *picture.shown);
        }
        // Reads other strokes, until the result for the first stroke is no longer remembered.
        for (const auto* gesture : {"circle", "v"}) {
            draw_part(other, gesture, 0.5);
            likely_spell(other, *picture.shown);
        }
        EXPECT_EQ(likely_spell(casting, *picture.shown), followed);
    }
}

TEST(LikelySpell, IsToldThroughARest) {
    const auto picture = new_casting_picture();
    auto casting = picture.wizards[0].casting;
    for (const auto& spell : picture.shown->spells) {
        draw_part(casting, spell.gesture, 0.5);
        auto& stroke = casting.stroke;
        for (int i = 0; i < 125; ++i, ++stroke.count)
            stroke.points.at(stroke.count) = stroke.points[stroke.count - 1];
        EXPECT_EQ(likely_spell(casting, *picture.shown), &spell) << spell.name << " after a second of rest";
    }
}

TEST(LikelySpell, IsNotToldBeforeAfterOrInPlaceOfAStroke) {
    const auto picture = new_casting_picture();
    auto casting = picture.wizards[0].casting;
    const auto told = [&] { return likely_spell(casting, *picture.shown) != nullptr; };
    EXPECT_FALSE(told());
    draw_part(casting, "star", 0.04);
    EXPECT_FALSE(told()) << "hardly begun";
    draw_part(casting, "star", 0.5);
    EXPECT_TRUE(told());
    for (bool StrokePicture::*other :
         {&StrokePicture::on_brew, &StrokePicture::curve, &StrokePicture::chord}) {
        casting.stroke.*other = true;
        EXPECT_FALSE(told());
        casting.stroke.*other = false;
    }
    casting.stroke.drawing = false;
    EXPECT_FALSE(told()) << "the reading decides";
}

TEST(LikelySpell, ColoursTheStrokeAndShowsItsNameInTheView) {
    auto picture = new_casting_picture();
    auto& casting = picture.wizards[0].casting;
    const auto layout = *lay_out({}, {640, 480}, 5).views[0];
    draw_part(casting, "star", 0.5);
    for (const float far : {1.0F, 30.0F}) {
        for (auto& p : casting.stroke.points) p.x *= far;
        render::Overlay out;
        add_stroke(out, casting, *picture.shown, 0, layout);
        const auto* spell = likely_spell(casting, *picture.shown);
        EXPECT_EQ(has_text(out, "Recall"), spell != nullptr);
        if (spell == nullptr) continue;
        const auto glow = render::colour(spell->colour, 0.6F);
        EXPECT_TRUE(std::ranges::any_of(items_of<render::LineItem>(out),
                                        [&](const auto* line) { return line->colour == glow; }));
    }
}

/// A colour in CIELAB, in which a distance of 2.3 is just visible (sRGB, D65).
fvec3 in_lab(fvec4 paint) {
    const auto root = [](float t) { return t > 0.008856F ? std::cbrt(t) : 7.787F * t + 16.0F / 116; };
    const float x = 0.4124F * paint.r + 0.3576F * paint.g + 0.1805F * paint.b,
                y = 0.2126F * paint.r + 0.7152F * paint.g + 0.0722F * paint.b,
                z = 0.0193F * paint.r + 0.1192F * paint.g + 0.9505F * paint.b;
    const float fx = root(x / 0.9505F), fy = root(y), fz = root(z / 1.089F);
    return {116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)};
}

TEST(LikelySpell, HasAColourUnlikeTheOthersAndTheTeams) {
    const auto picture = new_casting_picture();
    std::vector<fvec4> others;
    for (const std::uint32_t team : {0U, 1U}) {
        others.emplace_back(team_colours(team).light, 1.0F);
        others.emplace_back(team_colours(team).glow, 1.0F);
    }
    for (const auto& spell : picture.shown->spells) {
        const auto own = render::colour(spell.colour, 1);
        for (const auto& other : others)
            EXPECT_GT(glm::distance(in_lab(own), in_lab(other)), 35) << spell.name;
        others.push_back(own);
    }
}

TEST(LikelySpell, StandsOnAPlateInItsPanelWithTheStrokeOnAPageBesideIt) {
    auto picture = new_casting_picture();
    auto& casting = picture.wizards[0].casting;
    for (const auto& spell : picture.shown->spells) {
        draw_part(casting, spell.gesture, 0.7);
        auto layout = *lay_out({.watch = Watch::first}, {1280, 720}, 5).views[0];
        // Changes the layout to that of a view beside the gesture wall.
        layout.strokes.low.x = layout.centre.x - layout.ring;
        render::Overlay out;
        add_stroke(out, casting, *picture.shown, 0, layout);
        const auto within = [](const Panel& box, fvec2 p) {
            constexpr float rounding = 0.01F;  // tolerance (px)
            const fvec2 low = box.low - rounding, high = box.high + rounding;
            return p.x >= low.x && p.y >= low.y && p.x <= high.x && p.y <= high.y;
        };
        const auto& plate = std::get<render::RectItem>(out.items[0]);
        EXPECT_TRUE(within(layout.likely, plate.low) && within(layout.likely, plate.high)) << spell.name;
        for (const auto* words : items_of<render::TextItem>(out))
            EXPECT_GE(words->size, 12 * layout.unit) << "as readable as other small words";
        for (const auto* line : items_of<render::LineItem>(out)) {
            const bool on_plate = within(layout.likely, line->from) && within(layout.likely, line->to);
            EXPECT_TRUE(on_plate || (within(layout.strokes, line->from) && within(layout.strokes, line->to)));
        }
    }
}

}  // namespace
}  // namespace thaum::game::hud_tests
