#include "game/hud/replay_bar.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "game/data/teams.h"
#include "game/hud/overlay.h"

namespace thaum::game::inline hud {
namespace {

using render::Align;
using render::Overlay;
using render::RectItem;

// Sizes in HUD units.
constexpr float side_room = 10, row_high = 17, track_high = 18, key_words = 10.5F, keys_high = 15,
                row_gap = 2;
constexpr int max_keys_lines = 3;
constexpr float line_high = 6, knob_wide = 5, mark_radius = 5.5F;
constexpr float min_wide = 260;               // width of a bar that fits into every window (HUD units)
constexpr float max_share_of_window = 0.22F;  // largest share of the window's height that the bar takes
constexpr float usual_high = 600, usual_wide = 900;

float share_of(Tick tick, Tick length) {
    return length == 0 ? 0
                       : static_cast<float>(static_cast<double>(std::min(tick, length)) /
                                            static_cast<double>(length));
}

float place_of(const ReplayBarLayout& l, Tick tick, Tick length) {
    return l.track.low.x + share_of(tick, length) * (l.track.high.x - l.track.low.x);
}

std::string clock_of(Tick tick) { return clock_text(tick / ticks_per_second); }

std::string speed_words(double speed) {
    const auto whole = std::round(speed);
    return text(whole == speed ? text(static_cast<int>(whole)) : fixed(speed, 2), " x");
}

std::string state_words(const ReplayBar& bar, Tick now) {
    std::string words;
    if (bar.target && *bar.target > bar.indexed) words = text("on the way to ", clock_of(*bar.target), ", ");
    if (now >= bar.length)
        words += "end, ";
    else if (bar.paused)
        words += "paused, ";
    return text(words, speed_words(bar.speed), ", ", bar.eyes);
}

void add_line(Overlay& out, const ReplayBarLayout& l, float from, float to, fvec4 paint) {
    const float middle = (l.track.low.y + l.track.high.y) / 2, half = line_high / 2 * l.unit;
    out.items.emplace_back(RectItem{{from, middle - half}, {to, middle + half}, paint, half / 2});
}

/// Marks a kill with the mark of the player who made it. A death that counts as no kill of the other player
/// gets a cross.
void add_kill(Overlay& out, const Kill& kill, fvec2 centre, float u) {
    if (kill.by < players && kill.by != kill.victim) return add_mark(out, kill.by, centre, mark_radius * u);
    const auto paint = opaque(team_colours(kill.victim).light);
    const float arm = mark_radius * u;
    out.items.emplace_back(render::LineItem{centre - fvec2(arm), centre + fvec2(arm), 2 * u, paint});
    out.items.emplace_back(
        render::LineItem{centre + fvec2(-arm, arm), centre + fvec2(arm, -arm), 2 * u, paint});
}

void add_track(Overlay& out, const ReplayBar& bar, Tick now, const ReplayBarLayout& l) {
    const float here = place_of(l, now, bar.length);
    add_line(out, l, l.track.low.x, l.track.high.x, paints.track);
    add_line(out, l, l.track.low.x, place_of(l, bar.indexed, bar.length), fvec4(fvec3(paints.soft), 0.35F));
    add_line(out, l, l.track.low.x, here, paints.soft);
    const float middle = (l.track.low.y + l.track.high.y) / 2;
    for (const auto& kill : bar.kills)
        add_kill(out, kill, {place_of(l, kill.at, bar.length), middle}, l.unit);
    const float knob = place_of(l, bar.target.value_or(now), bar.length);
    const fvec2 half(knob_wide / 2 * l.unit, track_high / 2 * l.unit);
    out.items.emplace_back(
        RectItem{fvec2(knob, middle) - half, fvec2(knob, middle) + half, paints.white, half.x});
}

}  // namespace

namespace {

/// Size of the replay bar, for a certain number of lines of key help.
struct BarSize {
    int lines{};
    float unit{};   ///< length of a HUD unit (px)
    float words{};  ///< text size of the key help (px)
    float high() const { return 4 * row_gap + row_high + track_high + static_cast<float>(lines) * keys_high; }
};

/// Chooses the fewest lines that allow the largest text for the key help. Where there are several lines, they
/// are assumed to be filled only in part.
BarSize size_of_bar(float wanted, float wide, float high) {
    constexpr float full = 0.85F;
    BarSize best;
    for (int lines = 1; lines <= max_keys_lines; ++lines) {
        BarSize bar{.lines = lines};
        bar.unit = std::min({wanted, high * max_share_of_window / bar.high(), wide / min_wide});
        const float room = static_cast<float>(lines) * (wide - 2 * side_room * bar.unit);
        bar.words = std::min(key_words * bar.unit, (lines > 1 ? full : 1) * room / replay_keys_wide);
        if (best.lines == 0 || bar.words > 1.02F * best.words) best = bar;
    }
    return best;
}

}  // namespace

ReplayBarLayout lay_out_replay_bar(double text_scale, render::Size window) {
    const auto w = static_cast<float>(window.width), h = static_cast<float>(window.height);
    const float wanted =
        std::max(0.4F, std::min(w / usual_wide, h / usual_high)) * static_cast<float>(text_scale);
    const auto bar = size_of_bar(wanted, w, h);
    ReplayBarLayout l;
    l.unit = bar.unit;
    const float u = l.unit, left = std::min(side_room * u, w / 4), right = w - left;
    l.band = {{0, h - bar.high() * u}, {w, h}};
    float y = l.band.low.y + row_gap * u;
    const float middle = left + 0.3F * (right - left);
    l.clock = {{left, y}, {middle, y + row_high * u}};
    l.state = {{middle, y}, {right, y + row_high * u}};
    y += (row_high + row_gap) * u;
    l.track = {{left, y}, {right, y + track_high * u}};
    y += (track_high + row_gap) * u;
    l.keys = {{left, y}, {right, y + static_cast<float>(bar.lines) * keys_high * u}};
    return l;
}

Tick tick_at(const ReplayBarLayout& l, float x, Tick length) {
    const float wide = l.track.high.x - l.track.low.x;
    const double share = wide > 0 ? std::clamp((x - l.track.low.x) / wide, 0.0F, 1.0F) : 0;
    return static_cast<Tick>(std::llround(share * static_cast<double>(length)));
}

void add_replay_bar(Overlay& out, const ReplayBar& bar, Tick now, const ReplayBarLayout& l) {
    out.items.emplace_back(RectItem{l.band.low, l.band.high, opaque(fvec3(paints.dark)), 0});
    add_track(out, bar, now, l);
    const float size = 13 * l.unit;
    const auto tenth = static_cast<int>(now / 100 % 10);
    add_text_in(out, l.clock, text(clock_of(now), ".", tenth, " / ", clock_of(bar.length)), size,
                paints.white, Align::left);
    add_text_in(out, l.state, state_words(bar, now), size, paints.white, Align::right);
    add_text_in(out, l.keys, bar.keys, key_words * l.unit, paints.soft, Align::centre);
}

}  // namespace thaum::game::inline hud
