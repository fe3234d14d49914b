#include "game/hud/menu.h"
#include "core/utf8.h"

#include <algorithm>
#include <cmath>

#include "game/data/teams.h"
#include "game/hud/body_figure.h"
#include "game/hud/layout.h"
#include "game/hud/overlay.h"

namespace thaum::game::inline hud {
namespace {

using render::Align;
using render::colour;
using render::Overlay;

const fvec4 menu_veil = colour(0x0C0616, 0.45F);
const fvec4 menu_panel = colour(0x1C1430, 0.88F);
const fvec4 chosen_row = colour(0x5A3E92, 0.95F);
const fvec4 bright = colour(0xF6F0FF, 1.0F);
const fvec4 quiet = colour(0xCABEDC, 0.9F);
const fvec4 faint = colour(0x8F84A6, 0.9F);
const fvec4 bright_gold = colour(0xFFD98A, 1.0F);

constexpr std::size_t fewest_rows = 4;

/// Positions and sizes of a menu (px). If not all rows fit, `visible` rows are shown, from the row `first`
/// on.
struct MenuLayout {
    float unit{};  ///< length of a HUD unit (px): 1 px in a window of 720 lines at a text size of 100 %
    float title_top{}, line_top{}, seats_top{}, seats_height{};
    fvec2 rows_low{0};
    float row_width{}, row_height{};
    std::size_t first{}, visible{};
    float note_top{}, help_top{}, hint_top{}, help_height{}, hint_height{}, width{};
};

/// Heights of a menu's parts (HUD units).
constexpr float row_units = 27, title_units = 50, line_units = 34, seat_units = 62, note_units = 25,
                edge_units = 12;

float head_units(const MenuPicture& menu) {
    return edge_units + title_units + (menu.line.empty() ? 0 : line_units) +
           (menu.seats.empty() ? 0 : seat_units + 10);
}

/// Text sizes of help and key hint (HUD units), and the maximum number of lines of each.
constexpr float help_size = 16, hint_size = 14, max_lines = 3;

/// Widths of the texts at the foot of the menu (em). `help` is that of the longest help of all rows, so that
/// the rows do not move when another row is chosen.
struct FootWords {
    float help{}, hint{};
};

FootWords foot_of(const MenuPicture& menu) {
    FootWords out{.help = 0, .hint = width_of(menu.hint, 1)};
    for (const auto& row : menu.rows) out.help = std::max(out.help, width_of(row.help, 1));
    return out;
}

/// Height of a text that is `ems` em wide, broken into lines (px). Assumes that lines are rarely full.
float height_of_lines(float ems, float size, float width) {
    const float lines = std::clamp(std::ceil(ems * size / (0.88F * width)), 1.0F, max_lines);
    return lines * FittedWords::line_spacing * size + 1;
}

/// Height of note, help and key hint at the foot of the menu (px).
float foot_height(const FootWords& foot, float width, float unit) {
    const float words = height_of_lines(foot.help, help_size * unit, width) +
                        height_of_lines(foot.hint, hint_size * unit, width);
    return std::max(72 * unit, note_units * unit + words + 2 * unit);
}

std::size_t rows_that_fit(const MenuPicture& menu, const FootWords& foot, float width, float height,
                          float unit) {
    const float left = (height - foot_height(foot, width, unit)) / unit - head_units(menu) - 10;
    return left <= 0 ? 0 : static_cast<std::size_t>(left / row_units);
}

MenuLayout lay_out(const MenuPicture& menu, render::Size size, double text_scale) {
    const float width = static_cast<float>(size.width), height = static_cast<float>(size.height);
    const float least = std::min(height / 720, width / 900);
    const auto rows = menu.rows.size();
    MenuLayout l;
    l.unit = std::max(least * static_cast<float>(text_scale), 0.2F);
    // Large text leaves room for few rows. If fewer than four rows fit, the text is made smaller.
    l.width = 0.94F * width;
    const auto words = foot_of(menu);
    while (l.unit > least &&
           rows_that_fit(menu, words, l.width, height, l.unit) < std::min(rows, fewest_rows))
        l.unit *= 0.95F;
    const float u = l.unit;
    l.title_top = edge_units * u;
    l.line_top = l.title_top + title_units * u;
    l.seats_top = l.line_top + (menu.line.empty() ? 0 : line_units * u);
    l.seats_height = seat_units * u;
    l.visible = std::min(rows, std::max<std::size_t>(rows_that_fit(menu, words, l.width, height, u), 1));
    l.first = menu.middle < l.visible / 2 ? 0 : std::min(menu.middle - l.visible / 2, rows - l.visible);
    // The chosen row must stay visible, even after the window was made smaller.
    l.first = std::clamp(l.first, menu.cursor + 1 - std::min(menu.cursor + 1, l.visible), menu.cursor);
    // The arrows that say that there are more rows stand beside the rows, inside the window.
    l.row_width = std::min({l.width, 700 * u, width - 32 * u});
    l.row_height = row_units * u;
    // The rows stand in the lower part of the window, so that the scene behind them stays visible.
    const float head = head_units(menu) * u, foot = height - foot_height(words, l.width, u);
    const float spare = foot - head - static_cast<float>(l.visible) * l.row_height;
    l.rows_low = {(width - l.row_width) / 2, head + std::max(0.85F * spare, 0.0F)};
    l.note_top = foot + 2 * u;
    l.help_top = foot + note_units * u;
    l.help_height = height_of_lines(words.help, help_size * u, l.width);
    l.hint_height = height_of_lines(words.hint, hint_size * u, l.width);
    l.hint_top = height - l.hint_height - u;
    return l;
}

/// Width of a text in two parts: one that grows with the text size, and one that comes from rounding each
/// character's width to whole pixels.
struct Width {
    float ems{}, rounding{};  ///< the growing part (em) and the rounding part (px)

    explicit Width(std::string_view words)
        : ems(width_of(words, 1)), rounding(0.25F * static_cast<float>(decode_utf8(words).size())) {}
    float at(float size) const { return ems * size + rounding; }
};

/// The largest text size up to `size` with which the words fit in `room` (px).
float fitted(std::string_view words, float size, float room) {
    const Width width(words);
    return std::max(std::min(size, (room - width.rounding) / std::max(width.ems, 0.1F)), 4.0F);
}

void add_fitted(Overlay& out, const std::string& words, fvec2 position, float size, float room, fvec4 paint,
                Align align) {
    if (words.empty()) return;
    const float small = fitted(words, size, room);
    // Text that was made smaller keeps the baseline of text of full size.
    add_text(out, words, position + fvec2(0, 0.6F * (size - small)), small, paint, align);
}

void add_panel(Overlay& out, fvec2 low, fvec2 high, fvec4 paint, float corner) {
    out.items.emplace_back(render::RectItem{low, high, paint, corner});
}

void add_seat(Overlay& out, const MenuSeat& seat, std::uint32_t team, fvec2 low, fvec2 high, float u) {
    const auto& paint = team_colours(team);
    add_panel(out, low, high, menu_panel, 10 * u);
    if (seat.taken) add_panel(out, low, {low.x + 7 * u, high.y}, fvec4(paint.light, 1.0F), 3 * u);
    const float middle = (low.y + high.y) / 2;
    add_mark(out, team, {low.x + 32 * u, middle}, 13 * u);
    const float left = low.x + 56 * u, room = high.x - left - 8 * u;
    add_fitted(out, seat.head, {left, low.y + 6 * u}, 17 * u, room, fvec4(paint.light, 1.0F), Align::left);
    add_fitted(out, seat.device, {left, low.y + 31 * u}, 17 * u, room, seat.taken ? bright : quiet,
               Align::left);
}

void add_seats(Overlay& out, const MenuPicture& menu, const MenuLayout& l, float window_width) {
    const auto count = static_cast<float>(menu.seats.size());
    const float u = l.unit, gap = 14 * u;
    const float width = std::min(l.width, 860 * u);
    const float each = (width - gap * (count - 1)) / std::max(count, 1.0F);
    for (std::size_t i = 0; i < menu.seats.size(); ++i) {
        const float left = (window_width - width) / 2 + static_cast<float>(i) * (each + gap);
        add_seat(out, menu.seats[i], static_cast<std::uint32_t>(i), {left, l.seats_top},
                 {left + each, l.seats_top + l.seats_height}, u);
    }
}

/// Width of each arrow's area at the right of a row (px).
float arrow_width(const MenuLayout& l) { return 30 * l.unit; }

/// Text size of a row, and gap on both sides of its label (HUD units).
constexpr float row_words = 18, label_gap = 12;
/// A label narrower than this share of the row counts as short.
constexpr float short_label = 0.25F;

/// Width of the arrows beside a value, or of the gap in their place (px).
float beside_value(const MenuRow& row, const MenuLayout& l) {
    return row.adjustable ? 2 * arrow_width(l) : 16 * l.unit;
}

/// Width of the value and its arrows, at the right of the row (px). It is usually half of the row. If the
/// label needs more than the other half, the value gets less room, and the reverse. If both need more, a
/// short label keeps its size; otherwise both shrink to the same text size.
float value_width(const MenuRow& row, const MenuLayout& l) {
    if (row.value.empty()) return 0;
    const float size = row_words * l.unit, beside = beside_value(row, l);
    const Width label(row.label), value(row.value), longest(row.longest_value);
    const float room = l.row_width - 2 * label_gap * l.unit, most = room - label.at(size);
    const float needed = beside + value.at(size), wanted = std::max(needed, beside + longest.at(size));
    if (wanted <= most) return std::clamp(0.5F * l.row_width, wanted, most);
    if (needed <= most || label.at(size) <= short_label * l.row_width) return most;
    const float ems = label.ems + value.ems, remaining = room - beside - label.rounding - value.rounding;
    return beside + value.at(std::max(remaining, 0.0F) / ems);
}

void add_arrow(Overlay& out, fvec2 centre, float radius, float way) {
    out.items.emplace_back(render::TriangleItem{centre + fvec2(way * radius, 0),
                                                centre + fvec2(-way * radius, -radius),
                                                centre + fvec2(-way * radius, radius), bright_gold});
}

void add_row(Overlay& out, const MenuRow& row, bool chosen, const MenuLayout& l, std::size_t place) {
    const float u = l.unit;
    const fvec2 low = l.rows_low + fvec2(0, static_cast<float>(place) * l.row_height);
    const fvec2 high = low + fvec2(l.row_width, l.row_height);
    if (chosen) add_panel(out, low, high, chosen_row, 7 * u);
    const auto paint = row.dim ? faint : chosen ? bright : quiet;
    const float top = low.y + 2 * u, size = row_words * u, gap = label_gap * u;
    const float value_space = value_width(row, l), value_room = value_space - beside_value(row, l);
    add_fitted(out, row.label, {low.x + gap, top}, size, l.row_width - value_space - 2 * gap, paint,
               Align::left);
    if (!row.adjustable) {
        add_fitted(out, row.value, {high.x - gap, top}, size, value_room, paint, Align::right);
        return;
    }
    const float middle = high.x - value_space / 2, arrows = arrow_width(l);
    add_fitted(out, row.value, {middle, top}, size, value_room, paint, Align::centre);
    const float y = (low.y + high.y) / 2;
    add_arrow(out, {high.x - value_space + arrows / 2, y}, 5 * u, -1);
    add_arrow(out, {high.x - arrows / 2, y}, 5 * u, 1);
}

Panel foot_box(const MenuLayout& l, float window_width, float top, float height) {
    const float left = (window_width - l.width) / 2;
    return {{left, top}, {left + l.width, top + height}};
}

/// Adds arrows as marks if more rows follow above or below.
void add_scroll_marks(Overlay& out, const MenuPicture& menu, const MenuLayout& l) {
    const float x = l.rows_low.x + l.row_width + 9 * l.unit, r = 6 * l.unit;
    const float bottom = l.rows_low.y + static_cast<float>(l.visible) * l.row_height;
    const auto mark = [&](float y, float way) {
        out.items.emplace_back(render::TriangleItem{{x - r, y}, {x + r, y}, {x, y + way * r}, bright_gold});
    };
    if (l.first > 0) mark(l.rows_low.y + 1.5F * r, -1);
    if (l.first + l.visible < menu.rows.size()) mark(bottom - 1.5F * r, 1);
}

}  // namespace

std::optional<MenuPlace> place_at(const MenuPicture& menu, render::Size size, double text_scale,
                                  fvec2 point) {
    if (menu.title.empty() || menu.rows.empty()) return {};
    const auto l = lay_out(menu, size, text_scale);
    const fvec2 in = point - l.rows_low;
    if (in.x < 0 || in.x >= l.row_width || in.y < 0) return {};
    const auto place = static_cast<std::size_t>(in.y / l.row_height);
    if (place >= l.visible) return {};
    MenuPlace found{l.first + place, MenuPart::row};
    const auto& row = menu.rows[found.row];
    const float in_value = in.x - (l.row_width - value_width(row, l));
    if (row.adjustable && in_value >= 0) {
        if (in.x >= l.row_width - arrow_width(l)) found.part = MenuPart::more;
        if (in_value < arrow_width(l)) found.part = MenuPart::less;
    }
    return found;
}

void add_menu(Overlay& out, const MenuPicture& menu, render::Size size, double text_scale) {
    if (menu.title.empty()) return;
    const float width = static_cast<float>(size.width), height = static_cast<float>(size.height);
    const auto l = lay_out(menu, size, text_scale);
    const float u = l.unit, middle = width / 2;
    add_panel(out, {0, 0}, {width, height}, menu_veil, 0);
    const float head_width = l.width - (menu.figure ? 2 * (figure_wide + edge_units) * u : 0);
    add_fitted(out, menu.title, {middle, l.title_top}, 36 * u, head_width, bright, Align::centre);
    add_fitted(out, menu.line, {middle, l.line_top}, 24 * u, head_width, bright_gold, Align::centre);
    add_seats(out, menu, l, width);
    if (menu.figure) {
        const fvec2 low(width - (figure_wide + edge_units) * u, edge_units * u);
        add_figure(out, {low, low + u * fvec2(figure_wide, figure_high)}, *menu.figure);
    }
    const float rows_height = static_cast<float>(l.visible) * l.row_height;
    add_panel(out, l.rows_low - fvec2(5 * u), l.rows_low + fvec2(l.row_width, rows_height) + fvec2(5 * u),
              menu_panel, 10 * u);
    for (std::size_t i = 0; i < l.visible; ++i)
        add_row(out, menu.rows[l.first + i], l.first + i == menu.cursor, l, i);
    add_scroll_marks(out, menu, l);
    add_fitted(out, menu.note, {middle, l.note_top}, 17 * u, l.width, bright_gold, Align::centre);
    if (menu.cursor < menu.rows.size())
        add_text_in(out, foot_box(l, width, l.help_top, l.help_height), menu.rows[menu.cursor].help,
                    help_size * u, bright, Align::centre);
    add_text_in(out, foot_box(l, width, l.hint_top, l.hint_height), menu.hint, hint_size * u, quiet,
                Align::centre);
}

const render::Frame& make_arena_frame(const ArenaScene& arena_scene, const Picture& picture, double angle,
                                      const HudSettings& settings, render::Size size, FrameMemory& memory) {
    const auto& look = arena_scene.menu_camera;
    const vec2 middle = (arena_scene.shade.low + arena_scene.shade.high) / 2.0;
    const vec3 eye{middle.x + look.distance * std::sin(angle), look.height,
                   middle.y + look.distance * std::cos(angle)};
    begin_frame(arena_scene, picture, settings, size, memory);
    auto& frame = memory.frame;
    memory.instances[0].clear();
    memory.lights[0].clear();
    add_instances(arena_scene, picture, no_player, memory.instances[0]);
    add_power_ups(arena_scene.power_ups, picture, eye, memory.instances[0]);
    choose_lights(arena_scene, picture, eye, memory.lights[0]);
    render::Camera camera;
    camera.position = fvec3(eye);
    camera.orientation = fquat(look_rotation(angle, -look.down));
    camera.fov_y =
        static_cast<float>(field_of_view(settings.fov, static_cast<double>(size.width) / size.height));
    camera.far_plane = 160;
    frame.views = {{.camera = camera,
                    .viewport = {0, 0, size.width, size.height},
                    .instances = memory.instances[0],
                    .lights = memory.lights[0],
                    .environment = arena_scene.environment,
                    .shades = memory.shades,
                    .mists = memory.mists}};
    return frame;
}

}  // namespace thaum::game::inline hud
