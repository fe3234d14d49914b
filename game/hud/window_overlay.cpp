// The overlay of a frame: the overlays of the views, and over them the panels of the whole window.
#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "game/data/teams.h"
#include "game/hud/gesture_wall.h"
#include "game/hud/overlay.h"
#include "game/hud/result_panel.h"
#include "game/hud/station_card.h"
#include "game/hud/view_overlay.h"

namespace thaum::game::inline hud {
namespace {

using render::Align;
using render::Overlay;
using render::Rect;

std::string clock_left(double seconds_left) {
    return clock_text(static_cast<std::uint64_t>(std::ceil(std::max(seconds_left, 0.0))));
}

std::string goal_line(const Picture& picture) {
    if (picture.boils_over) return "Boil-over: next to fall loses";
    auto goal = text("first to ", picture.kills_to_win);
    if (picture.surge > 1) goal += text(", mana \u00D7", picture.surge);
    if (picture.rounds <= 1) return goal;
    return text("rounds ", picture.rounds_won[0], " : ", picture.rounds_won[1], ", ", goal);
}

fvec2 middle_of(const Panel& box) { return (box.low + box.high) / 2.0F; }

/// Adds the score and the clock.
void add_score(Overlay& out, const Picture& picture, const Panel& box, float u) {
    const fvec2 middle = middle_of(box);
    out.items.emplace_back(render::RectItem{box.low, box.high, paints.plate, 12 * u});
    for (std::uint32_t player = 0; player < players; ++player) {
        const float side = player == 0 ? -1.0F : 1.0F;
        add_mark(out, player, middle + u * fvec2(76 * side, -4), 10 * u);
        add_text(out, text(picture.wizards[player].vitals.kills), middle + u * fvec2(44 * side, -22), 25 * u,
                 opaque(team_colours(player).light), Align::centre);
    }
    add_text(out, clock_left(picture.left_s), middle + u * fvec2(0, -25), 19 * u, paints.white,
             Align::centre);
    add_text_in(out, {{box.low.x, middle.y + 7 * u}, {box.high.x, box.high.y}}, goal_line(picture), 11 * u,
                paints.soft, Align::centre);
}

/// Adds the score of the practice range, and the line below it. `size`: largest text size of the score (px).
void add_practice(Overlay& out, const Picture& picture, const ControlNames& controls, const Panel& box,
                  float u, float size) {
    const auto& practice = picture.practice;
    out.items.emplace_back(render::RectItem{box.low, box.high, paints.plate, 12 * u});
    const float middle = middle_of(box).y + 4 * u;
    const fvec2 margin(6 * u, 3 * u);
    add_text_in(out, {box.low + margin, {box.high.x - margin.x, middle}}, practice.score, size, paints.white,
                Align::centre);
    add_text_in(out, {{box.low.x + margin.x, middle}, box.high - margin},
                with_controls(practice.below, controls, *picture.shown), 13 * u, paints.soft, Align::centre);
}

struct Notice {
    std::string words;
    fvec4 paint{};
    float size = 14;  ///< text size (HUD units)
};

/// Notices, which are short messages for both players, the most important first.
std::vector<Notice> notices_of(const Picture& picture, const HudSettings& settings) {
    std::vector<Notice> all;
    constexpr float large = 22;  // text size of notices that may end the round (HUD units)
    for (std::uint32_t player = 0; player < players; ++player) {
        const auto& work = picture.wizards[player].stations.work;
        if (picture.phase == Phase::playing && work.left_s > 0)
            all.push_back({text("Great Work of ", name_of(settings.names, player), ": ",
                                std::lround(std::ceil(work.left_s)), " s"),
                           opaque(team_colours(player).light), large});
    }
    if (!picture.caption.words.empty())
        all.push_back({picture.caption.words, picture.caption.fault ? paints.light_red : paints.white});
    if (picture.overloaded) {
        all.push_back(
            {text("The game fell behind by ", fixed(picture.skipped / 1000.0, 1), " s. ",
                  settings.quality == render::Quality::low ? "A smaller window or fewer programs may help."
                                                           : "Try low picture quality."),
             paints.light_red});
    }
    if (settings.frame_times) all.push_back({words_of(*settings.frame_times), paints.soft});
    if (picture.mark != 0) all.push_back({text("bookmark ", picture.mark), paints.soft});
    return all;
}

/// Adds the notices from the top of their box downwards, as many as fit.
void add_notices(Overlay& out, const Picture& picture, const HudSettings& settings, const Panel& box,
                 float u) {
    float top = box.low.y;
    for (const auto& notice : notices_of(picture, settings)) {
        const float size = std::floor(notice.size * u);
        const fvec2 room(box.high.x - box.low.x - size, box.high.y - top);
        const bool first = top <= box.low.y;
        if (!first && room.y < FittedWords::line_spacing * size) return;
        const auto words = fit(notice.words, size, room);
        if (!first && words.size < size) return;
        add_plate(out, box, top, words, notice.paint);
        top += words.height() + 2 * u;
    }
}

/// Text of a lesson and of its hint, broken into lines.
struct LessonWords {
    FittedWords words, hint;
    float height(float gap) const { return words.height() + (hint.lines.empty() ? 0 : gap + hint.height()); }
};

/// Breaks the text of a lesson and its hint into lines for a box, at the largest size, up to `size` (px), at
/// which both fit. If that size would be tiny, the hint is left out.
LessonWords fit_lesson(const std::string& words, const std::string& hint, float size, fvec2 room, float gap) {
    constexpr float any_height = 1e5F, least = 8;  // more than the height of any text, and smallest text size
                                                   // (px)
    const auto both = [&](float of) {
        return LessonWords{fit(words, of, {room.x, any_height}), fit(hint, of, {room.x, any_height})};
    };
    const auto widest = both(size);  // the size is limited only by the longest word of each text
    for (size = std::min(widest.words.size, widest.hint.size); size >= least; --size) {
        auto lesson = both(size);
        if (lesson.height(gap) <= room.y) return lesson;
    }
    return {fit(words, widest.words.size, room), {}};
}

/// The text of the lesson's current step on the practice range, fitted to its panel.
LessonWords lesson_of(const PracticePicture& practice, const ControlNames& controls,
                      const Presentation& shown, const HudLayout& layout) {
    const Panel& box = *layout.lesson;
    const fvec2 room = box.high - box.low - fvec2(layout.unit * 14, 0);
    return fit_lesson(with_controls(practice.lesson, controls, shown),
                      with_controls(practice.hint, controls, shown), std::floor(layout.lesson_size), room,
                      3 * layout.unit);
}

void add_lesson(Overlay& out, const LessonWords& lesson, const Panel& box, float u) {
    add_plate(out, box, box.low.y, lesson.words, paints.white);
    if (!lesson.hint.lines.empty())
        add_plate(out, box, box.low.y + lesson.words.height() + 3 * u, lesson.hint, paints.soft);
}

void add_seam(Overlay& out, const HudSettings& settings, render::Size size) {
    if (settings.watch != Watch::both || settings.split == render::Split::none) return;
    size = area_of_views(settings, size);
    const auto w = static_cast<float>(size.width), h = static_cast<float>(size.height);
    const bool stacked = settings.split == render::Split::top_bottom;
    const fvec2 from = stacked ? fvec2(0, h / 2) : fvec2(w / 2, 0),
                to = stacked ? fvec2(w, h / 2) : fvec2(w / 2, h);
    out.items.emplace_back(render::LineItem{from, to, 4, paints.dark});
}

constexpr std::uint32_t wall_player = 0;  // the practice range has only one person, the first player

/// Box of the gesture wall, the panel with all gestures on the practice range: on the left, between the
/// notices and the name.
Panel wall_box(const HudLayout& layout) {
    // Largest width of the gesture wall, and gap around it (HUD units)
    constexpr float wide = 390, beside = 12;
    const float u = layout.unit;
    const auto& view = *layout.views[wall_player];
    const float left = static_cast<float>(view.view.x) + beside * u;
    const float right = std::min(left + wide * u, view.centre.x - view.ring);
    return {{left, layout.notices.high.y + beside * u}, {right, view.name.low.y - beside * u}};
}

bool shows_wall(const Picture& picture, const HudLayout& layout) {
    return picture.practice.wall.on && layout.views[wall_player].has_value();
}

/// Moves the panels at the left to the right of the gesture wall while that is shown: forces, words about
/// sounds, messages, and the panel of strokes.
void make_room_for_wall(const Panel& wall, ViewLayout& view) {
    const float gap = 8 * view.unit;
    const fvec2 size = view.forces.high - view.forces.low;
    const float left = view.centre.x + view.ring + gap, top = view.feed.high.y + gap;
    view.messages.low.x = std::max(view.messages.low.x, wall.high.x + gap);
    view.forces = {{left, top}, fvec2(left, top) + size};
    const float bottom = std::min(view.messages.low.y, view.strip.low.y) - gap / 2;
    view.heard = {{left, view.forces.high.y + gap / 2}, {view.figure.low.x - gap, bottom}};
    view.aside = {};
    view.strokes.low.x = std::max(view.strokes.low.x, wall.high.x + gap);
}

/// Adds everything that players see during play: the overlays of the views, the score and the lesson.
void add_play(Overlay& out, const Picture& picture, const HudSettings& settings, const HudLayout& layout) {
    for (std::uint32_t player = 0; player < players; ++player) {
        if (layout.views[player]) add_view_overlay(out, picture, settings, player, layout);
    }
    const auto& practice = picture.practice;
    const auto& controls = settings.controls[0];
    constexpr float title_size = 13;  // text size of a lesson's title, which fits on one line (HUD units)
    float size = 17 * layout.unit;
    if (layout.lesson && !practice.lesson.empty()) {
        const auto lesson = lesson_of(practice, controls, *picture.shown, layout);
        add_lesson(out, lesson, *layout.lesson, layout.unit);
        size = std::min(title_size * layout.unit, lesson.words.size);
    }
    if (shows_wall(picture, layout)) {
        std::vector<std::string> lines;
        for (const auto& line : practice.wall.lines)
            lines.push_back(with_controls(line, controls, *picture.shown));
        add_gesture_wall(out, practice.wall, lines, wall_box(layout), layout.unit);
    }
    if (practice.on)
        add_practice(out, picture, controls, layout.score, layout.unit, size);
    else
        add_score(out, picture, layout.score, layout.unit);
}

/// From item number `first` on, moves text behind the shapes in the list, because the renderer draws
/// neighbouring items of one kind together. Must only be used where shapes cover no text.
void gather(Overlay& out, std::size_t first) {
    std::stable_partition(out.items.begin() + static_cast<std::ptrdiff_t>(first), out.items.end(),
                          [](const auto& item) { return !std::holds_alternative<render::TextItem>(item); });
}

}  // namespace

void make_overlay(const Picture& picture, const HudSettings& settings, render::Size size, Overlay& out) {
    out.items.clear();
    add_seam(out, settings, size);
    if (settings.menu) return;
    auto layout = lay_out(settings, size, picture.shown->wands.size(),
                          {.lesson = !picture.practice.lesson.empty(),
                           .cards = {has_card(picture.wizards[0]), has_card(picture.wizards[1])}});
    if (shows_wall(picture, layout)) make_room_for_wall(wall_box(layout), *layout.views[wall_player]);
    const bool result = picture.phase != Phase::playing && seconds_to_start(picture) == 0;
    if (!result) add_play(out, picture, settings, layout);
    add_notices(out, picture, settings, layout.notices, layout.unit);
    if (layout.replay) add_replay_bar(out, *settings.replay, picture.tick, *layout.replay);
    gather(out, 0);
    const auto panel = out.items.size();
    const auto area = area_of_views(settings, size);
    Rect window{0, 0, area.width, area.height};
    if (result) {
        if (!notices_of(picture, settings).empty()) {
            window.y = std::min(static_cast<int>(layout.notices.high.y), area.height / 2);
            window.height -= window.y;
        }
        add_result_panel(out, picture, settings, window);
    } else if (picture.paused) {
        add_pause_panel(out, picture, settings, window);
    }
    gather(out, panel);
}

}  // namespace thaum::game::inline hud
