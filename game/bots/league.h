// game/bots/league.h: matches between different bots, and a summary of many such matches.
#pragma once
#include <span>
#include <string>
#include <type_traits>

#include "game/bots/balance.h"
#include "game/bots/duel.h"
#include "game/match/result.h"

namespace thaum::game::inline bots {

/// Largest number of rounds in a result; the rules of a match allow no more (data/rules.cpp).
inline constexpr std::size_t max_rounds = 99;

/// Largest number of times between kills that are kept of a match; later ones are not counted. A match of the
/// shipped rules has about 30 kills at most.
inline constexpr std::size_t kept_waits = 64;

/// What the rounds of one match, or of many, say of their balance.
struct BalanceSums {
    std::array<std::uint32_t, magic_sources> rounds_with{};  ///< rounds in which some player used the source
    std::uint32_t kills{}, magic_kills{}, lead_changes{};
    std::uint32_t by_great_work{};  ///< rounds that the Great Work decided
    std::uint32_t for_nobody{};     ///< rounds without a winner

    void add(const BalanceSums& other);
};

/// Result of one match of a league. It holds plain bytes, so that it can be sent between processes.
struct LeagueMatch {
    /// Place of each player's bot in the list of the league's bots, the weakest first.
    std::array<std::int32_t, players> bots{};
    std::uint64_t seed{};
    std::uint32_t winner{no_player};  ///< winner of the match; no_player: a draw
    std::uint32_t rounds{};
    std::array<Tick, max_rounds> lengths{};  ///< length of each round (ticks)
    std::array<std::uint8_t, max_rounds> timed_out{};
    AllMatchStats match_stats{};
    std::array<Tick, players> alive{};  ///< time alive (ticks of play)
    std::array<Tick, players> dry{};    ///< part of `alive` without energy for a shot (ticks)
    BalanceSums balance{};
    /// Time from the beginning of each round to its first kill (ticks); 0: no kill
    std::array<Tick, max_rounds> first_kills{};
    std::uint32_t waits{};                         ///< number of values in `between_kills`
    std::array<Tick, kept_waits> between_kills{};  ///< times between two kills of a round (ticks)
};

static_assert(std::is_trivially_copyable_v<LeagueMatch>);

/// Plays a match of two bots, of which the league's list `names` has the two at `bots`. The error names a bot
/// that does not exist, or a fault in its file.
Expected<LeagueMatch> play_league_match(const std::filesystem::path& assets,
                                        std::shared_ptr<const MatchData> data,
                                        std::span<const std::string> names,
                                        std::array<std::int32_t, players> bots, std::uint64_t seed);

/// Results of all matches between two bots, by their places in the league's list, low <= high.
struct LeaguePair {
    std::int32_t low{}, high{};
    std::uint32_t matches{}, low_wins{}, high_wins{};
    /// Share of matches won by the bot of the higher place. A draw counts half for each.
    double high_share() const {
        return matches == 0 ? 0 : (high_wins + 0.5 * (matches - low_wins - high_wins)) / matches;
    }
};

/// Results of one bot over all its matches.
struct LeagueBot {
    std::int32_t bot{};  ///< place in the league's list
    std::uint32_t shots{}, hits{}, kills{}, deaths{};
    std::uint32_t falls{};  ///< part of `deaths` by a fall
    Tick alive{}, dry{};
};

struct LeagueSummary {
    std::vector<LeaguePair> pairs;
    std::vector<LeagueBot> bots;
    /// Matches won by player 0 and by player 1. In a fair arena both win equally often, since every seed is
    /// played with each of the two bots in both seats.
    std::array<std::uint32_t, players> seat_wins{};
    std::vector<double> round_s;  ///< lengths of all rounds, sorted (s)
    std::uint32_t timed_out{};    ///< number of rounds that no death decided before their time was up
    std::array<std::uint32_t, max_causes> kills{};  ///< kills by cause
    std::uint32_t own_deaths{};                     ///< deaths for which no player is credited with a kill
    BalanceSums balance{};
    /// Times from the beginning of a round to its first kill, and between two kills of a round; sorted (s)
    std::vector<double> first_kill_s, between_kills_s;
    double median_round_s() const;
};

/// Summarises matches. Pairs and bots are sorted.
LeagueSummary summarise(std::span<const LeagueMatch> matches);

}  // namespace thaum::game::inline bots
