#include "game/hud/layout.h"

#include "game/hud/body_figure.h"

#include <algorithm>
#include <cmath>

namespace thaum::game::inline hud {
namespace {

// Sizes in HUD units.
constexpr float edge = 8;  // distance of panels from the view's edge and from each other
constexpr float health_wide = 80, health_high = 80;
constexpr float name_high = 18;
constexpr float left_column = edge + health_wide + edge;
constexpr float score_half_wide = 96, score_half_high = 27;
// half the width of a lesson's title, and the width of a view that has room for it
constexpr float title_half_wide = 124, title_view_wide = 440;
// Distance from the top of the window to the panels below a score that stands there.
constexpr float under_score = 7 + 2 * score_half_high + 2;
constexpr float line = 20;  // height of a line of messages, notices or feed
// Distance from the top of the window to the panels below the notices, which stand below the score.
constexpr float under_notices = under_score + 2 * line + edge;
constexpr float lesson_words = 14;  // text size of a lesson (HUD units)
constexpr float min_ring = 26, max_ring = 66;
// Minimum height of the panel for the spell that a stroke will probably cast (HUD units)
constexpr float min_likely = 14;

// Minimum sizes of views (HUD units). A tall view has its messages above the corner panels, a flat view
// between them.
constexpr float tall_least_high = 400, tall_least_wide = 236;
constexpr float flat_least_wide = 410;
// Minimum heights of a flat view, in which the messages are between the corner panels, that leave room for a
// sound in words and for the body figure (HUD units). They differ because sound and figure stand below other
// panels: in a view alone below the score, in views beside each other below the notices under the score, in
// stacked views below the feed.
constexpr float flat_alone_high = 220, flat_beside_high = 284, flat_stacked_high = 224;
constexpr float flat_messages_wide = 220;
// Maximum height of the messages in a tall view, which has them above the corner panels.
constexpr float messages_high = 8 * line;
constexpr float ring_gap = 16;  // distance of the corner panels from the smallest ring around the crosshair,
                                // or from the score

struct Strip {
    float columns{}, wide{}, high{};
};

Strip strip_of(std::size_t wands, float rows) {
    const float columns = std::max(1.0F, std::ceil(static_cast<float>(wands) / rows));
    return {columns, columns * strip_cell_width + 2 * strip_margin, strip_head + rows * strip_cell_height};
}

/// How the views share the window: one alone, two stacked or two beside each other; and whose view is laid
/// out.
struct Arrangement {
    bool alone{}, stacked{}, lesson{}, cards{};
    std::uint32_t player{};
    bool upper() const { return stacked && player == 0; }
    bool lower() const { return stacked && player == 1; }
    bool beside() const { return !alone && !stacked; }
};

/// Minimum width of a flat view, which has its messages between the corner panels (HUD units). At this width
/// these panels touch neither the ring around the crosshair, nor a score between two views.
float min_flat_width(const Arrangement& how, std::size_t wands) {
    const float middle = how.stacked ? score_half_wide : min_ring + edge;
    return std::max(flat_least_wide, 2 * (middle + ring_gap + strip_of(wands, 2).wide));
}

/// Length of a HUD unit that the settings ask for (px). If the panels have no room then, unit_of makes it
/// smaller.
float wanted_unit(const Arrangement& how, const render::Rect& view, render::Size window, double text_scale) {
    const float high = static_cast<float>(window.height) / 720 * (how.alone ? 1.35F : 1.05F);
    const float wide = static_cast<float>(view.width) / 420;
    return std::clamp(std::min(wide, high), 0.4F, 6.0F) * static_cast<float>(text_scale);
}

/// Length of a HUD unit (px): the one that the settings ask for, or a smaller one if the panels need that. In
/// a window with one view, a lesson needs a tall view, which has its messages above the corner panels.
float unit_of(const Arrangement& how, const render::Rect& view, float wanted, std::size_t wands) {
    const auto w = static_cast<float>(view.width), h = static_cast<float>(view.height);
    const float tall = std::min(w / tall_least_wide, h / tall_least_high);
    const float min_high = how.alone ? flat_alone_high : how.beside() ? flat_beside_high : flat_stacked_high;
    const float flat = std::min(w / min_flat_width(how, wands), h / min_high);
    return std::min(wanted, how.alone && how.lesson ? tall : std::max(tall, flat));
}

/// Layout of one view in HUD units, with the origin at its top left.
struct InUnits {
    float wide{}, high{};
    bool tall{};

    Panel health{}, name{}, strip{}, feed{}, messages{}, forces{}, heard{}, figure{}, aside{}, likely{},
        strokes{};
    float ring{}, columns{};
};

/// Places the health and the name at the lower left and the wands at the lower right, in two rows if one row
/// would touch the health.
void place_corners(const Arrangement& how, std::size_t wands, InUnits& out) {
    const float w = out.wide, h = out.high;
    out.health = {{edge, h - edge - health_high}, {edge + health_wide, h - edge}};
    out.name = {{edge, out.health.low.y - name_high}, {edge + health_wide, out.health.low.y}};
    const auto one_row = strip_of(wands, 1);
    const float between = out.tall ? edge : flat_messages_wide;
    const bool meets_score = how.upper() && w / 2 - score_half_wide < one_row.wide + 2 * edge;
    const bool crowded = w < left_column + between + one_row.wide + edge;
    const auto strip = meets_score || crowded ? strip_of(wands, 2) : one_row;
    const float scale = std::min(1.0F, (w - left_column - edge) / strip.wide);
    out.strip = {{w - edge - scale * strip.wide, h - edge - scale * strip.high}, {w - edge, h - edge}};
    out.columns = strip.columns;
}

/// Lower end of the panels that stand in the middle at the top of a view (HUD units).
float bottom_of_head(const Arrangement& how) {
    return how.beside() ? under_notices : how.alone ? under_score : edge + 2 * line;
}

/// Places the ring around the crosshair, and the messages below it.
void place_middle(const Arrangement& how, InUnits& out) {
    const float w = out.wide, h = out.high;
    // How far a score between two stacked views reaches into the bottom of the upper view.
    const float floor = how.upper() ? score_half_high + 3 : 0;
    const float corners = std::min(out.name.low.y, out.strip.low.y);
    const float bottom = (out.tall ? corners : h - floor) - edge / 2;
    const float above = bottom_of_head(how);
    const float aside =
        out.tall ? w / 2 - edge : std::min(w / 2 - left_column, out.strip.low.x - edge - w / 2);
    const float least = (how.cards && out.tall ? 6 : 2) * line;  // minimum height of the messages
    out.ring =
        std::clamp(std::min({h / 2 - above - edge / 2 - min_likely, bottom - h / 2 - edge - least, aside}),
                   min_ring, max_ring);
    const float top = h / 2 + out.ring + edge / 2;
    out.messages = out.tall ? Panel{{edge, std::max(top, bottom - messages_high)}, {w - edge, bottom}}
                            : Panel{{left_column, top}, {out.strip.low.x - edge, bottom}};
}

/// Places the player's name, with the free room to its right. In a flat view it stands above the messages,
/// beside the ring around the crosshair.
void place_name(InUnits& out) {
    if (!out.tall) {
        out.name.high.y = std::min(out.name.high.y, out.messages.low.y);
        out.name.low.y = out.name.high.y - name_high;
        out.name.high.x = std::min(out.wide / 2 - out.ring, out.strip.low.x) - edge;
    } else {
        const bool meets_strip = out.strip.low.y < out.name.high.y;
        out.name.high.x = (meets_strip ? out.strip.low.x : out.wide) - edge;
    }
}

/// Half the width of the score, or of a lesson's title that stands in its place (HUD units).
float half_width_of_score(const Arrangement& how, float view_wide) {
    return how.alone && how.lesson && view_wide >= title_view_wide ? title_half_wide : score_half_wide;
}

/// Places the feed (the list of recent events) beside the score. In the upper one of two views it is also
/// below the notices.
void place_feed(const Arrangement& how, InUnits& out) {
    const float w = out.wide;
    const float wide = how.upper()    ? w / 2 - out.ring - 2 * edge
                       : how.beside() ? w - score_half_wide - 2 * edge
                                      : w / 2 - half_width_of_score(how, w) - 2 * edge;
    const float top = how.upper() ? edge + 2 * line : edge;
    const float bottom = top + (out.tall && how.alone ? 3 : 2) * line;
    const bool left = how.beside() && how.player == 0;
    const float from = left ? edge : w - edge - wide;
    out.feed = {{from, top}, {from + wide, bottom}};
}

/// Places the curve of the force, as large as the left side allows, or only the name of the strongest force.
void place_forces(const Arrangement& how, bool curve, InUnits& out) {
    const float top = how.beside()  ? under_notices
                      : how.lower() ? edge
                      : how.upper() ? edge + 2 * line
                                    : under_score + edge;
    const float high = out.name.low.y - edge / 2 - top;
    const float wide = out.wide / 2 - std::max(out.ring, how.lower() ? score_half_wide : 0) - 2 * edge;
    const float scale = std::max(0.1F, std::min({1.0F, high / forces_high, wide / forces_wide}));
    const fvec2 size = curve ? fvec2(forces_wide, forces_high) : fvec2(force_word_wide, force_word_high);
    out.forces = {{edge, top}, fvec2(edge, top) + scale * size};
}

/// Places the words about sounds and effects: below the force, left of the ring around the crosshair.
void place_heard(const Arrangement& how, InUnits& out) {
    const float top = out.forces.high.y + edge / 2;
    const float bottom = std::min(out.name.low.y, out.messages.low.y) - edge / 2;
    const float wide = out.wide / 2 - std::max(out.ring, how.lower() ? score_half_wide : 0) - 2 * edge;
    const bool room = bottom - top >= heard_line_high - 0.01F;
    out.heard = {{edge, top}, {edge + (room ? wide : 0), room ? bottom : top}};
}

/// Places the body figure: above the wands at the right, as large as the room below feed and notices allows.
void place_figure(const Arrangement& how, InUnits& out) {
    if (how.alone && how.lesson) return;
    const float least = how.beside() ? under_notices : how.alone ? under_score : 0;
    const float top = std::max(out.feed.high.y, least) + edge / 2;
    const float bottom = std::min(out.strip.low.y, out.tall ? out.messages.low.y : out.high) - edge / 2;
    const float beside_messages = out.strip.high.x - out.strip.low.x;
    const float wide = out.tall ? out.wide / 2 - out.ring - 2 * edge : beside_messages;
    const float scale = std::max(0.1F, std::min({1.0F, (bottom - top) / figure_high, wide / figure_wide}));
    const fvec2 high(out.wide - edge, bottom);
    out.figure = {high - scale * fvec2(figure_wide, figure_high), high};
}

/// Places the name of the spell that a stroke will probably cast above the ring around the crosshair, and the
/// panel of strokes around that ring. The panel ends above two lines of messages.
void place_strokes(const Arrangement& how, InUnits& out) {
    constexpr float max_high = 24, captions = 2 * 1.4F * 15;
    const fvec2 middle(out.wide / 2, out.high / 2);
    const float head = bottom_of_head(how), bottom = middle.y - out.ring - edge / 2;
    const float half = out.ring + edge / 2, top = std::max(head, bottom - max_high);
    if (bottom - top >= min_likely - 0.01F) out.likely = {{middle.x - half, top}, {middle.x + half, bottom}};
    out.strokes = {{edge, std::min(head, middle.y - out.ring)},
                   {out.wide - edge, std::max(out.messages.high.y - captions, middle.y + out.ring)}};
}

/// Places the panel `aside` for a card, which is about the player's work at cauldron, orb or crystal. It is
/// in the free room right of the ring around the crosshair, left of body figure and strip of wands.
void place_aside(const Arrangement& how, InUnits& out) {
    constexpr float min_wide = 180, min_high = 48;
    if (how.alone && how.lesson) return;
    const float above = how.beside()  ? under_notices
                        : how.alone   ? under_score
                        : how.lower() ? score_half_high
                                      : 0;
    const fvec2 low(out.wide / 2 + out.ring + edge, std::max(out.feed.high.y, above) + edge / 2);
    const fvec2 high(out.figure.low.x - edge, std::min(out.messages.low.y, out.strip.low.y) - edge / 2);
    if (high.x - low.x >= min_wide && high.y - low.y >= min_high) out.aside = {low, high};
}

InUnits in_units(const Arrangement& how, fvec2 size, std::size_t wands, bool curve) {
    InUnits out{.wide = size.x, .high = size.y, .tall = size.y > tall_least_high - 1};
    place_corners(how, wands, out);
    place_middle(how, out);
    place_name(out);
    place_feed(how, out);
    place_forces(how, curve, out);
    place_heard(how, out);
    place_figure(how, out);
    place_aside(how, out);
    place_strokes(how, out);
    return out;
}

Panel placed(const Panel& box, const render::Rect& view, float unit) {
    const fvec2 corner(static_cast<float>(view.x), static_cast<float>(view.y));
    return {corner + unit * box.low, corner + unit * box.high};
}

ViewLayout view_layout(const Arrangement& how, const render::Rect& view, float unit, std::size_t wands,
                       bool curve) {
    const fvec2 size(static_cast<float>(view.width), static_cast<float>(view.height));
    const auto units = in_units(how, size / unit, wands, curve);
    const auto box = [&](const Panel& b) { return placed(b, view, unit); };
    return {.view = view,
            .unit = unit,
            .centre = fvec2(static_cast<float>(view.x), static_cast<float>(view.y)) + 0.5F * size,
            .ring = unit * units.ring,
            .health = box(units.health),
            .name = box(units.name),
            .strip = box(units.strip),
            .strip_columns = units.columns,
            .feed = box(units.feed),
            .messages = box(units.messages),
            .forces = box(units.forces),
            .figure = box(units.figure),
            .aside = box(units.aside),
            .heard = box(units.heard),
            .likely = box(units.likely),
            .strokes = box(units.strokes)};
}

/// Places the panels of the whole window.
void place_shared(const Arrangement& how, render::Size window, HudLayout& out) {
    const auto w = static_cast<float>(window.width), h = static_cast<float>(window.height);
    const float u = out.unit;
    const fvec2 middle = how.stacked ? fvec2(w, h) / 2.0F : fvec2(w / 2, 34 * u);
    const fvec2 half = u * fvec2(half_width_of_score(how, w / u), score_half_high);
    out.score = {middle - half, middle + half};
    if (how.stacked) {
        out.notices = {u * fvec2(edge, edge / 2), {w - u * edge, u * (edge / 2 + 2 * line)}};
    } else if (how.alone) {
        out.notices = {u * fvec2(edge, edge), {out.score.low.x - u * edge, u * under_score}};
    } else {
        out.notices = {u * fvec2(edge, under_score + edge / 2),
                       {w - u * edge, u * (under_score + edge / 2 + 2 * line)}};
    }
}

/// The panel for a lesson in a window with one view: right of the ring around the crosshair, below feed and
/// score, above the panels at the bottom.
Panel lesson_of(const ViewLayout& view) {
    const float u = view.unit;
    const float top = std::max(view.feed.high.y, u * under_score) + u * edge / 2;
    const float bottom = std::min(view.strip.low.y, view.messages.low.y) - u * edge / 2;
    return {{view.centre.x + view.ring + u * edge, top}, {view.feed.high.x, bottom}};
}

/// Text size of the countdown to the start of play, limited by the smallest ring around the crosshair (px).
float count_size_of(const std::array<std::optional<ViewLayout>, players>& views) {
    float ring = 0;
    for (const auto& view : views) {
        if (view) ring = ring == 0 ? view->ring : std::min(ring, view->ring);
    }
    return std::floor(1.2F * ring);
}

constexpr float min_words = 4;             // smallest text size of the typeface (px)
constexpr float widest_character = 1.12F;  // largest width of a character (em)

/// Upper estimate of a character's width in the typeface (em).
float character_width(char c) {
    constexpr std::string_view narrow = "iljftrI.,:;'|!()[] ", wide = "mwMWQ%@";
    // Only the first byte of a character in UTF-8 counts.
    if ((static_cast<unsigned char>(c) & 0xC0U) == 0x80U) return 0;
    if (narrow.find(c) != std::string_view::npos) return 0.48F;
    return wide.find(c) != std::string_view::npos ? widest_character : 0.74F;
}

/// Number of bytes of the whole characters that surely fit in a line; at least one character.
std::size_t longest_part(std::string_view words, float size, float wide) {
    const auto most = static_cast<std::size_t>(std::max(1.0F, wide / (widest_character * size)));
    std::size_t bytes = 0;
    for (std::size_t count = 0; count < most && bytes < words.size(); ++count) {
        do {
            ++bytes;
        } while (bytes < words.size() && (static_cast<unsigned char>(words[bytes]) & 0xC0U) == 0x80U);
    }
    return bytes;
}

/// Whether a text begins with the unit of the number before it: "%" or "s".
bool begin_with_unit(std::string_view words) {
    if (words.empty()) return false;
    const bool alone = words.size() == 1 || words[1] == ' ' || words[1] == ',';
    return words[0] == '%' || (words[0] == 's' && alone);
}

/// Number of bytes up to the first space at which a line may be broken. Names of controls in brackets, "100
/// %" and "20 s" are not broken.
std::size_t unbroken_part(std::string_view words) {
    const auto last = words.rfind(']');
    bool inside = false;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == '[') inside = last != std::string_view::npos && i < last;
        if (words[i] == ']') inside = false;
        if (words[i] == ' ' && !inside && !begin_with_unit(words.substr(i + 1))) return i;
    }
    return words.size();
}

constexpr std::string_view group_gap = "   ";

/// Breaks a text between its groups. Groups are separated by three spaces, such as the help on each key of a
/// replay.
std::vector<std::string> broken_between_groups(std::string_view words, float size, float wide) {
    std::vector<std::string> lines;
    while (!words.empty()) {
        const auto end = std::min(words.find(group_gap), words.size());
        const auto group = words.substr(0, end);
        words.remove_prefix(std::min(end + group_gap.size(), words.size()));
        if (!lines.empty() &&
            width_of(lines.back(), size) + width_of(group_gap, size) + width_of(group, size) <= wide)
            lines.back().append(group_gap).append(group);
        else
            lines.emplace_back(group);
    }
    return lines;
}

/// Breaks a text at spaces, or between its groups if it has groups. At the smallest text size, a word that is
/// longer than a line is broken, too.
std::vector<std::string> broken(std::string_view words, float size, float wide) {
    if (size > min_words && words.find(group_gap) != std::string_view::npos)
        return broken_between_groups(words, size, wide);
    std::vector<std::string> lines;
    while (!words.empty()) {
        const auto end = size > min_words ? unbroken_part(words) : std::min(words.find(' '), words.size());
        const auto word =
            words.substr(0, size > min_words ? end : std::min(end, longest_part(words, size, wide)));
        words.remove_prefix(word.size() < end ? word.size() : std::min(end + 1, words.size()));
        if (!lines.empty() &&
            width_of(lines.back(), size) + width_of(word, size) + character_width(' ') * size <= wide)
            lines.back().append(" ").append(word);
        else
            lines.emplace_back(word);
    }
    return lines;
}

bool fits(const FittedWords& words, fvec2 room) {
    return words.height() <= room.y &&
           std::all_of(words.lines.begin(), words.lines.end(),
                       [&](const auto& l) { return width_of(l, words.size) <= room.x; });
}

}  // namespace

HudLayout lay_out(const HudSettings& settings, render::Size window, std::size_t wands,
                  const LayoutWishes& wishes) {
    HudLayout out;
    const auto views = views_of(settings, window);
    if (settings.replay) out.replay = lay_out_replay_bar(settings.text_scale, window);
    window = area_of_views(settings, window);
    Arrangement how{.alone = settings.watch != Watch::both || settings.split == render::Split::none,
                    .stacked = settings.watch == Watch::both && settings.split == render::Split::top_bottom,
                    .lesson = wishes.lesson};
    for (how.player = 0; how.player < players; ++how.player) {
        const auto& view = views[how.player];
        how.cards = wishes.cards[how.player];
        if (view.width <= 0 || view.height <= 0) continue;
        const float wanted = wanted_unit(how, view, window, settings.text_scale);
        out.unit = unit_of(how, view, wanted, wands);
        out.views[how.player] = view_layout(how, view, out.unit, wands, settings.forces);
        out.lesson_size = lesson_words * wanted;
        if (how.alone && wishes.lesson) out.lesson = lesson_of(*out.views[how.player]);
    }
    place_shared(how, window, out);
    out.count_size = count_size_of(out.views);
    return out;
}

float strip_unit(const ViewLayout& layout) {
    return (layout.strip.high.x - layout.strip.low.x) /
           (layout.strip_columns * strip_cell_width + 2 * strip_margin);
}

float width_of(std::string_view line, float size) {
    float ems = 0;
    for (const char c : line) ems += character_width(c);
    return ems * size;
}

FittedWords fit(std::string_view words, float size, fvec2 room) {
    // The text size is a whole number, since the typeface can only be drawn in whole sizes (px).
    FittedWords out{{}, std::max(min_words, std::floor(size))};
    out.lines = broken(words, out.size, room.x);
    while (out.size > min_words && !fits(out, room)) {
        out.size -= 1;
        out.lines = broken(words, out.size, room.x);
    }
    return out;
}

}  // namespace thaum::game::inline hud
