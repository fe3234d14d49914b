#include "game/hud/wand_icon.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "game/hud/overlay.h"
#include "render/colour.h"

namespace thaum::game {
namespace {

using render::ArcItem;
using render::colour;
using render::LineItem;

constexpr float whole_turn = 6.2831853F;

/// Projection of a wand onto the picture.
struct Icon {
    render::Overlay& out;
    bool flat{};     ///< the wand lies in the plane of x and z; else in that of y and z
    fvec2 middle{};  ///< position of the middle (px)
    float scale{};   ///< px per m
    fvec4 paint{};

    fvec2 at(vec3 p) const {
        constexpr float half_way = 0.2F;  // z of the icon's middle (m)
        const float along = static_cast<float>(p.z) - half_way;
        const auto aside = static_cast<float>(flat ? p.x : p.y);
        return middle + scale * 0.7071F * fvec2(along - aside, -along - aside);
    }
    void line(vec3 from, vec3 to, double radius) const {
        const float width = std::max(1.0F, 2 * scale * static_cast<float>(radius));
        out.items.emplace_back(LineItem{at(from), at(to), width, paint});
    }
    void disc(vec3 p, double inner, double outer) const {
        const float from = scale * static_cast<float>(inner), to = scale * static_cast<float>(outer);
        out.items.emplace_back(ArcItem{at(p), from, std::max(to, from + 1), 0, whole_turn, paint});
    }
};

void add_crook(const Icon& icon, const LookPart& part) {
    constexpr int steps = 7;
    const auto point = [&](int i) {
        const double angle = part.turn * i / steps;
        return part.from + part.bend * vec3(0, 1 - std::cos(angle), std::sin(angle));
    };
    for (int i = 0; i < steps; ++i) icon.line(point(i), point(i + 1), (part.radius + part.radius_end) / 2);
}

void add_part(const Icon& icon, LookPart part) {
    for (int side = 0; side < (part.mirrored ? 2 : 1); ++side) {
        switch (part.shape) {
            case LookShape::rod: icon.line(part.from, part.to, (part.radius + part.radius_end) / 2); break;
            case LookShape::ball: icon.disc(part.from, 0, part.radius); break;
            case LookShape::ring: icon.disc(part.from, part.radius_end, part.radius); break;
            case LookShape::crook: add_crook(icon, part); break;
            case LookShape::cage: break;
        }
        part.from.x = -part.from.x;
        part.to.x = -part.to.x;
    }
}

}  // namespace

void add_wand_icon(render::Overlay& out, const WandLook& look, fvec2 middle, float size, fvec4 paint) {
    constexpr float diagonal = 0.8F;  // length of a wand with some margin (m)
    const Icon icon{out, look.flat, middle, 1.414F * size / diagonal, paint};
    icon.line({0, 0, -0.09}, {0, 0, 0.115}, 0.028);  // handle
    for (const auto& part : look.wand) add_part(icon, part);
}

void add_wand_strip(render::Overlay& out, const std::vector<WandPresentation>& wands, std::uint32_t in_hand,
                    fvec2 lower_right, float unit) {
    constexpr float step = 25, edge = 20;
    const auto count = static_cast<float>(wands.size());
    out.items.emplace_back(render::RectItem{lower_right - unit * fvec2(step * count + 4, 30), lower_right,
                                            colour(0x140E22, 0.62F), 8 * unit});
    const auto paint_of = [&](std::size_t i) {
        return i == in_hand ? colour(0xFFF4D0, 1.0F) : colour(0xB8A8CC, 0.75F);
    };
    const auto middle_of = [&](std::size_t i) {
        const auto before =
            std::count_if(wands.begin(), wands.end(), [&](const auto& w) { return w.slot < wands[i].slot; });
        const float x = step * (static_cast<float>(before) - count + 0.5F) - 2;
        return lower_right + unit * fvec2(x, -15);
    };
    // All shapes come before all words, because the renderer draws neighbours of one kind together.
    for (std::size_t i = 0; i < wands.size(); ++i)
        add_wand_icon(out, wands[i].look, middle_of(i), edge * unit, paint_of(i));
    for (std::size_t i = 0; i < wands.size(); ++i) {
        add_text(out, text(wands[i].slot + 1), middle_of(i) + unit * fvec2(8, 1), 10 * unit, paint_of(i),
                 render::Align::centre);
    }
}

}  // namespace thaum::game
