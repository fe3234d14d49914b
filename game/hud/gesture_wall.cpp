#include "game/hud/gesture_wall.h"

#include <algorithm>

#include "core/text.h"
#include "game/hud/overlay.h"
#include "game/hud/stroke_picture.h"

namespace thaum::game {
namespace {

constexpr float wall_name_high = 19, wall_line_high = 19, wall_margin = 8;  // units
constexpr std::size_t wall_columns = 2;

/// Boxes of the cells and of the lines below them.
struct WallLayout {
    Panel box;
    std::size_t rows{};
    fvec2 cell{};  ///< size of a cell (px)
    float lines_top{};

    Panel cell_at(std::size_t i) const {
        const auto column = i % wall_columns, row = i / wall_columns;
        const fvec2 at(static_cast<float>(column), static_cast<float>(row));
        const fvec2 low = box.low + at * cell;
        return {low, low + cell};
    }
};

WallLayout lay_out_wall(const Panel& box, std::size_t gestures, float u) {
    WallLayout l{.box = {box.low + wall_margin * u, box.high - wall_margin * u},
                 .rows = std::max<std::size_t>(1, (gestures + wall_columns - 1) / wall_columns)};
    const fvec2 room = l.box.high - l.box.low;
    const float lines = 4 * wall_line_high * u;
    l.cell = {room.x / static_cast<float>(wall_columns),
              std::max(0.0F, room.y - lines) / static_cast<float>(l.rows)};
    l.lines_top = l.box.high.y - lines;
    return l;
}

std::string title_of(const GestureWallPicture& wall, std::size_t i) {
    const auto& g = (*wall.gestures)[i];
    const int score = i < wall.scores.size() ? wall.scores[i] : -1;
    return text(g.name, g.spell.empty() ? "" : ": ", g.spell, g.own ? " (yours)" : "",
                score >= 0 ? text(" ", score, " %") : std::string());
}

void add_cell(render::Overlay& out, const GestureWallPicture& wall, std::size_t i, const Panel& cell,
              float u) {
    const auto& g = (*wall.gestures)[i];
    const bool chosen = static_cast<int>(i) == wall.chosen;
    const float inset = 3 * u;
    if (chosen)
        out.items.emplace_back(
            render::RectItem{cell.low + inset, cell.high - inset, opaque(fvec3(paints.white), 0.14F), 8 * u});
    const Panel name{cell.low + 2 * inset,
                     {cell.high.x - 2 * inset, cell.low.y + 2 * inset + wall_name_high * u}};
    add_text_in(out, name, title_of(wall, i), 15 * u, chosen ? paints.white : paints.soft,
                render::Align::left);
    const Panel ghost{{cell.low.x + 5 * inset, name.high.y + inset}, cell.high - 5 * inset};
    if (ghost.high.x <= ghost.low.x || ghost.high.y <= ghost.low.y) return;
    add_ghost(out, g.ghost, ghost, opaque(fvec3(paints.soft), chosen ? 0.55F : 0.35F), 3 * u);
    if (chosen && !wall.stroke.empty())
        add_stroke(out, wall.stroke, fit_stroke(wall.stroke, ghost), {.width = 3.5F * u, .by_force = true});
}

}  // namespace

void add_gesture_wall(render::Overlay& out, const GestureWallPicture& wall, const Panel& box, float unit) {
    if (!wall.on || !wall.gestures) return;
    constexpr float least_high = 240;  // units
    unit = std::min(unit, (box.high.y - box.low.y) / least_high);
    const auto l = lay_out_wall(box, wall.gestures->size(), unit);
    out.items.emplace_back(render::RectItem{box.low, box.high, paints.plate, 12 * unit});
    for (std::size_t i = 0; i < wall.gestures->size(); ++i) add_cell(out, wall, i, l.cell_at(i), unit);
    // A stroke that is being drawn belongs to no gesture yet: it stands in the middle of the wall.
    if (wall.drawing && !wall.stroke.empty())
        add_stroke(out, wall.stroke, fit_stroke(wall.stroke, {l.box.low, {l.box.high.x, l.lines_top}}, 0.1),
                   {.width = 5 * unit, .by_force = true});
    float top = l.lines_top;
    for (std::size_t i = 0; i < wall.lines.size() && i < 4; ++i) {
        add_text_in(out, {{l.box.low.x, top}, {l.box.high.x, top + wall_line_high * unit}}, wall.lines[i],
                    15 * unit, i == 0 ? paints.white : paints.soft, render::Align::left);
        top += wall_line_high * unit;
    }
}

}  // namespace thaum::game
