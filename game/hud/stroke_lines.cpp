#include "game/hud/stroke_lines.h"

#include <algorithm>

#include "game/hud/overlay.h"
#include "game/picture/force_colour.h"
#include "game/picture/stroke_pieces.h"
#include "gesture/generated_users.h"

namespace thaum::game::inline hud {
namespace {

constexpr std::size_t max_stroke_lines = 160;  // maximum number of lines that one stroke is drawn with
// Share of the path of a ghost (a gesture drawn faintly) at which the arrow stands
constexpr float ghost_start = 0.12F;

fvec2 on_screen(const StrokeFit& fit, vec3 at) {
    const vec3 from = fit.scale * (at - fit.middle);
    return fit.centre + fvec2(static_cast<float>(from.x), -static_cast<float>(from.y));
}

/// Adds an arrowhead at `to`, away from `from`.
void add_arrow(render::Overlay& out, fvec2 from, fvec2 to, float size, fvec4 colour) {
    const fvec2 way = to - from;
    if (glm::length(way) < 1e-3F) return;
    const fvec2 ahead = size * glm::normalize(way), aside(-ahead.y, ahead.x);
    out.items.push_back(render::TriangleItem{to + ahead, to - 0.7F * aside, to + 0.7F * aside, colour});
}

}  // namespace

StrokeFit fit_stroke(gesture::Points stroke, const Panel& box, double min_size) {
    if (stroke.empty()) return {.middle = vec3(0), .centre = 0.5F * (box.low + box.high)};
    vec3 low = stroke[0].at, high = low;
    for (const auto& p : stroke) {
        low = glm::min(low, p.at);
        high = glm::max(high, p.at);
    }
    const vec3 size = glm::max(high - low, vec3(min_size));
    const fvec2 room = box.high - box.low;
    return {.middle = 0.5 * (low + high),
            .centre = 0.5F * (box.low + box.high),
            .scale = std::min(static_cast<double>(room.x) / size.x, static_cast<double>(room.y) / size.y)};
}

void add_stroke(render::Overlay& out, gesture::Points stroke, const StrokeFit& fit, const StrokeLook& look) {
    const auto at = [&](std::size_t i) { return stroke[i].at; };
    each_piece(stroke.size(), max_stroke_lines, at, [&](std::size_t from, std::size_t to) {
        const double share = stroke[to].force / (2 * gesture::harsh_force);
        const fvec4 colour = look.by_force ? fvec4(force_colour(share), 1) : look.colour;
        out.items.push_back(
            render::LineItem{on_screen(fit, at(from)), on_screen(fit, at(to)), look.width, colour});
    });
}

void add_ghost(render::Overlay& out, gesture::Points stroke, const Panel& box, fvec4 colour, float width) {
    const auto fit = fit_stroke(stroke, box);
    add_stroke(out, stroke, fit, {.colour = colour, .width = width});
    if (stroke.size() < 3) return;
    const auto after =
        std::max<std::size_t>(1, static_cast<std::size_t>(ghost_start * static_cast<float>(stroke.size())));
    const fvec2 start = on_screen(fit, stroke.front().at);
    out.items.push_back(render::ArcItem{
        .centre = start, .inner = 0, .outer = 1.6F * width, .sweep = whole_turn, .colour = colour});
    add_arrow(out, on_screen(fit, stroke[after - 1].at), on_screen(fit, stroke[after].at), 3 * width, colour);
}

}  // namespace thaum::game::inline hud
