#include "game/hud/casting_overlay.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "game/data/casting_rules.h"
#include "game/data/teams.h"
#include "game/hud/likely_spell.h"
#include "game/hud/overlay.h"
#include "game/hud/wand_icon.h"
#include "game/picture/stroke_pieces.h"

namespace thaum::game::inline hud {
namespace {

using render::Align;
using render::ArcItem;
using render::colour;
using render::LineItem;
using render::Overlay;
using render::RectItem;

const fvec4 focus_paint = colour(0xC8A4FF, 1.0F);
const fvec4 ward_paint = colour(0x9AF0E0, 1.0F);
const fvec4 read_paint = colour(0x7CFF9A, 1.0F);
const fvec4 grey_paint = colour(0xA8A4B0, 1.0F);

// ---- The stroke -------------------------------------------------------------------------------------------

/// Share of the view's shorter edge that a drawn stroke of the usual size (`usual_size`) fills, and largest
/// share that any stroke fills.
constexpr float usual_share = 0.34F, max_share = 0.66F;
constexpr float usual_size = 0.08F;  // usual extent of the path that a hand draws (m)
constexpr std::size_t max_stroke_pieces = 160;

/// Maps points of a stroke to the view. A stroke begins at the crosshair. It is moved and scaled down as far
/// as it needs to stay in the panel for strokes.
struct Drawing {
    fvec2 centre{}, shift{};
    float scale{};  ///< scale of the drawing (px/m)

    fvec2 at(const DrawnPoint& p) const { return centre + scale * (fvec2(p.x, -p.y) - shift); }
};

Drawing drawing_of(const StrokePicture& stroke, const ViewLayout& l) {
    const auto edge = static_cast<float>(std::min(l.view.width, l.view.height));
    fvec2 low(stroke.points[0].x, -stroke.points[0].y), high = low;
    for (std::uint32_t i = 1; i < stroke.count; ++i) {
        const fvec2 p(stroke.points[i].x, -stroke.points[i].y);
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    Drawing drawing{.centre = l.centre,
                    .shift = fvec2(stroke.points[0].x, -stroke.points[0].y),
                    .scale = usual_share * edge / usual_size};
    const float glow = 6 * l.unit, most = max_share * edge / 2;  // width of the glow, and largest half size
                                                                 // of a stroke (px)
    const fvec2 before = glm::min(l.centre - l.strokes.low - glow, fvec2(most)),
                after = glm::min(l.strokes.high - l.centre - glow, fvec2(most)), room = before + after;
    const fvec2 extent = glm::max(high - low, fvec2(1e-6F));
    drawing.scale = std::min({drawing.scale, room.x / extent.x, room.y / extent.y});
    const fvec2 least = high - after / drawing.scale;
    drawing.shift = glm::clamp(drawing.shift, least, glm::max(low + before / drawing.scale, least));
    return drawing;
}

/// Force at a point of a stroke, relative to the force from which on strokes are harsh, 0 to 1.5.
float share_of(const CastingPicture& casting, float force) {
    const double harsh = std::max(casting.rules->harsh_from, 1e-6);
    return static_cast<float>(std::clamp(static_cast<double>(force) / harsh, 0.0, 1.5));
}

/// Colour of a piece of the stroke. `share`: force at that piece (share_of).
fvec4 paint_of(const StrokePicture& stroke, std::uint32_t player, float share) {
    if (!stroke.drawing && !stroke.read) return grey_paint;
    if (!stroke.drawing) return read_paint;
    const fvec3 team = fvec3(opaque(team_colours(player).light));
    return opaque(glm::mix(team, fvec3(1), std::min(0.85F, 0.5F * share)));
}

/// Whether a piece of a stroke's line is left out. The line of a finished stroke that was not recognised
/// breaks up: its gaps grow with its age.
bool is_broken(const StrokePicture& stroke, std::uint32_t piece, float age) {
    constexpr std::uint32_t length = 6;
    return !stroke.drawing && !stroke.read && static_cast<float>(piece % length) < 2 + 4 * age;
}

/// Adds a small picture of a gesture: its first recorded stroke, with a dot at its beginning.
void add_gesture_icon(Overlay& out, const gesture::Gesture& gesture, fvec2 middle, float size, fvec4 paint) {
    constexpr std::size_t pieces = 28;
    if (gesture.strokes.empty() || gesture.strokes[0].size() < 2) return;
    const auto& points = gesture.strokes[0];
    const auto flat = [](const gesture::StrokePoint& p) { return fvec2(vec2(p.at.x, -p.at.y)); };
    fvec2 low = flat(points[0]), high = low;
    for (const auto& p : points) {
        low = glm::min(low, flat(p));
        high = glm::max(high, flat(p));
    }
    const float scale = size / std::max({high.x - low.x, high.y - low.y, 1e-6F});
    const auto at = [&](std::size_t piece) {
        return middle + scale * (flat(points[piece * (points.size() - 1) / pieces]) - (low + high) / 2.0F);
    };
    const float width = std::max(1.5F, 0.08F * size);
    for (std::size_t i = 0; i < pieces; ++i) out.items.emplace_back(LineItem{at(i), at(i + 1), width, paint});
    out.items.emplace_back(ArcItem{at(0), 0, 1.4F * width, 0, whole_turn, paint});
}

/// Shows the spell that the unfinished stroke will probably cast: its gesture and name, in the panel for
/// them.
void add_likely(Overlay& out, const CastingPicture& casting, const SpellPresentation& spell,
                const ViewLayout& l) {
    const auto number = casting.gestures->number(spell.gesture);
    const auto& box = l.likely;
    const float high = box.high.y - box.low.y;
    if (!number || !(high > 0)) return;
    const float inset = 5 * l.unit, icon = high - inset;
    const float room = box.high.x - box.low.x - icon - 3 * inset;
    const auto words = fit(spell.shown, 13 * l.unit, {room, high});
    const float wide = std::min(room, width_of(spell.shown, words.size));
    const fvec2 middle = (box.low + box.high) / 2.0F, half(0.5F * (icon + wide + 3 * inset), high / 2);
    out.items.emplace_back(RectItem{middle - half, middle + half, paints.plate, inset});
    const float left = middle.x - half.x + inset;
    add_gesture_icon(out, casting.gestures->gestures()[*number], {left + icon / 2, middle.y}, 0.8F * icon,
                     opaque(colour(spell.colour, 1)));
    const fvec2 corner(left + icon + inset, middle.y - words.height() / 2);
    add_text_in(out, {corner, corner + fvec2(room, words.height() + 1)}, spell.shown, words.size,
                paints.white, Align::left);
}

}  // namespace

void add_stroke(Overlay& out, const CastingPicture& casting, const Presentation& shown, std::uint32_t player,
                const ViewLayout& l) {
    const auto& stroke = casting.stroke;
    if (stroke.count < 2 || stroke.on_brew) return;
    const auto drawing = drawing_of(stroke, l);
    const auto age = static_cast<float>(stroke.since_end_s / stroke_fade_seconds);
    const float left = std::clamp(1 - age, 0.0F, 1.0F);
    // A larger text scale makes lines wider, but not so wide that they fill a small view.
    const float u = std::min(l.unit, static_cast<float>(std::min(l.view.width, l.view.height)) / 280);
    const auto* likely = likely_spell(casting, shown);
    if (likely != nullptr) add_likely(out, casting, *likely, l);
    const auto at = [&](std::size_t i) { return drawing.at(stroke.points[i]); };
    const auto add = [&](float widen, float alpha) {
        std::uint32_t piece = 0;
        each_piece(stroke.count, max_stroke_pieces, at, [&](std::size_t from, std::size_t to) {
            if (is_broken(stroke, ++piece, age)) return;
            const float share = share_of(casting, stroke.points[to].force);
            auto paint = widen > 0 && likely != nullptr ? colour(likely->colour, 1)
                                                        : paint_of(stroke, player, widen > 0 ? 0 : share);
            paint.a = alpha * left;
            const float width = widen + std::max(2.0F, (1.8F + 3.6F * share) * u);
            out.items.emplace_back(LineItem{at(from), at(to), width, paint});
        });
    };
    add(7 * u, likely != nullptr ? 0.6F : 0.25F);
    add(0, 0.95F);
    if (stroke.drawing)
        out.items.emplace_back(
            ArcItem{drawing.at(stroke.points[stroke.count - 1]), 0, 4.5F * u, 0, whole_turn, paints.white});
}

void add_free_trail(Overlay& out, const CastingPicture& casting, std::uint32_t player, const ViewLayout& l) {
    const auto& free = casting.free;
    if (free.count < 2 || casting.stroke.drawing) return;
    const auto edge = static_cast<float>(std::min(l.view.width, l.view.height));
    const auto& newest = free.trail[free.count - 1];
    const auto at = [&](fvec3 p) {
        const fvec2 way = usual_share * edge / usual_size * fvec2(p.x - newest.x, newest.y - p.y);
        const float most = max_share * edge / 2;
        return l.centre + glm::clamp(way, fvec2(-most), fvec2(most));
    };
    const auto paint = team_colours(player).light;
    for (std::uint32_t i = 1; i < free.count; ++i) {
        const float age = 1 - static_cast<float>(i) / static_cast<float>(free.count - 1);
        out.items.emplace_back(LineItem{at(free.trail[i - 1]), at(free.trail[i]),
                                        std::max(1.5F, 1.5F * l.unit), opaque(paint, 0.4F * (1 - age))});
    }
}

void add_force_band(Overlay& out, const CastingPicture& casting, const ViewLayout& l) {
    const auto& stroke = casting.stroke;
    if (!stroke.drawing || stroke.curve) return;
    const auto& rules = *casting.rules;
    const float half = 0.72F * l.ring, high = 0.12F * l.ring;
    const fvec2 low(l.centre.x - half, l.centre.y - 0.58F * l.ring);
    const double most = 1.6 * rules.harsh_from;
    const auto x_of = [&](double force) {
        return low.x + 2 * half * static_cast<float>(std::clamp(force / std::max(most, 1e-6), 0.0, 1.0));
    };
    const auto zone = [&](double from, double to, fvec4 paint) {
        out.items.emplace_back(RectItem{{x_of(from), low.y}, {x_of(to), low.y + high}, paint, 0});
    };
    out.items.emplace_back(
        RectItem{low - fvec2(2), {low.x + 2 * half + 2, low.y + high + 2}, paints.dark, 2});
    zone(0, rules.gentle_below, colour(0x4A7AD8, 0.9F));
    zone(rules.gentle_below, rules.harsh_from, colour(0x6A6078, 0.9F));
    zone(rules.harsh_from, most, colour(0xE0762C, 0.9F));
    const auto needle = [&](double force, float more, float width, fvec4 paint) {
        const float x = x_of(force);
        out.items.emplace_back(LineItem{{x, low.y - more}, {x, low.y + high + more}, width, paint});
    };
    needle(stroke.force_now, 0, std::max(1.5F, l.unit), paints.soft);
    needle(stroke.force_mean, 0.5F * high, std::max(4.0F, 3 * l.unit), paints.dark);
    needle(stroke.force_mean, 0.5F * high, std::max(2.0F, 1.6F * l.unit), paints.white);
    add_text_in(out, {{low.x, low.y - 0.4F * l.ring}, {low.x + 2 * half, low.y - 0.02F * l.ring}},
                force_word(rules, stroke.force_mean), std::min(12 * l.unit, 0.28F * l.ring), paints.white,
                Align::centre);
}

void add_fog_veil(Overlay& out, const Picture& picture, std::uint32_t player, const ViewLayout& l) {
    double dense = 0;
    for (const auto& fog : picture.fogs) {
        const double inside = fog.radius - glm::distance(fog.place, picture.wizards[player].vitals.eye);
        dense = std::max(dense, fog.strength * std::clamp(inside / std::max(fog.sight, 1e-3), 0.0, 1.0));
    }
    if (dense > 0) add_veil(out, l.view, colour(0x8C86A0, static_cast<float>(0.86 * dense)));
}

void add_ward(Overlay& out, const CastingPicture& casting, const ViewLayout& l) {
    if (!(casting.ward > 0) && casting.since_flash_s > flash_apart_seconds) return;
    const auto flash =
        static_cast<float>(std::clamp(1 - casting.since_flash_s / flash_apart_seconds, 0.0, 1.0));
    const auto half = 1.1F * static_cast<float>(casting.ward_share);
    for (const float middle : {0.25F * whole_turn, 0.75F * whole_turn}) {
        const auto arc = [&](float inner, float outer, float most, fvec4 paint) {
            if (most > 0)
                out.items.emplace_back(
                    ArcItem{l.centre, inner * l.ring, outer * l.ring, middle - most, 2 * most, paint});
        };
        arc(0.74F, 0.84F, 1.14F, fvec4(fvec3(paints.dark), 0.25F));
        arc(0.76F, 0.82F, half, fvec4(fvec3(ward_paint), 0.6F + 0.4F * flash));
    }
}

// ---- Focus and spells -------------------------------------------------------------------------------------

void add_focus(Overlay& out, const CastingPicture& casting, fvec2 centre, float u) {
    constexpr float start = -2.3561945F, sweep = 4.712389F;  // the same angles as the arc for the health
                                                             // (rad)
    const double cap = std::max(casting.focus_cap, 1e-6);
    const auto share = static_cast<float>(std::clamp(casting.focus / cap, 0.0, 1.0));
    out.items.emplace_back(ArcItem{centre, 21.5F * u, 26 * u, start, sweep, paints.track});
    if (share > 0)
        out.items.emplace_back(ArcItem{centre, 22 * u, 25.5F * u, start, share * sweep, focus_paint});
    const fvec2 star = centre + u * fvec2(-11, 14.5F);
    for (const fvec2 way : {fvec2(4, 0), fvec2(0, 4)}) {
        const fvec2 side = 0.4F * fvec2(way.y, way.x);
        out.items.emplace_back(
            render::TriangleItem{star - u * way, star - u * side, star + u * side, focus_paint});
        out.items.emplace_back(
            render::TriangleItem{star + u * way, star - u * side, star + u * side, focus_paint});
    }
    add_text(out, text(static_cast<int>(std::floor(casting.focus))), centre + u * fvec2(4, 8), 11 * u,
             focus_paint, Align::centre);
}

namespace {

/// One cell of the strip of spells.
struct SpellCell {
    Panel box;
    float u{};
    const SpellPresentation& spell;
    bool affordable{};

    fvec4 paint() const { return affordable ? paints.chosen : colour(0x8C8498, 0.75F); }
};

void add_shapes(Overlay& out, const SpellCell& cell, const GestureSet& gestures) {
    const float middle = (cell.box.low.x + cell.box.high.x) / 2, top = cell.box.low.y;
    const auto number = gestures.number(cell.spell.gesture);
    if (number)
        add_gesture_icon(out, gestures.gestures()[*number], {middle, top + 15 * cell.u}, 16 * cell.u,
                         cell.paint());
    if (!cell.affordable)
        out.items.emplace_back(LineItem{{middle - 11 * cell.u, top + 26 * cell.u},
                                        {middle + 11 * cell.u, top + 4 * cell.u},
                                        std::max(1.5F, 1.5F * cell.u),
                                        paints.light_red});
}

/// Adds the words of a cell: the key that casts the spell, the cost, and the spell's name below the gesture.
void add_words(Overlay& out, const SpellCell& cell, std::string_view key) {
    const fvec2 low = cell.box.low, high = cell.box.high;
    const float u = cell.u, side = 13 * u;
    const auto cost = cell.affordable ? focus_paint : paints.light_red;
    add_text_in(out, {low + fvec2(2 * u, u), {low.x + 2 * u + side, low.y + 15 * u}}, key, 10 * u,
                cell.paint(), Align::left);
    add_text_in(out, {{high.x - 2 * u - side, low.y + u}, {high.x - 2 * u, low.y + 15 * u}},
                text(static_cast<int>(std::lround(cell.spell.focus))), 10 * u, cost, Align::right);
    add_text_in(out, {{low.x + u, low.y + 26 * u}, {high.x - u, high.y}}, cell.spell.shown, 11 * u,
                cell.paint(), Align::centre);
}

/// Cells for the spells, in as many rows as the strip of wands has, and as wide as the room allows.
std::vector<SpellCell> cells_of(const Picture& picture, std::uint32_t player, const ViewLayout& l, float u) {
    constexpr float widest = 56;  // largest width of a cell (HUD units)
    std::vector<const SpellPresentation*> spells;
    for (const auto& spell : picture.shown->spells) spells.push_back(&spell);
    std::sort(spells.begin(), spells.end(), [](const auto* a, const auto* b) { return a->slot < b->slot; });
    const auto rows = std::max(1.0F, std::floor((l.strip.high.y - l.strip.low.y) / u / strip_cell_height));
    const auto columns = static_cast<std::size_t>(std::ceil(static_cast<float>(spells.size()) / rows));
    const float room = l.strip_columns * strip_cell_width;
    const float wide = std::min(widest, room / static_cast<float>(std::max<std::size_t>(columns, 1)));
    std::vector<SpellCell> cells;
    for (std::size_t i = 0; i < spells.size(); ++i) {
        const auto column = i % columns, row = i / columns;
        const fvec2 at(static_cast<float>(column) * wide, static_cast<float>(row) * strip_cell_height);
        const fvec2 low = l.strip.low + u * (fvec2(strip_margin, strip_head - 1) + at);
        cells.push_back({{low, low + u * fvec2(wide, strip_cell_height)},
                         u,
                         *spells[i],
                         picture.wizards[player].casting.focus >= spells[i]->focus});
    }
    return cells;
}

}  // namespace

void add_spell_strip(Overlay& out, const Picture& picture, const ControlNames& controls, std::uint32_t player,
                     const ViewLayout& l) {
    const auto& casting = picture.wizards[player].casting;
    const auto& strip = l.strip;
    const float u = strip_unit(l);
    out.items.emplace_back(RectItem{strip.low, strip.high, paints.panel, 8 * u});
    const auto cells = cells_of(picture, player, l, u);
    for (const auto& cell : cells) add_shapes(out, cell, *casting.gestures);
    for (const auto& cell : cells) {
        const bool has_key = cell.spell.slot < controls.wands.size();
        add_words(out, cell, has_key ? brief_label(controls.wands[cell.spell.slot]) : std::string());
    }
    const float middle = strip.low.x + 0.56F * (strip.high.x - strip.low.x);
    const float low = strip.low.y + 2 * u, high = strip.low.y + u * strip_head;
    add_text_in(out, {{strip.low.x + 8 * u, low}, {middle, high}},
                text("Focus ", static_cast<int>(std::floor(casting.focus))), 14 * u, focus_paint,
                Align::left);
    const auto& fast = casting.rules->harsh_cost;
    add_text_in(out, {{middle, low}, {strip.high.x - 8 * u, high}}, text("harsh x", fixed(fast, 1)), 12 * u,
                paints.soft, Align::right);
}

}  // namespace thaum::game::inline hud
