#include "game/hud/result_panel.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/text.h"
#include "game/data/teams.h"
#include "game/hud/overlay.h"

namespace thaum::game::inline hud {
namespace {

using render::Align;
using render::colour;
using render::Overlay;
using render::Rect;

struct Announcement {
    std::string head, line, keys;
    fvec4 paint{paints.white};
};

// Margin, gaps, widths and text sizes of the panel (HUD units).
constexpr float sheet_margin = 12, sheet_gap = 6, narrowest = 360, widest = 1000;
constexpr float head_size = 34, line_size = 19, keys_size = 17;
// Table of hits: distance of each player's column from the middle, space below a row, text size of the rows
// and of the players' names above them (HUD units).
constexpr float table_aside = 42, table_gap = 3, table_size = 15, table_head = 17;
constexpr float any_height = 1e5F;

struct Cells {
    std::array<FittedWords, players> words;
    float high() const { return std::max(words[0].height(), words[1].height()) + table_gap; }
};

/// The texts of the result or pause panel, broken into lines that fit its width. Lengths are in HUD units.
struct Sheet {
    FittedWords head, line, keys;
    std::vector<Cells> rows{};  ///< the table of hits; its first row has the players' names
    float wide{}, tall{};
    bool whole = true;  ///< true: no text had to be made smaller
};

/// Breaks the texts of a panel for a given width.
Sheet sheet_of(const Announcement& a, const std::vector<ResultRow>& rows, const PlayerNames& names,
               float wide) {
    Sheet out{.head = {}, .line = {}, .keys = {}, .wide = wide};
    const auto fitted = [&](std::string_view words, float size, fvec2 room) {
        auto lines = fit(words, size, room);
        out.whole = out.whole && lines.size == size;
        return lines;
    };
    const float inner = wide - 2 * sheet_margin;
    out.head = fitted(a.head, head_size, {inner, FittedWords::line_spacing * head_size});
    out.line = fitted(a.line, line_size, {inner, any_height});
    out.keys = fitted(a.keys, keys_size, {inner, any_height});
    out.tall = 2 * sheet_margin + out.head.height() + out.line.height() + out.keys.height() + 2 * sheet_gap;
    if (rows.empty()) return out;
    const fvec2 column(wide / 2 - table_aside - sheet_margin, any_height);
    Cells& heads = out.rows.emplace_back();
    for (std::uint32_t player = 0; player < players; ++player)
        heads.words[player] = fitted(name_of(names, player), table_head, column);
    for (const auto& row : rows) {
        Cells& cells = out.rows.emplace_back();
        for (std::uint32_t player = 0; player < players; ++player)
            cells.words[player] =
                fitted(row.words[player].empty() ? "\u2014" : row.words[player], table_size, column);
    }
    for (const auto& row : out.rows) out.tall += row.high();
    out.tall += sheet_gap;
    return out;
}

/// Length of a HUD unit with which a panel fits the window, at most `wanted` (px).
float unit_of(const Sheet& sheet, const Rect& window, float wanted) {
    return std::min({wanted, 0.96F * static_cast<float>(window.width) / sheet.wide,
                     0.96F * static_cast<float>(window.height) / sheet.tall});
}

/// Of all layouts of a panel, the one with the largest text that fits the window. Among equals, the one of
/// least height, then of least width.
Sheet best_sheet(const Announcement& a, const std::vector<ResultRow>& rows, const PlayerNames& names,
                 const Rect& window, float wanted) {
    std::optional<Sheet> best;
    float best_unit = 0;
    for (float wide = narrowest; wide <= widest; wide += 20) {
        auto sheet = sheet_of(a, rows, names, wide);
        if (!sheet.whole && wide + 20 <= widest) continue;
        const float unit = unit_of(sheet, window, wanted);
        const bool better = !best || unit > 1.001F * best_unit ||
                            (unit > 0.999F * best_unit && sheet.tall < best->tall - 0.5F);
        if (!better) continue;
        best_unit = unit;
        best = std::move(sheet);
    }
    return std::move(*best);
}

/// All values on which the choice of the layout depends.
struct SheetKey {
    std::array<std::string, 3> words;
    std::vector<ResultRow> rows;
    PlayerNames names;
    std::array<float, 3> sizes{};  ///< width and height of the window, and wanted length of a HUD unit (px)
    bool operator==(const SheetKey&) const = default;
};

/// Result of best_sheet, which is kept from call to call. best_sheet tries many widths, and a panel shows the
/// same texts for seconds.
const Sheet& kept_sheet(const Announcement& a, const std::vector<ResultRow>& rows, const PlayerNames& names,
                        const Rect& window, float wanted) {
    thread_local std::optional<std::pair<SheetKey, Sheet>> kept;
    SheetKey key{{a.head, a.line, a.keys},
                 rows,
                 names,
                 {static_cast<float>(window.width), static_cast<float>(window.height), wanted}};
    if (!kept || kept->first != key) kept.emplace(std::move(key), best_sheet(a, rows, names, window, wanted));
    return kept->second;
}

/// Adds lines of text downwards from a position.
void add_lines(Overlay& out, const FittedWords& words, fvec2 top, float u, fvec4 paint, Align align) {
    for (const auto& line : words.lines) {
        add_text(out, line, top, std::floor(u * words.size), paint, align);
        top.y += u * words.line_height();
    }
}

/// Adds the hits of both players: one row for each cause, one side for each player.
void add_table(Overlay& out, const Sheet& sheet, const std::vector<ResultRow>& rows, fvec2 top, float u) {
    const std::array<Align, players> aligned{Align::right, Align::left};
    for (std::size_t i = 0; i < sheet.rows.size(); ++i) {
        for (std::uint32_t player = 0; player < players; ++player) {
            const float side = player == 0 ? -table_aside : table_aside;
            const auto paint = i == 0 ? opaque(team_colours(player).light) : paints.white;
            add_lines(out, sheet.rows[i].words[player], top + u * fvec2(side, 0), u, paint, aligned[player]);
        }
        if (i > 0)
            add_text(out, std::string(rows[i - 1].cause), top, std::floor(table_size * u), paints.soft,
                     Align::centre);
        top.y += u * sheet.rows[i].high();
    }
}

/// Adds a panel in the middle of the window, over everything else.
void add_panel(Overlay& out, const Announcement& a, const std::vector<ResultRow>& rows,
               const PlayerNames& names, const Rect& window, float wanted) {
    const auto& sheet = kept_sheet(a, rows, names, window, wanted);
    const float u = unit_of(sheet, window, wanted);
    add_veil(out, window, colour(0x0C0616, 0.6F));
    const fvec2 middle{static_cast<float>(window.x) + 0.5F * static_cast<float>(window.width),
                       static_cast<float>(window.y) + 0.5F * static_cast<float>(window.height)};
    const fvec2 half = 0.5F * u * fvec2(sheet.wide, sheet.tall);
    out.items.emplace_back(render::RectItem{middle - half, middle + half, colour(0x1C1430, 1.0F), 16 * u});
    fvec2 top = middle - fvec2(0, half.y - sheet_margin * u);
    add_lines(out, sheet.head, top, u, a.paint, Align::centre);
    top.y += u * sheet.head.height();
    add_lines(out, sheet.line, top, u, paints.white, Align::centre);
    top.y += u * (sheet.line.height() + sheet_gap);
    add_table(out, sheet, rows, top, u);
    top.y = middle.y + half.y - u * (sheet_margin + sheet.keys.height());
    add_lines(out, sheet.keys, top, u, paints.soft, Align::centre);
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
    const auto how = picture.ending == Ending::kills        ? text("first to ", kills)
                     : picture.ending == Ending::great_work ? std::string("by the Great Work")
                     : picture.ending == Ending::boil_over  ? std::string("in the Boil-over")
                                                            : std::string("time is up");
    if (winner >= players) {
        a.head = last ? "A draw" : text("A draw in", what);
    } else {
        a.head = text(name_of(settings.names, winner), " wins", what);
        a.paint = opaque(team_colours(winner).light);
    }
    a.line = text(how, "  \u2014  ", picture.wizards[0].vitals.kills, " : ", picture.wizards[1].vitals.kills);
    if (picture.rounds > 1) a.line += text("  \u2014  ", rounds_of(picture));
    const auto next =
        last ? std::string("Enter, A: rematch")
             : text("Enter, A: next round (in ", static_cast<int>(std::ceil(picture.next_round_in_s)), " s)");
    a.keys = settings.can_play_again ? text(next, "    Esc, B: quit", settings.has_menu ? " to menu" : "")
                                     : "Esc: leave";
    return a;
}

/// Length of a HUD unit at the text size of the settings (px).
float wanted_unit(const HudSettings& settings, const Rect& window) {
    const float share =
        std::min(static_cast<float>(window.width) / 640, static_cast<float>(window.height) / 690);
    return share * static_cast<float>(settings.text_scale);
}

}  // namespace

void add_result_panel(Overlay& out, const Picture& picture, const HudSettings& settings, Rect window) {
    add_panel(out, result_of(picture, settings), result_rows(picture.match_stats), settings.names, window,
              wanted_unit(settings, window));
}

void add_pause_panel(Overlay& out, const Picture& picture, const HudSettings& settings, Rect window) {
    add_panel(out, pause_of(picture, settings), {}, settings.names, window, wanted_unit(settings, window));
}

}  // namespace thaum::game::inline hud
