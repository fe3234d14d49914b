// The HUD over the views: a few large things in the corners of each view.
#include <algorithm>
#include <cmath>
#include <string>

#include "core/text.h"
#include "game/hud/event_words.h"
#include "game/hud/figures.h"
#include "game/hud/hud.h"
#include "game/hud/overlay.h"
#include "game/hud/wand_icon.h"

namespace thaum::game {
namespace {

using render::Align;
using render::colour;
using render::Overlay;
using render::Rect;

constexpr float third_turn = 2.0943951F;
constexpr float arc_start = -2.3561945F;  // start angle of the arc, which is open at the bottom (rad)
constexpr float arc_sweep = 4.712389F;
constexpr double low_health = 25;    // HP
constexpr double hit_seconds = 0.3;  // time for which the hit mark is shown (s)
constexpr double warning_seconds = 0.9;
constexpr double gift_seconds = 2;
constexpr float result_row = 23;  // line spacing of the result table (units)

const fvec4 panel = colour(0x140E22, 0.62F);
const fvec4 track = colour(0x140E22, 0.75F);
const fvec4 white = colour(0xF6F0FF, 1.0F);
const fvec4 soft = colour(0xD8CCE8, 0.85F);
const fvec4 red = colour(0xFF4A3A, 1.0F);
// Colour for red words, since pure red is hard to read on brick and dusk.
const fvec4 light_red = colour(0xFFB0A0, 1.0F);

/// A view, and the length of a HUD unit in it (px).
struct Corner {
    Rect view;
    float unit{};
};

fvec2 at(const Rect& r, float share_x, float share_y) {
    return {static_cast<float>(r.x) + share_x * static_cast<float>(r.width),
            static_cast<float>(r.y) + share_y * static_cast<float>(r.height)};
}

fvec4 opaque(fvec3 c, float alpha = 1) { return {c, alpha}; }

void add_health(Overlay& out, const PlayerPicture& p, std::uint32_t team, const Corner& c) {
    const float u = c.unit;
    const fvec2 centre = at(c.view, 0, 1) + u * fvec2(44, -42);
    const double share = std::clamp(p.health / std::max(p.health_full, 1.0), 0.0, 1.0);
    const double extra =
        std::clamp((p.health - p.health_full) / std::max(p.health_cap - p.health_full, 1.0), 0.0, 1.0);
    out.items.emplace_back(render::ArcItem{centre, 0, 37 * u, 0, 3 * third_turn, panel});
    out.items.emplace_back(render::ArcItem{centre, 27 * u, 35 * u, arc_start, arc_sweep, track});
    const auto paint = p.health < low_health ? red : opaque(team_colours(team).glow);
    if (share > 0)
        out.items.emplace_back(
            render::ArcItem{centre, 27 * u, 35 * u, arc_start, arc_sweep * static_cast<float>(share), paint});
    if (extra > 0)
        out.items.emplace_back(
            render::ArcItem{centre, 22 * u, 25 * u, arc_start, arc_sweep * static_cast<float>(extra), white});
    if (p.shielded)
        out.items.emplace_back(
            render::ArcItem{centre, 37 * u, 40 * u, 0, 3 * third_turn, colour(0x9AF0E0, 1.0F)});
    add_text(out, text(static_cast<int>(std::ceil(p.health))), centre - fvec2(0, 14 * u), 22 * u, white,
             Align::centre);
    add_mark(out, team, centre + fvec2(0, 27 * u), 7 * u);
}

/// Adds a needle that fills from its handle to its tip: one triangle, and the empty end over it in the dark
/// colour.
void add_needle(Overlay& out, fvec2 tail, float length, float width, double share, fvec4 full) {
    const float filled = std::clamp(static_cast<float>(share), 0.0F, 1.0F);
    const auto end_from = [&](float along, fvec4 paint) {
        const float half = width / 2 * (1 - along);
        const fvec2 at = tail + fvec2(along * length, 0);
        out.items.emplace_back(
            render::TriangleItem{at - fvec2(0, half), tail + fvec2(length, 0), at + fvec2(0, half), paint});
    };
    end_from(0, filled > 0 ? full : track);
    if (filled > 0 && filled < 1) end_from(filled, opaque(fvec3(track)));
    const fvec2 handle(0.05F * length, 0.3F * width);
    out.items.emplace_back(
        render::RectItem{tail - fvec2(2, 1) * handle, tail + fvec2(0, 1) * handle, full, 0.2F * width});
}

void add_wand(Overlay& out, const Picture& picture, std::uint32_t team, const Corner& c) {
    const auto& p = picture.wizards[team];
    if (p.wand.empty()) return;
    const float u = c.unit;
    const fvec2 right = at(c.view, 1, 1) + u * fvec2(-12, -12);
    out.items.emplace_back(render::RectItem{right - u * fvec2(154, 50), right, panel, 10 * u});
    const double share = p.energy_cap > 0 ? p.energy / p.energy_cap : 0;
    add_needle(out, right + u * fvec2(-130, -14), 120 * u, 13 * u, share, opaque(team_colours(team).glow));
    // A flat view with large text has no room between the panel and the feed.
    if (static_cast<float>(c.view.height) >= 200 * u)
        add_wand_strip(out, picture.shown->wands, p.wand_number, right - u * fvec2(0, 54), u);
    add_text(out, capitalised(p.wand), right + u * fvec2(-144, -47), 16 * u, soft, Align::left);
    const bool dry = p.warning == EventKind::dry && p.since_warning_s < warning_seconds;
    const auto paint = dry ? red : white;
    add_text(out, text(static_cast<int>(std::floor(p.energy))), right + u * fvec2(-10, -48), 20 * u, paint,
             Align::right);
}

void add_crosshair(Overlay& out, const Picture& picture, const PlayerPicture& p, const Corner& c) {
    const fvec2 centre = at(c.view, 0.5F, 0.5F);
    const float u = c.unit;
    const auto line = [&](fvec2 way, float from, float to, fvec4 paint, float width) {
        out.items.emplace_back(
            render::LineItem{centre + from * u * way, centre + to * u * way, width, paint});
    };
    const float width = std::max(1.5F, 1.6F * u);
    for (const fvec2 way : {fvec2(1, 0), fvec2(-1, 0), fvec2(0, 1), fvec2(0, -1)}) {
        line(way, 4.5F, 11.5F, colour(0x0A0614, 0.6F), width + 2);
        line(way, 5, 11, white, width);
    }
    if (p.readiness > 0) {
        out.items.emplace_back(render::ArcItem{centre, 14 * u, 17.5F * u, 0, 3 * third_turn, track});
        out.items.emplace_back(render::ArcItem{centre, 14 * u, 17.5F * u, 0,
                                               3 * third_turn * static_cast<float>(p.readiness), white});
    }
    if (p.since_hit_s < hit_seconds) {
        for (const fvec2 way :
             {fvec2(0.707F), fvec2(-0.707F), fvec2(0.707F, -0.707F), fvec2(-0.707F, 0.707F)})
            line(way, 9, 18, colour(0xFFE08A, 1.0F), width + 0.5F);
    }
    if (p.since_warning_s < warning_seconds)
        add_text(out, row_of(picture.shown->events, p.warning).caption, centre + fvec2(0, 22 * u), 14 * u,
                 light_red, Align::centre);
}

/// Direction of a vector in the player's view, clockwise from straight ahead (rad).
float bearing(const PlayerPicture& p, vec3 towards) {
    const vec3 local = rotation({0, 1, 0}, -p.yaw) * towards;
    return static_cast<float>(std::atan2(local.x, -local.z));
}

void add_hurt_marks(Overlay& out, const PlayerPicture& p, const Corner& c) {
    const fvec2 centre = at(c.view, 0.5F, 0.5F);
    const float u = c.unit;
    for (std::uint32_t i = 0; i < p.hurts; ++i) {
        const auto& mark = p.marks[i];
        const auto paint =
            opaque(fvec3(red), static_cast<float>(0.9 * std::max(0.0, 1 - mark.age_s / mark_seconds)));
        // A fall comes from below. A hurt without a direction is marked there as well.
        const bool known = glm::dot(mark.towards, mark.towards) > 0.5;
        const float angle = known ? bearing(p, mark.towards) : 1.5F * third_turn;
        out.items.emplace_back(render::ArcItem{centre, 58 * u, 66 * u, angle - 0.32F, 0.64F, paint});
    }
}

/// True if large text fills a small view. The corners then reach the score, and other things must make room.
bool crowded(const Corner& c) { return static_cast<float>(c.view.width) < 530 * c.unit; }

/// Distance of the kill feed from the top of the view (units). It is below the score if the score is in the
/// way.
float top_of_feed(const Corner& c) {
    if (!crowded(c)) return 12;
    const bool flat = static_cast<float>(c.view.height) < 200 * c.unit;  // one of two stacked views
    if (!flat) return 66;
    return c.view.y > 0 ? 34 : 12;
}

void add_feed(Overlay& out, const Picture& picture, const Corner& c) {
    const float u = c.unit;
    fvec2 right = at(c.view, 1, 0) + u * fvec2(-14, top_of_feed(c));
    const std::uint32_t most = crowded(c) ? 2 : picture.feed_lines;
    for (std::uint32_t i = picture.feed_lines - std::min(most, picture.feed_lines); i < picture.feed_lines;
         ++i) {
        const auto& line = picture.feed[i];
        const auto& row = row_of(picture.shown->events, line.event.kind);
        const bool alone = line.event.by >= players || line.event.by == line.event.subject;
        const auto words = event_words(alone ? row.feed_alone : row.feed, line.event);
        const auto who = alone ? line.event.subject : line.event.by;
        add_text(out, words, right, 15 * u, opaque(team_colours(who).light), Align::right);
        right.y += 20 * u;
    }
}

void add_name(Overlay& out, std::uint32_t player, const Corner& c) {
    const float u = c.unit;
    const fvec2 left = at(c.view, 0, 1) + u * (crowded(c) ? fvec2(8, -100) : fvec2(90, -30));
    add_text(out, text("Player ", player + 1), left, 15 * u, opaque(team_colours(player).light), Align::left);
}

/// Shows what the player has just picked up, for players who do not hear it.
void add_gift(Overlay& out, const Picture& picture, const PlayerPicture& p, const Corner& c) {
    if (p.since_gift_s > gift_seconds) return;
    add_text(out, event_words(row_of(picture.shown->events, p.gift.kind).caption, p.gift),
             at(c.view, 0.5F, 0.76F) - fvec2(0, 25 * c.unit), 18 * c.unit, white, Align::centre);
}

/// Width of a wide character (em).
constexpr float em_per_character = 0.6F;

/// Font size: `size`, or less if the words are wider than the view.
float size_that_fits(std::string_view words, float size, const Rect& view) {
    constexpr float most_of_view = 0.94F;
    const float em = em_per_character * static_cast<float>(words.size());
    return std::min(size, most_of_view * static_cast<float>(view.width) / std::max(em, 1.0F));
}

/// The state of the brew in words: ingredients, mixing, owner and time left. Example: "ember and salt, mixed
/// 57 %, yours, 12 s".
std::string words_of_brew(const CauldronPicture& cauldron, std::uint32_t player) {
    std::string words;
    for (const auto name : cauldron.contents) {
        if (!name.empty()) words += text(words.empty() ? "" : " and ", name);
    }
    if (words.empty()) return "Pure brew";
    words = text(capitalised(words), ", mixed ", std::lround(100 * cauldron.mixing), " %");
    if (cauldron.owner < players) words += cauldron.owner == player ? ", yours" : ", your foe's";
    if (cauldron.spoils_in_s > 0)
        words += text(", spoils in ", std::lround(std::ceil(cauldron.spoils_in_s)), " s");
    return words;
}

std::string words_at_cauldron(const Picture& picture, std::uint32_t player) {
    const auto& p = picture.wizards[player];
    if (!p.stirs && !p.at_rim)
        return p.carries.empty() ? "" : text("Carrying ", p.carries, ": drop it in the cauldron");
    const auto hint = !p.stirs            ? std::string("hold Stir to take the ladle")
                      : p.carries.empty() ? std::string()
                                          : text("use wand: drop in ", p.carries);
    const auto brew = words_of_brew(picture.cauldron, player);
    return hint.empty() ? brew : text(brew, " - ", hint);
}

void add_brew_words(Overlay& out, const Picture& picture, std::uint32_t player, const Corner& c) {
    const auto words = words_at_cauldron(picture, player);
    if (!words.empty())
        add_text(out, words, at(c.view, 0.5F, 0.76F), size_that_fits(words, 16 * c.unit, c.view), white,
                 Align::centre);
}

void add_veil(Overlay& out, const Rect& r, fvec4 paint) {
    out.items.emplace_back(render::RectItem{at(r, 0, 0), at(r, 1, 1), paint, 0});
}

/// Plots the force on the hand over the last two seconds, the newest at the right.
void add_force_plot(Overlay& out, const ForcePicture& force, const Corner& c) {
    const float u = c.unit;
    const float column = 1.4F * u, high = 46 * u;
    const auto columns = static_cast<float>(force.strongest.size());
    const fvec2 low = at(c.view, 1, 0.5F) + fvec2(-14 * u - columns * column, 0.5F * high);
    const fvec2 margin = u * fvec2(6, 6);
    out.items.emplace_back(render::RectItem{low - fvec2(0, high + 18 * u) - margin,
                                            low + fvec2(columns * column, 0) + margin, panel, 6 * u});
    const auto cap = static_cast<float>(std::max(force.cap, 1e-6));
    for (std::size_t i = 0; i < force.strongest.size(); ++i) {
        const float share = std::min(force.strongest[i] / cap, 1.0F);
        const fvec2 foot = low + fvec2(static_cast<float>(i) * column, 0);
        if (share > 0)
            out.items.emplace_back(render::RectItem{foot - fvec2(0, std::max(1.0F, share * high)),
                                                    foot + fvec2(column, 0),
                                                    opaque(force_colour(static_cast<double>(share))), 0});
    }
    const float now = *std::max_element(force.strongest.end() - 8, force.strongest.end());
    add_text(out,
             text(fixed(static_cast<double>(now), 2), " of ", fixed(force.cap, 2), " N, +",
                  fixed(1000 * force.created, 1), " mJ"),
             low - fvec2(0, high + 17 * u), 12 * u, white, Align::left);
}

/// Message about the player's device, real or simulated; empty if there is none. `told`: the driver has
/// reported the fault itself.
std::string_view caption_of(const ForcePicture& force, bool told) {
    using haptics::SafetyCause;
    switch (force.arm) {
        case ArmCondition::gone:
            return told ? "Mouse and keys play on" : "The arm does not answer: mouse and keys play on";
        case ArmCondition::back: return "The arm is back: hold it still";
        case ArmCondition::clutched: return "Clutch: the arm moves free of the hand";
        case ArmCondition::none:
        case ArmCondition::felt: break;
    }
    switch (force.cause) {
        case SafetyCause::warm: return "Forces are weaker for a while: they were strong for too long";
        case SafetyCause::stale: return "Forces fade: the game or the arm is late";
        case SafetyCause::over_speed: return "Forces wait until the hand is slower";
        case SafetyCause::shut_off:
            return "Forces are shut off after a fault: the emergency key brings them back";
        case SafetyCause::panic: return "All forces off: the emergency key brings yours back";
        case SafetyCause::waiting: return "Forces wait until the pull is small";
        case SafetyCause::none:
        case SafetyCause::capped:
        case SafetyCause::off: break;
    }
    return {};
}

/// Adds words on a panel of their width. Long words shrink until they fit the window.
void add_line(Overlay& out, const std::string& words, fvec2 top, float size, fvec4 paint,
              const Rect& window) {
    size = size_that_fits(words, size, window);
    const float em = em_per_character * static_cast<float>(words.size());
    const fvec2 half(0.5F * em * size + 0.5F * size, 0.85F * size), middle = top + fvec2(0, 0.6F * size);
    out.items.emplace_back(
        render::RectItem{middle - half, middle + half, colour(0x140E22, 0.8F), 0.5F * size});
    add_text(out, words, top, size, paint, Align::centre);
}

/// Adds the driver's message above the game's own.
void add_caption(Overlay& out, const PlayerPicture& p, const std::string& device_message, const Corner& c) {
    const fvec2 place = at(c.view, 0.5F, 0.82F);
    const float size = 15 * c.unit;
    const auto words = caption_of(p.force, !device_message.empty());
    if (!words.empty()) add_text(out, std::string(words), place, size, white, Align::centre);
    if (!device_message.empty())
        add_line(out, device_message, place - fvec2(0, 1.7F * size), size, light_red, c.view);
}

void add_death(Overlay& out, const PlayerPicture& p, const Corner& c) {
    add_veil(out, c.view, colour(0x0C0616, 0.5F));
    const fvec2 centre = at(c.view, 0.5F, 0.5F);
    add_text(out, text("Resurrection in ", fixed(p.returns_in_s, 1), " s"), centre - fvec2(0, 16 * c.unit),
             24 * c.unit, white, Align::centre);
}

void add_player(Overlay& out, const Picture& picture, std::uint32_t player, const std::string& device_message,
                const Corner& c) {
    const auto& p = picture.wizards[player];
    if (p.dead && picture.phase == Phase::playing) add_death(out, p, c);
    if (!p.dead) {
        add_crosshair(out, picture, p, c);
        add_hurt_marks(out, p, c);
        add_gift(out, picture, p, c);
        add_brew_words(out, picture, player, c);
    }
    add_caption(out, p, device_message, c);
    add_health(out, p, player, c);
    add_wand(out, picture, player, c);
    add_feed(out, picture, c);
    add_name(out, player, c);
}

std::string clock(double seconds_left) {
    const int whole = static_cast<int>(std::ceil(std::max(seconds_left, 0.0)));
    const int rest = whole % 60;
    return text(whole / 60, rest < 10 ? ":0" : ":", rest);
}

std::string rounds_line(const Picture& picture) {
    return text("rounds ", picture.rounds_won[0], " : ", picture.rounds_won[1]);
}

std::string goal_line(const Picture& picture) {
    const auto goal = text("first to ", picture.kills_to_win);
    return picture.rounds > 1 ? text(rounds_line(picture), ", ", goal) : goal;
}

/// Adds score and clock between the halves.
void add_score(Overlay& out, const Picture& picture, fvec2 middle, float u) {
    out.items.emplace_back(render::RectItem{middle - u * fvec2(96, 27), middle + u * fvec2(96, 27),
                                            colour(0x140E22, 0.8F), 12 * u});
    add_mark(out, 0, middle + u * fvec2(-76, -4), 10 * u);
    add_mark(out, 1, middle + u * fvec2(76, -4), 10 * u);
    const float high = 25 * u;
    add_text(out, text(picture.wizards[0].kills), middle + u * fvec2(-44, -22), high,
             opaque(team_colours(0).light), Align::centre);
    add_text(out, text(picture.wizards[1].kills), middle + u * fvec2(44, -22), high,
             opaque(team_colours(1).light), Align::centre);
    add_text(out, clock(picture.left_s), middle + u * fvec2(0, -19), 19 * u, white, Align::centre);
    add_text(out, goal_line(picture), middle + u * fvec2(0, 7), 11 * u, soft, Align::centre);
}

/// Adds the score of the practice range and the state of the dummy.
void add_practice(Overlay& out, const PracticePicture& practice, fvec2 middle, const Rect& window, float u) {
    add_line(out, practice.score, middle + u * fvec2(0, -22), 17 * u, white, window);
    add_line(out, practice.dummy, middle + u * fvec2(0, 8), 13 * u, soft, window);
}

void add_caption(Overlay& out, const Caption& caption, float top, const Rect& window, float u) {
    if (caption.words.empty()) return;
    add_line(out, caption.words, at(window, 0.5F, 0) + fvec2(0, top), 16 * u,
             caption.fault ? light_red : white, window);
}

struct Announcement {
    std::string head, line, keys;
    fvec4 paint{white};
};

/// Adds a panel in the middle of the window, `tall` units high.
void add_panel(Overlay& out, const Announcement& a, float wide, float tall, const Rect& window, float u) {
    add_veil(out, window, colour(0x0C0616, 0.6F));
    const fvec2 middle = at(window, 0.5F, 0.5F);
    const fvec2 half = 0.5F * u * fvec2(wide, tall);
    out.items.emplace_back(render::RectItem{middle - half, middle + half, colour(0x1C1430, 0.92F), 16 * u});
    const fvec2 top = middle - fvec2(0, half.y);
    add_text(out, a.head, top + u * fvec2(0, 12), 34 * u, a.paint, Align::centre);
    add_text(out, a.line, top + u * fvec2(0, 64), 19 * u, white, Align::centre);
    add_text(out, a.keys, top + u * fvec2(0, tall - 46), 17 * u, soft, Align::centre);
}

void announce(Overlay& out, const Announcement& a, const Rect& window, float u) {
    add_panel(out, a, 460, 156, window, u);
}

// The match statistics table: distance of a side from the middle, and size of its words (units).
constexpr float match_stats_aside = 42, match_stats_size = 15;

/// Width of a panel that holds the longest words (units).
float width_of(const std::vector<ResultRow>& rows) {
    std::size_t longest = 0;
    for (const auto& row : rows)
        for (const auto& words : row.words) longest = std::max(longest, words.size());
    return 2 * (match_stats_aside + em_per_character * match_stats_size * static_cast<float>(longest) + 16);
}

/// Adds the hits of both players: one line for each cause, one side for each player.
void add_match_stats(Overlay& out, const std::vector<ResultRow>& rows, fvec2 top, float u) {
    const std::array<Align, players> aligned{Align::right, Align::left};
    for (std::uint32_t player = 0; player < players; ++player) {
        const float side = player == 0 ? -match_stats_aside : match_stats_aside;
        const auto paint = opaque(team_colours(player).light);
        add_text(out, std::string(team_name(player)), top + u * fvec2(side, 0), 17 * u, paint,
                 aligned[player]);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const float y = result_row * static_cast<float>(i + 1);
            const auto& words = rows[i].words[player];
            add_text(out, words.empty() ? "\u2014" : words, top + u * fvec2(side, y), match_stats_size * u,
                     white, aligned[player]);
        }
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const float y = result_row * static_cast<float>(i + 1);
        add_text(out, std::string(rows[i].cause), top + u * fvec2(0, y), match_stats_size * u, soft,
                 Align::centre);
    }
}

/// The pause panel of a replay. A match has a menu instead.
Announcement pause_of(const Picture& picture) {
    const bool known = picture.paused_by < players;
    return {"Paused", known ? text("by player ", picture.paused_by + 1) : std::string(), "Esc: leave"};
}

std::string name_of_winner(std::uint32_t player) {
    return text("Player ", player + 1, " (", team_name(player), ")");
}

Announcement result_of(const Picture& picture, bool can_play_again) {
    Announcement a;
    const bool last = picture.phase == Phase::over;
    const auto winner = last ? picture.match_winner : picture.winner;
    const auto what = last ? std::string() : text(" round ", picture.round + 1);
    const auto kills = text(picture.kills_to_win, picture.kills_to_win == 1 ? " kill" : " kills");
    const auto how = picture.ending == Ending::kills ? text("first to ", kills) : std::string("time is up");
    if (winner >= players) {
        a.head = last ? "A draw" : text("A draw in", what);
    } else {
        a.head = text(name_of_winner(winner), " wins", what);
        a.paint = opaque(team_colours(winner).light);
    }
    a.line = text(how, "  \u2014  ", picture.wizards[0].kills, " : ", picture.wizards[1].kills);
    if (picture.rounds > 1) a.line += text("  \u2014  ", rounds_line(picture));
    const auto next =
        last ? std::string("Enter, A: again")
             : text("Enter, A: next round (in ", static_cast<int>(std::ceil(picture.next_round_in_s)), " s)");
    a.keys = can_play_again ? text(next, "    Esc, B: leave") : "Esc: leave";
    return a;
}

void add_result(Overlay& out, const Picture& picture, bool can_play_again, const Rect& window, float u) {
    const auto rows = result_rows(picture.match_stats);
    const float table = rows.empty() ? 0 : result_row * static_cast<float>(rows.size() + 1) + 14;
    const float tall = 156 + table, wide = rows.empty() ? 460 : std::max(640.0F, width_of(rows));
    u = std::min({u, 0.96F * static_cast<float>(window.width) / wide,
                  0.96F * static_cast<float>(window.height) / tall});
    add_panel(out, result_of(picture, can_play_again), wide, tall, window, u);
    if (!rows.empty()) add_match_stats(out, rows, at(window, 0.5F, 0.5F) + u * fvec2(0, 100 - tall / 2), u);
}

float unit_of(const Rect& view, const Rect& window, double text_scale) {
    const bool alone = view.width == window.width && view.height == window.height;
    const float high = static_cast<float>(window.height) / 720 * (alone ? 1.35F : 1.05F);
    const float wide = static_cast<float>(view.width) / 420;  // keeps the corners apart
    return std::clamp(std::min(wide, high), 0.4F, 6.0F) * static_cast<float>(text_scale);
}

fvec2 place_of_score(const HudSettings& settings, const Rect& window, float u) {
    const bool stacked = settings.watch == Watch::both && settings.split == render::Split::top_bottom;
    return stacked ? at(window, 0.5F, 0.5F) : at(window, 0.5F, 0) + fvec2(0, 34 * u);
}

void add_seam(Overlay& out, const HudSettings& settings, const Rect& window) {
    if (settings.watch != Watch::both || settings.split == render::Split::none) return;
    const bool stacked = settings.split == render::Split::top_bottom;
    const fvec2 from = stacked ? at(window, 0, 0.5F) : at(window, 0.5F, 0);
    const fvec2 to = stacked ? at(window, 1, 0.5F) : at(window, 0.5F, 1);
    out.items.emplace_back(render::LineItem{from, to, 4, colour(0x0A0614, 1.0F)});
}

}  // namespace

void add_text(render::Overlay& out, std::string words, fvec2 position, float size, fvec4 paint, Align align) {
    const float shift = std::max(1.0F, size / 14);
    out.items.emplace_back(
        render::TextItem{words, position + fvec2(shift), size, colour(0x0A0614, 0.8F * paint.a), align});
    out.items.emplace_back(render::TextItem{std::move(words), position, size, paint, align});
}

void add_mark(Overlay& out, std::uint32_t team, fvec2 centre, float radius) {
    const auto paint = opaque(team_colours(team).light);
    if (team == 0) {
        out.items.emplace_back(render::ArcItem{centre, 0.58F * radius, radius, 0, 3 * third_turn, paint});
        return;
    }
    const auto corner = [&](int i) {
        const float angle = third_turn * static_cast<float>(i);
        return centre + 1.15F * radius * fvec2(std::sin(angle), -std::cos(angle)) + fvec2(0, 0.12F * radius);
    };
    out.items.emplace_back(render::TriangleItem{corner(0), corner(1), corner(2), paint});
}

void make_overlay(const Picture& picture, const HudSettings& settings, render::Size size, Overlay& out) {
    out.items.clear();
    const Rect window{0, 0, size.width, size.height};
    const auto views = views_of(settings, size);
    add_seam(out, settings, window);
    if (settings.menu) return;
    float unit = 0;
    for (std::uint32_t player = 0; player < players; ++player) {
        if (views[player].width <= 0 || views[player].height <= 0) continue;
        unit = unit_of(views[player], window, settings.text_scale);
        add_player(out, picture, player, settings.device_messages[player], {views[player], unit});
        if (settings.forces) add_force_plot(out, picture.wizards[player].force, {views[player], unit});
    }
    const auto middle = place_of_score(settings, window, unit);
    if (picture.practice.on)
        add_practice(out, picture.practice, middle, window, unit);
    else
        add_score(out, picture, middle, unit);
    add_caption(out, picture.caption, middle.y + 42 * unit, window, unit);
    if (picture.overloaded) {
        add_line(out,
                 text("The game fell behind by ", fixed(picture.skipped / 1000.0, 1),
                      " s. Try low picture quality."),
                 at(window, 0.5F, 0) + fvec2(0, (middle.y > 100 * unit ? 8 : 104) * unit), 14 * unit,
                 light_red, window);
    }
    if (picture.mark != 0) {
        add_text(out, text("mark ", picture.mark), middle + fvec2(0, 32 * unit), 15 * unit, soft,
                 Align::centre);
    }
    if (picture.phase != Phase::playing) {
        add_result(out, picture, settings.can_play_again, window, unit);
    } else if (picture.paused) {
        announce(out, pause_of(picture), window, unit);
    }
}

}  // namespace thaum::game
