#include "game/bots/league.h"

#include <algorithm>

#include "game/data/wand_slots.h"

namespace thaum::game::inline bots {
namespace {

void note_balance(const Match& match, const RoundCount& count, LeagueMatch& result) {
    BalanceSums sums{.kills = static_cast<std::uint32_t>(count.kills.size()),
                     .lead_changes = count.lead_changes,
                     .by_great_work = match.ending == Ending::great_work ? 1U : 0U,
                     .for_nobody = match.winner >= players ? 1U : 0U};
    for (std::size_t source = 0; source < magic_sources; ++source)
        sums.rounds_with[source] = count.used[0][source] || count.used[1][source] ? 1 : 0;
    for (std::size_t i = 0; i < count.kills.size(); ++i) {
        sums.magic_kills += count.kills[i].magic ? 1 : 0;
        if (i == 0)
            result.first_kills[result.rounds] = count.kills[i].waited;
        else if (result.waits < kept_waits)
            result.between_kills[result.waits++] = count.kills[i].waited;
    }
    result.balance.add(sums);
}

void note_round_end(const Match& match, LeagueMatch& result) {
    result.lengths[result.rounds] = match.played - match.round_began;
    result.timed_out[result.rounds] =
        match.ending == Ending::time || (match.ending == Ending::boil_over && match.winner >= players) ? 1
                                                                                                       : 0;
    ++result.rounds;
}

/// Adds one gameplay tick to the time of each living player, and to the time without energy for a shot if the
/// player lacks it.
void note_energy(const Simulation& match, LeagueMatch& result) {
    match.world().view<const Wizard, const WandBelt, ecs::Without<Dead>>().each(
        [&](const Wizard& wizard, const WandBelt& belt) {
            result.alive[wizard.player] += gameplay_period;
            const auto* wand = wand_in_hand(match.data(), belt);
            const bool dry = wand != nullptr && energy_in_hand(match.data(), belt) < wand->stats.energy_cost;
            if (dry) result.dry[wizard.player] += gameplay_period;
        });
}

template <class Row, class Same>
Row& row_of(std::vector<Row>& rows, const Row& fresh, Same same) {
    const auto found = std::find_if(rows.begin(), rows.end(), same);
    return found == rows.end() ? rows.emplace_back(fresh) : *found;
}

void add_to_pair(const LeagueMatch& match, LeagueSummary& summary) {
    const auto low = std::min(match.bots[0], match.bots[1]);
    const auto high = std::max(match.bots[0], match.bots[1]);
    auto& pair = row_of(summary.pairs, LeaguePair{.low = low, .high = high},
                        [&](const LeaguePair& p) { return p.low == low && p.high == high; });
    ++pair.matches;
    if (match.winner >= players) return;
    // If both bots are equal, player 0 counts as the lower one.
    const bool high_won = low == high ? match.winner == 1 : match.bots[match.winner] == high;
    high_won ? ++pair.high_wins : ++pair.low_wins;
}

void add_to_bot(const LeagueMatch& match, std::uint32_t player, LeagueSummary& summary) {
    const auto bot = match.bots[player];
    auto& row = row_of(summary.bots, LeagueBot{.bot = bot}, [&](const LeagueBot& b) { return b.bot == bot; });
    row.alive += match.alive[player];
    row.dry += match.dry[player];
    for (std::size_t cause = 0; cause < causes().size(); ++cause) {
        const auto& own = match.match_stats[player][cause];
        row.shots += own.shots;
        row.hits += own.shots > 0 ? own.hits : 0;
        row.kills += own.kills;
        const auto deaths = own.own_deaths + match.match_stats[1 - player][cause].kills;
        row.deaths += deaths;
        if (cause == cause_of(EventKind::fall)) row.falls += deaths;
        summary.kills[cause] += own.kills;
        summary.own_deaths += own.own_deaths;
    }
}

void add_balance(const LeagueMatch& match, LeagueSummary& summary) {
    summary.balance.add(match.balance);
    for (std::uint32_t round = 0; round < match.rounds; ++round)
        if (match.first_kills[round] > 0) summary.first_kill_s.push_back(seconds(match.first_kills[round]));
    for (std::uint32_t i = 0; i < match.waits; ++i)
        summary.between_kills_s.push_back(seconds(match.between_kills[i]));
}

}  // namespace

void BalanceSums::add(const BalanceSums& other) {
    for (std::size_t source = 0; source < magic_sources; ++source)
        rounds_with[source] += other.rounds_with[source];
    kills += other.kills;
    magic_kills += other.magic_kills;
    lead_changes += other.lead_changes;
    by_great_work += other.by_great_work;
    for_nobody += other.for_nobody;
}

Expected<LeagueMatch> play_league_match(const std::filesystem::path& assets,
                                        std::shared_ptr<const MatchData> data,
                                        std::span<const std::string> names,
                                        std::array<std::int32_t, players> bots, std::uint64_t seed) {
    const auto name_of = [&](std::int32_t bot) { return names[static_cast<std::size_t>(bot)]; };
    auto duel = make_bot_duel(assets, std::move(data), {name_of(bots[0]), name_of(bots[1])}, seed);
    if (!duel) return duel.error();
    const auto& match = *duel->match;
    LeagueMatch result{.bots = bots, .seed = seed};
    BalanceCounter counter;
    std::uint64_t seen = 0;
    while (match.match().phase != Phase::over) {
        const bool played = match.match().phase == Phase::playing;
        duel->match->tick(duel->next_frame());
        match.events().each_new(seen, [&](const Event& event) { counter.note(event); });
        if (!played) continue;
        if (match.match().phase != Phase::playing) {
            note_balance(match.match(), counter.round(), result);
            note_round_end(match.match(), result);
        }
        if (match.match().played % gameplay_period == 0) note_energy(match, result);
    }
    result.winner = ahead(match.match());
    result.match_stats = match.world().single<EventLog>().match_stats;
    return result;
}

double LeagueSummary::median_round_s() const { return round_s.empty() ? 0 : round_s[round_s.size() / 2]; }

LeagueSummary summarise(std::span<const LeagueMatch> matches) {
    LeagueSummary summary;
    for (const auto& match : matches) {
        add_to_pair(match, summary);
        if (match.winner < players) ++summary.seat_wins[match.winner];
        for (std::uint32_t player = 0; player < players; ++player) add_to_bot(match, player, summary);
        add_balance(match, summary);
        for (std::uint32_t round = 0; round < match.rounds; ++round) {
            summary.round_s.push_back(seconds(match.lengths[round]));
            summary.timed_out += match.timed_out[round];
        }
    }
    for (auto* times : {&summary.round_s, &summary.first_kill_s, &summary.between_kills_s})
        std::sort(times->begin(), times->end());
    std::sort(summary.bots.begin(), summary.bots.end(),
              [](const auto& a, const auto& b) { return a.bot < b.bot; });
    std::sort(summary.pairs.begin(), summary.pairs.end(), [](const auto& a, const auto& b) {
        return std::pair(a.low, a.high) < std::pair(b.low, b.high);
    });
    return summary;
}

}  // namespace thaum::game::inline bots
