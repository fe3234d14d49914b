#include "game/hud/result_panel.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "game/hud/figures.h"
#include "game/hud/overlay.h"

namespace thaum::game {
namespace {

using render::Align;
using render::colour;
using render::Overlay;
using render::Rect;

struct Announcement {
    std::string head, line, keys;
    fvec4 paint{paints.white};
};

// Sizes in units. The table of hits: distance of a side from the middle, height of a row, size of its words.
constexpr float panel_wide = 460, panel_high = 156;
constexpr float table_aside = 42, table_row = 23, table_size = 15, table_head = 17;

fvec2 middle_of(const Rect& window) {
    return {static_cast<float>(window.x) + 0.5F * static_cast<float>(window.width),
            static_cast<float>(window.y) + 0.5F * static_cast<float>(window.height)};
}

/// Adds a panel in the middle of the window, `wide` and `tall` units large.
void add_panel(Overlay& out, const Announcement& a, float wide, float tall, const Rect& window, float u) {
    add_veil(out, window, colour(0x0C0616, 0.6F));
    const fvec2 middle = middle_of(window);
    const fvec2 half = 0.5F * u * fvec2(wide, tall);
    out.items.emplace_back(render::RectItem{middle - half, middle + half, colour(0x1C1430, 0.92F), 16 * u});
    const auto row = [&](float top, float high, const std::string& words, float size, fvec4 paint) {
        const float from = middle.y - half.y + top * u, aside = half.x - 12 * u;
        add_text_in(out, {{middle.x - aside, from}, {middle.x + aside, from + high * u}}, words, size * u,
                    paint, Align::centre);
    };
    row(12, 46, a.head, 34, a.paint);
    row(64, 30, a.line, 19, paints.white);
    row(tall - 46, 34, a.keys, 17, paints.soft);
}

/// Width of a panel that holds the longest words of the table (units).
float table_width_of(const std::vector<ResultRow>& rows, const PlayerNames& names) {
    float widest = 0;
    for (std::uint32_t player = 0; player < players; ++player)
        widest = std::max(widest, width_of(name_of(names, player), table_head));
    for (const auto& row : rows)
        for (const auto& words : row.words) widest = std::max(widest, width_of(words, table_size));
    return 2 * (table_aside + widest + 16);
}

/// Adds the hits of both players: one line for each cause, one side for each player.
void add_match_stats(Overlay& out, const HudSettings& settings, const std::vector<ResultRow>& rows, fvec2 top,
                     float u) {
    const std::array<Align, players> aligned{Align::right, Align::left};
    for (std::uint32_t player = 0; player < players; ++player) {
        const float side = player == 0 ? -table_aside : table_aside;
        const auto paint = opaque(team_colours(player).light);
        add_text(out, std::string(name_of(settings.names, player)), top + u * fvec2(side, 0), table_head * u,
                 paint, aligned[player]);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const float y = table_row * static_cast<float>(i + 1);
            const auto& words = rows[i].words[player];
            add_text(out, words.empty() ? "\u2014" : words, top + u * fvec2(side, y), table_size * u,
                     paints.white, aligned[player]);
        }
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const float y = table_row * static_cast<float>(i + 1);
        add_text(out, std::string(rows[i].cause), top + u * fvec2(0, y), table_size * u, paints.soft,
                 Align::centre);
    }
}

Announcement pause_of(const Picture& picture, const HudSettings& settings) {
    const bool known = picture.paused_by < players;
    return {"Paused", known ? text("by ", name_of(settings.names, picture.paused_by)) : std::string(),
            "Esc: leave"};
}

std::string rounds_of(const Picture& picture) {
    return text("rounds ", picture.rounds_won[0], " : ", picture.rounds_won[1]);
}

Announcement result_of(const Picture& picture, const HudSettings& settings) {
    Announcement a;
    const bool last = picture.phase == Phase::over;
    const auto winner = last ? picture.match_winner : picture.winner;
    const auto what = last ? std::string() : text(" round ", picture.round + 1);
    const auto kills = text(picture.kills_to_win, picture.kills_to_win == 1 ? " kill" : " kills");
    const auto how = picture.ending == Ending::kills ? text("first to ", kills) : std::string("time is up");
    if (winner >= players) {
        a.head = last ? "A draw" : text("A draw in", what);
    } else {
        a.head = text(name_of(settings.names, winner), " wins", what);
        a.paint = opaque(team_colours(winner).light);
    }
    a.line = text(how, "  \u2014  ", picture.wizards[0].kills, " : ", picture.wizards[1].kills);
    if (picture.rounds > 1) a.line += text("  \u2014  ", rounds_of(picture));
    const auto next =
        last ? std::string("Enter, A: rematch")
             : text("Enter, A: next round (in ", static_cast<int>(std::ceil(picture.next_round_in_s)), " s)");
    a.keys = settings.can_play_again ? text(next, "    Esc, B: quit to menu") : "Esc: leave";
    return a;
}

}  // namespace

void add_result_panel(Overlay& out, const Picture& picture, const HudSettings& settings, Rect window,
                      float unit) {
    const auto rows = result_rows(picture.match_stats);
    const float table = rows.empty() ? 0 : table_row * static_cast<float>(rows.size() + 1) + 14;
    const float tall = panel_high + table,
                wide = rows.empty() ? panel_wide : std::max(640.0F, table_width_of(rows, settings.names));
    unit = std::min({unit, 0.96F * static_cast<float>(window.width) / wide,
                     0.96F * static_cast<float>(window.height) / tall});
    add_panel(out, result_of(picture, settings), wide, tall, window, unit);
    if (!rows.empty())
        add_match_stats(out, settings, rows, middle_of(window) + unit * fvec2(0, 100 - tall / 2), unit);
}

void add_pause_panel(Overlay& out, const Picture& picture, const HudSettings& settings, Rect window,
                     float unit) {
    unit = std::min({unit, 0.96F * static_cast<float>(window.width) / panel_wide,
                     0.96F * static_cast<float>(window.height) / panel_high});
    add_panel(out, pause_of(picture, settings), panel_wide, panel_high, window, unit);
}

}  // namespace thaum::game
