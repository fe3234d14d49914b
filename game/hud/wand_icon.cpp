#include "game/hud/wand_icon.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/text.h"
#include "game/hud/overlay.h"
#include "render/colour.h"

namespace thaum::game::inline hud {
namespace {

using render::ArcItem;
using render::colour;
using render::LineItem;

/// Projection of a wand onto the picture.
struct Icon {
    render::Overlay& out;
    bool flat{};     ///< true: the picture shows the wand's x-z plane; false: its y-z plane
    fvec2 middle{};  ///< position of the middle (px)
    float scale{};   ///< scale of the picture (px/m)
    fvec4 paint{};

    fvec2 at(vec3 p) const {
        constexpr float half_way = 0.2F;  // z coordinate shown at the icon's middle (m)
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

/// Adds the bar of a wand's energy, amber below a fifth. A `share` of 0 means too little energy for one use.
/// A bar that is being refilled has a light edge.
void add_charge(render::Overlay& out, const Panel& bar, double share, bool refilled, fvec4 full) {
    constexpr double low = 0.2;
    const float corner = (bar.high.y - bar.low.y) / 3,
                filled = static_cast<float>(std::clamp(share, 0.0, 1.0));
    if (refilled) {
        const fvec2 edge((bar.high.y - bar.low.y) / 4);
        out.items.emplace_back(
            render::RectItem{bar.low - edge, bar.high + edge, paints.white, corner + edge.x});
    }
    out.items.emplace_back(render::RectItem{bar.low, bar.high, paints.track, corner});
    const float middle = (bar.low.y + bar.high.y) / 2;
    if (share <= 0) {
        out.items.emplace_back(
            LineItem{{bar.low.x, middle}, {bar.high.x, middle}, std::max(1.0F, corner), paints.red});
        return;
    }
    const fvec2 end(bar.low.x + filled * (bar.high.x - bar.low.x), bar.high.y);
    out.items.emplace_back(render::RectItem{bar.low, end, share < low ? paints.amber : full, corner});
}

/// Index of the wand in the slot after that of `in_hand`; after the last slot comes the first.
std::size_t next_in_slots(const std::vector<WandPresentation>& wands, std::size_t in_hand) {
    if (in_hand >= wands.size()) return wands.size();
    const auto ahead = [&](const WandPresentation& w) {
        return w.slot - wands[in_hand].slot - 1;
    };  // unsigned: slots before the present one count as far ahead, so the search wraps round
    const auto next = std::min_element(wands.begin(), wands.end(),
                                       [&](const auto& a, const auto& b) { return ahead(a) < ahead(b); });
    return static_cast<std::size_t>(next - wands.begin());
}

/// Short labels of controls for which the first letters of their words, which brief_label takes, would be
/// unclear.
constexpr std::array<std::pair<std::string_view, std::string_view>, 31> short_labels{{
    {"Comma", ","},        {"Period", "."},         {"Minus", "-"},           {"Equal", "="},
    {"Slash", "/"},        {"Backslash", "\\"},     {"Semicolon", ";"},       {"Apostrophe", "'"},
    {"Grave", "`"},        {"Left bracket", "["},   {"Right bracket", "]"},   {"World1", "W1"},
    {"World2", "W2"},      {"Space", "Spc"},        {"Left", "Lft"},          {"Right", "Rgt"},
    {"Down", "Dwn"},       {"Print screen", "Prt"}, {"Page up", "PgU"},       {"Page down", "PgD"},
    {"Backspace", "Bsp"},  {"Caps lock", "Cap"},    {"Scroll lock", "Scr"},   {"Num lock", "Num"},
    {"Left mouse", "LMB"}, {"Right mouse", "RMB"},  {"Middle mouse", "MMB"},  {"Wheel up", "Wh+"},
    {"Wheel down", "Wh-"}, {"Left stick in", "LS"}, {"Right stick in", "RS"},
}};

/// Text on the cell of a wand: the control that selects it, or the slot's number if neither it nor the next
/// wand has a control.
std::string control_of(const WandStrip& strip, std::size_t wand, std::size_t next) {
    const auto slot = strip.wands[wand].slot;
    if (slot < strip.controls.size() && !strip.controls[slot].empty())
        return brief_label(strip.controls[slot]);
    if (strip.next_control.empty()) return text(slot + 1);
    if (wand != next) return {};
    return brief_label(strip.next_control);
}

}  // namespace

std::string brief_label(std::string_view label) {
    constexpr std::size_t most = 3;
    constexpr std::string_view keypad = "Keypad ";
    const auto known = std::find_if(short_labels.begin(), short_labels.end(),
                                    [&](const auto& one) { return one.first == label; });
    if (known != short_labels.end()) return std::string(known->second);
    if (label.starts_with(keypad)) label.remove_prefix(keypad.size());
    const auto last = label.rfind(' ');
    const auto words = last == std::string_view::npos
                           ? std::string(label)
                           : text(label.substr(0, 1), capitalised(label.substr(last + 1)));
    return words.substr(0, most);
}

void add_wand_icon(render::Overlay& out, const WandLook& look, fvec2 middle, float size, fvec4 paint) {
    constexpr float diagonal = 0.8F;  // length of a wand, with a margin (m)
    const Icon icon{out, look.flat, middle, 1.414F * size / diagonal, paint};
    icon.line({0, 0, -0.09}, {0, 0, 0.115}, 0.028);  // handle
    for (const auto& part : look.wand) add_part(icon, part);
}

void add_wand_strip(render::Overlay& out, const WandStrip& strip, fvec2 upper_left, float unit) {
    const auto& wands = strip.wands;
    const auto cell_of = [&](std::size_t i) {
        const auto before = static_cast<std::size_t>(
            std::count_if(wands.begin(), wands.end(), [&](const auto& w) { return w.slot < wands[i].slot; }));
        const fvec2 at(before % strip.columns, before / strip.columns);
        const fvec2 low = upper_left + unit * at * fvec2(strip_cell_width, strip_cell_height);
        return Panel{low, low + unit * fvec2(strip_cell_width, strip_cell_height)};
    };
    const auto paint_of = [&](std::size_t i) {
        return i == strip.in_hand ? paints.chosen : colour(0xB8A8CC, 0.85F);
    };
    // All shapes are added before all text, because the renderer can draw neighbouring items of one kind
    // together.
    for (std::size_t i = 0; i < wands.size(); ++i) {
        const auto cell = cell_of(i);
        if (i == strip.in_hand)
            out.items.emplace_back(render::RectItem{cell.low, cell.high, paints.chosen_plate, 6 * unit});
        add_wand_icon(out, wands[i].look, cell.low + unit * fvec2(24, 16), 22 * unit, paint_of(i));
        const double cap = std::max(wands[i].energy_cap, 1e-9), charge = strip.charges[i];
        add_charge(out, {cell.low + unit * fvec2(4, 32), cell.low + unit * fvec2(strip_cell_width - 4, 38)},
                   charge < wands[i].energy_cost ? 0 : charge / cap, strip.refilled, strip.full);
    }
    const auto next = next_in_slots(wands, strip.in_hand);
    for (std::size_t i = 0; i < wands.size(); ++i) {
        const auto cell = cell_of(i);
        const auto words = control_of(strip, i, next);
        const Panel box{cell.low + unit * fvec2(2, 1), cell.low + unit * fvec2(strip_cell_width / 2, 14)};
        add_text_in(out, box, words, 10 * unit, paint_of(i), render::Align::left);
    }
}

}  // namespace thaum::game::inline hud
