#include "game/hud/gesture_wall.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "game/hud/overlay.h"
#include "game/hud/stroke_lines.h"

namespace thaum::game::inline hud {
namespace {

// Sizes in HUD units.
constexpr float wall_name = 15, wall_spell = 12.5F, wall_line = 13.5F;  // text sizes (HUD units)
constexpr float wall_name_high = 20, wall_spell_high = 17;
constexpr float wall_lines_high = 5 * FittedWords::line_spacing * wall_line, wall_margin = 8, wall_inset = 5;
constexpr std::size_t wall_columns = 2;

/// Places of the gesture wall's parts: a cell for each gesture, to their right the panel with the player's
/// newest stroke, and below them text lines.
struct WallLayout {
    Panel box;
    fvec2 cell{};  ///< size of a cell (px)
    Panel stroke{};
    float lines_top{};  ///< top of the text lines (px)

    Panel cell_at(std::size_t i) const {
        const auto column = i % wall_columns, row = i / wall_columns;
        const fvec2 at(static_cast<float>(column), static_cast<float>(row));
        const fvec2 low = box.low + at * cell;
        return {low, low + cell};
    }
};

WallLayout lay_out_wall(const Panel& box, std::size_t gestures, float u) {
    WallLayout l{.box = {box.low + wall_margin * u, box.high - wall_margin * u}};
    const auto rows = std::max<std::size_t>(1, (gestures + wall_columns - 1) / wall_columns);
    const fvec2 room = l.box.high - l.box.low;
    const float lines = wall_lines_high * u;
    l.lines_top = l.box.high.y - lines;
    l.cell = {room.x / (wall_columns + 1), std::max(0.0F, room.y - lines) / static_cast<float>(rows)};
    l.stroke = {{l.box.low.x + wall_columns * l.cell.x, l.box.low.y}, {l.box.high.x, l.lines_top}};
    return l;
}

/// Adds the score of a gesture, how well the last stroke that was read as it fits (%), at the right end of
/// its cell's title. Only the score of the newest stroke is bright.
void add_cell_score(render::Overlay& out, const Panel& title, int score, bool newest, float u) {
    const fvec4 paint = newest ? paints.white : opaque(fvec3(paints.soft), 0.35F);
    add_text_in(out, title, text(score, " %"), wall_name * u, paint, render::Align::right);
}

Panel inset_by(const Panel& box, float by) { return {box.low + by, box.high - by}; }
bool has_room(const Panel& box) { return box.high.x > box.low.x && box.high.y > box.low.y; }

void add_cell(render::Overlay& out, const GestureWallPicture& wall, std::size_t i, const Panel& cell,
              float u) {
    const auto& g = (*wall.gestures)[i];
    const bool chosen = static_cast<int>(i) == wall.chosen;
    if (chosen)
        out.items.emplace_back(
            render::RectItem{cell.low, cell.high, opaque(fvec3(paints.white), 0.14F), 8 * u});
    const auto inner = inset_by(cell, wall_inset * u);
    const int score = i < wall.scores.size() ? wall.scores[i] : -1;
    const float split = inner.high.x - (score >= 0 ? width_of("100 %", wall_name * u) : 0);
    const float below_name = inner.low.y + wall_name_high * u;
    if (score >= 0) add_cell_score(out, {{split, inner.low.y}, {inner.high.x, below_name}}, score, chosen, u);
    const Panel words{inner.low, {split, below_name}};
    add_text_in(out, words, g.name, wall_name * u, chosen ? paints.white : paints.soft, render::Align::left);
    const Panel spell{{inner.low.x, below_name}, {inner.high.x, below_name + wall_spell_high * u}};
    const auto* yours = g.spell.empty() ? "yours" : ", yours";
    add_text_in(out, spell, text(g.spell, g.own ? yours : ""), wall_spell * u, paints.soft,
                render::Align::left);
    const auto ghost = inset_by({{inner.low.x, spell.high.y}, inner.high}, wall_inset * u);
    if (!has_room(ghost)) return;
    add_ghost(out, g.ghost, ghost, opaque(fvec3(paints.soft), chosen ? 0.55F : 0.35F), 3 * u);
    if (chosen && !wall.drawing && !wall.stroke.empty())
        add_stroke(out, wall.stroke, fit_stroke(wall.stroke, ghost), {.width = 3.5F * u, .by_force = true});
}

/// Adds the player's newest stroke in its own panel, with the title "Your stroke".
void add_own_panel(render::Overlay& out, const GestureWallPicture& wall, const Panel& box, float u) {
    constexpr double min_drawn = 0.1;  // strokes smaller than this are not enlarged while they are drawn (m)
    out.items.emplace_back(render::RectItem{box.low, box.high, opaque(fvec3(paints.white), 0.06F), 8 * u});
    const auto inner = inset_by(box, wall_inset * u);
    const float below_title = inner.low.y + wall_name_high * u;
    add_text_in(out, {inner.low, {inner.high.x, below_title}}, "Your stroke", wall_name * u, paints.soft,
                render::Align::left);
    const auto room = inset_by({{inner.low.x, below_title}, inner.high}, wall_inset * u);
    if (wall.stroke.empty() || !has_room(room)) return;
    add_stroke(out, wall.stroke, fit_stroke(wall.stroke, room, wall.drawing ? min_drawn : 0.02),
               {.width = 4 * u, .by_force = true});
}

/// Adds lines from the top of a box downwards, as many as are readable. Long lines are broken.
void add_wall_lines(render::Overlay& out, const std::vector<std::string>& lines, Panel box, float u) {
    const float size = std::floor(wall_line * u);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const fvec2 room = box.high - box.low;
        if (i > 0 && room.y < FittedWords::line_spacing * size) return;
        const auto words = fit(lines[i], size, room);
        add_text_in(out, box, lines[i], size, i == 0 ? paints.white : paints.soft, render::Align::left);
        box.low.y += words.height();
    }
}

}  // namespace

void add_gesture_wall(render::Overlay& out, const GestureWallPicture& wall,
                      const std::vector<std::string>& lines, const Panel& box, float unit) {
    if (!wall.on || !wall.gestures) return;
    constexpr float min_high = 260;  // height below which the gesture wall is scaled down (HUD units)
    unit = std::min(unit, (box.high.y - box.low.y) / min_high);
    const auto l = lay_out_wall(box, wall.gestures->size(), unit);
    out.items.emplace_back(render::RectItem{box.low, box.high, paints.plate, 12 * unit});
    for (std::size_t i = 0; i < wall.gestures->size(); ++i) add_cell(out, wall, i, l.cell_at(i), unit);
    add_own_panel(out, wall, l.stroke, unit);
    add_wall_lines(out, lines, {{l.box.low.x, l.lines_top + wall_inset * unit}, l.box.high}, unit);
}

}  // namespace thaum::game::inline hud
