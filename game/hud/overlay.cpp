#include "game/hud/overlay.h"

#include <algorithm>
#include <cmath>

#include "game/data/teams.h"

namespace thaum::game::inline hud {

using render::Align;
using render::Overlay;
using render::RectItem;

void add_text(Overlay& out, std::string words, fvec2 position, float size, fvec4 paint, Align align) {
    const float shift = std::max(1.0F, size / 14);
    out.items.emplace_back(render::TextItem{words, position + fvec2(shift), size,
                                            fvec4(fvec3(paints.dark), 0.8F * paint.a), align});
    out.items.emplace_back(render::TextItem{std::move(words), position, size, paint, align});
}

void add_text_in(Overlay& out, const Panel& box, std::string_view words, float size, fvec4 paint,
                 Align align) {
    const auto fitted = fit(words, size, box.high - box.low);
    const float x = align == Align::left    ? box.low.x
                    : align == Align::right ? box.high.x
                                            : (box.low.x + box.high.x) / 2;
    float y = box.low.y;
    for (const auto& line : fitted.lines) {
        add_text(out, line, {x, y}, fitted.size, paint, align);
        y += fitted.line_height();
    }
}

void add_text_on_plate(Overlay& out, const Panel& box, std::string_view words, float size, fvec4 paint,
                       Align align) {
    const float inset = 0.3F * size;
    const Panel inner{box.low + fvec2(inset, 0), box.high - fvec2(inset, 0)};
    const auto fitted = fit(words, size, inner.high - inner.low);
    float wide = 0;
    for (const auto& line : fitted.lines) wide = std::max(wide, width_of(line, fitted.size));
    const float whole = box.high.x - box.low.x;
    wide = std::min(wide + 2 * inset, whole);
    const float left = align == Align::left    ? box.low.x
                       : align == Align::right ? box.high.x - wide
                                               : box.low.x + (whole - wide) / 2;
    const float high = std::min(fitted.height(), box.high.y - box.low.y);
    if (!words.empty())
        out.items.emplace_back(
            RectItem{{left, box.low.y}, {left + wide, box.low.y + high}, paints.plate, 0.3F * fitted.size});
    add_text_in(out, inner, words, size, paint, align);
}

void add_plate(Overlay& out, const Panel& box, float top, const FittedWords& words, fvec4 paint) {
    const float middle = (box.low.x + box.high.x) / 2;
    float half = 0;
    for (const auto& line : words.lines) half = std::max(half, width_of(line, words.size) / 2);
    half = std::min(half + words.size / 2, (box.high.x - box.low.x) / 2);
    auto plate = paints.plate;
    plate.a *= paint.a;
    out.items.emplace_back(render::RectItem{
        {middle - half, top}, {middle + half, top + words.height()}, plate, 0.4F * words.size});
    for (const auto& line : words.lines) {
        add_text(out, line, {middle, top + 0.05F * words.size}, words.size, paint, Align::centre);
        top += words.line_height();
    }
}

void add_mark(Overlay& out, std::uint32_t team, fvec2 centre, float radius) {
    const auto paint = opaque(team_colours(team).light);
    if (team == 0) {
        out.items.emplace_back(render::ArcItem{centre, 0.58F * radius, radius, 0, whole_turn, paint});
        return;
    }
    const auto corner = [&](int i) {
        const float angle = whole_turn / 3 * static_cast<float>(i);
        return centre + 1.15F * radius * fvec2(std::sin(angle), -std::cos(angle)) + fvec2(0, 0.12F * radius);
    };
    out.items.emplace_back(render::TriangleItem{corner(0), corner(1), corner(2), paint});
}

void add_veil(Overlay& out, const render::Rect& r, fvec4 paint) {
    const fvec2 low(static_cast<float>(r.x), static_cast<float>(r.y));
    const fvec2 size(static_cast<float>(r.width), static_cast<float>(r.height));
    out.items.emplace_back(render::RectItem{low, low + size, paint, 0});
}

}  // namespace thaum::game::inline hud
