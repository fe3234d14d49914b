#include "game/match/result.h"

#include "core/text.h"

namespace thaum::game::inline match {
namespace {

void add_part(std::string& words, const std::string& part) { words += text(words.empty() ? "" : ", ", part); }

std::string counted(std::uint32_t count, std::string_view one, std::string_view many) {
    return text(count, " ", count == 1 ? one : many);
}

std::string words_of(const MatchStats& d) {
    std::string words;
    if (d.shots > 0) {
        add_part(words, text(d.hits, " of ", d.shots, " hit (", (200 * d.hits / d.shots + 1) / 2, " %)"));
    } else if (d.hits > 0) {
        add_part(words, counted(d.hits, "hit", "hits"));
    }
    if (d.damage > 0) add_part(words, text(fixed(d.damage, 0), " HP"));
    if (d.kills > 0) add_part(words, counted(d.kills, "kill", "kills"));
    if (d.own_deaths > 0) add_part(words, text(d.own_deaths, " of their own"));
    return words;
}

}  // namespace

std::vector<ResultRow> result_rows(const AllMatchStats& match_stats) {
    std::vector<ResultRow> rows;
    for (std::size_t cause = 0; cause < causes().size(); ++cause) {
        ResultRow row{causes()[cause], {words_of(match_stats[0][cause]), words_of(match_stats[1][cause])}};
        if (!row.words[0].empty() || !row.words[1].empty()) rows.push_back(std::move(row));
    }
    return rows;
}

std::string result_table(const Simulation& match) {
    const auto& world = match.world();
    const auto rows = result_rows(world.single<EventLog>().match_stats);
    std::string lines;
    for (std::uint32_t player = 0; player < players; ++player) {
        const auto e = wizard_of(world, player);
        const auto& score = world.get<Score>(e);
        lines += text("player ", player + 1, "   ",
                      counted(static_cast<std::uint32_t>(score.deaths), "death", "deaths"), ", ",
                      fixed(world.get<Health>(e).points, 0), " HP left\n");
        for (const auto& row : rows) {
            if (!row.words[player].empty()) lines += text("  ", row.cause, "     ", row.words[player], "\n");
        }
    }
    return lines;
}

}  // namespace thaum::game::inline match
