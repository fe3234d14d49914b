#include "game/hud/body_figure.h"

#include <algorithm>
#include <cmath>

namespace thaum::game::inline hud {

using render::Align;
using render::ArcItem;
using render::RectItem;

void add_figure(render::Overlay& out, const Panel& panel, const std::array<float, figure_cells>& felt) {
    constexpr float columns = 4, rows = 5, inset = 3, label = 9;
    const float u = (panel.high.x - panel.low.x) / figure_wide;
    if (!(u > 0)) return;
    out.items.emplace_back(RectItem{panel.low, panel.high, fvec4(fvec3(paints.panel), 0.9F), 4 * u});
    const float torso = (figure_wide - 3 * inset) / 2;
    const fvec2 cell = fvec2(torso / columns, (figure_high - 2 * inset - label) / rows);
    for (std::size_t i = 0; i < figure_cells; ++i) {
        const bool back = i >= figure_cells / 2;
        const auto in_side = static_cast<float>(i % (figure_cells / 2));
        const float row = std::floor(in_side / columns), column = in_side - row * columns;
        const fvec2 corner(inset + (back ? torso + inset : 0), inset);
        const fvec2 middle = panel.low + u * (corner + cell * fvec2(column + 0.5F, row + 0.5F));
        const float most = 0.5F * u * std::min(cell.x, cell.y);
        out.items.emplace_back(
            ArcItem{middle, 0, 0.3F * most, 0, whole_turn, fvec4(fvec3(paints.soft), 0.4F)});
        if (felt.at(i) > 0.01F)
            out.items.emplace_back(ArcItem{middle, 0, most * (0.45F + 0.55F * std::min(1.0F, felt.at(i))), 0,
                                           whole_turn, paints.white});
    }
    if (8 * u < 6) return;  // the words "front" and "back" would be too small to be readable
    for (const bool back : {false, true}) {
        const fvec2 low =
            panel.low + u * fvec2(inset + (back ? torso + inset : 0), figure_high - inset - label);
        add_text_in(out, {low, low + u * fvec2(torso, label)}, back ? "back" : "front", 8 * u, paints.soft,
                    Align::centre);
    }
}

}  // namespace thaum::game::inline hud
