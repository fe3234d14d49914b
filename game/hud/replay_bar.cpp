#include "game/hud/replay_bar.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "game/hud/figures.h"
#include "game/hud/overlay.h"

namespace thaum::game {
namespace {

using render::Align;
using render::Overlay;
using render::RectItem;

// Sizes in units.
constexpr float side_room = 10, row_high = 17, track_high = 18, keys_high = 15, row_gap = 2;
constexpr float band_high = 3 * row_gap + row_high + track_high + keys_high + row_gap;
constexpr float line_high = 6, knob_wide = 5, mark_radius = 5.5F;
constexpr float least_wide = 260;       // width that every window has at least
constexpr float largest_share = 0.22F;  // largest share of the window's height
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

/// Marks a kill with the mark of the player who made it, and a death by one's own fault with a cross.
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

ReplayBarLayout lay_out_replay_bar(double text_scale, render::Size window) {
    const auto w = static_cast<float>(window.width), h = static_cast<float>(window.height);
    const float wanted =
        std::max(0.4F, std::min(w / usual_wide, h / usual_high)) * static_cast<float>(text_scale);
    ReplayBarLayout l;
    l.unit = std::min({wanted, h * largest_share / band_high, w / least_wide});
    const float u = l.unit, left = std::min(side_room * u, w / 4), right = w - left;
    l.band = {{0, h - band_high * u}, {w, h}};
    float y = l.band.low.y + row_gap * u;
    const float middle = left + 0.3F * (right - left);
    l.clock = {{left, y}, {middle, y + row_high * u}};
    l.state = {{middle, y}, {right, y + row_high * u}};
    y += (row_high + row_gap) * u;
    l.track = {{left, y}, {right, y + track_high * u}};
    y += (track_high + row_gap) * u;
    l.keys = {{left, y}, {right, y + keys_high * u}};
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
    add_text_in(out, l.keys, bar.keys, 10.5F * l.unit, paints.soft, Align::centre);
}

}  // namespace thaum::game
