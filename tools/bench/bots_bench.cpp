// Benchmarks the time that the bots of a duel take in a tick, for several levels, and for comparison the time
// of the match itself.
#include <algorithm>

#include "game/bots/bot_file.h"
#include "tools/bench/areas.h"
#include "tools/bench/match_scene.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

/// Bots decide only once in this many ticks, so the time of a tick is the mean over this number of ticks.
constexpr Tick together = game::gameplay_period;

void measure_bots(const Options& options, const game::BotFile& bot, Report& report) {
    auto data = duel_data();
    if (!data) return;
    auto duel = game::make_bot_duel(game::find_assets(), data, {bot.name, bot.name}, 1);
    if (!there(duel, "tick/bots")) return;
    std::vector<double> bots_us(options.quick ? 2'500 : 15'000);
    double match_us = 0;
    for (auto& us : bots_us) {
        double bots = 0;
        for (Tick t = 0; t < together; ++t) {
            const double start = now_us();
            const auto frame = duel->next_frame();
            const double asked = now_us();
            duel->match->tick(frame);
            bots += asked - start;
            match_us += now_us() - asked;
        }
        us = bots / static_cast<double>(together);
    }
    const double bots_mean = mean(bots_us);
    const double match_mean = match_us / static_cast<double>(bots_us.size() * together);
    report.rows.push_back(
        {.area = "tick",
         .name = "bots",
         .setting = {{"bots", std::int64_t{game::players}}, {"level", std::int64_t{bot.skill.level}}},
         .time_us = times(bots_us),
         .is_default = true,
         .metrics = {{"mean_us", bots_mean},
                     {"match_us", match_mean},
                     {"share_of_tick", bots_mean / (bots_mean + match_mean)},
                     {"ticks", static_cast<double>(bots_us.size() * together)}},
         .hash = hex(duel->match->state_hash())});
}

}  // namespace

void tick_bots(const Options& options, Report& report) {
    for (const auto& bot : game::list_bots(game::find_assets()))
        if (there(bot.file, "tick/bots")) measure_bots(options, *bot.file, report);
}

}  // namespace thaum::bench
