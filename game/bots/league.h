// game/bots/league.h: bots of different levels against each other: one match of a league, and what many of them come to.
#pragma once
#include <span>

#include "game/bots/duel.h"
#include "game/match/result.h"

namespace thaum::game {

/// Rounds of a match that a league can tell of; rules have no more (rules.cpp).
inline constexpr std::size_t most_rounds = 99;

/// Plain bytes, so that it can be sent from one process to another.
struct LeagueMatch {
    std::array<std::int32_t, players> levels{};
    std::uint64_t seed{};
    std::uint32_t winner{no_player};  ///< of the match
    std::uint32_t rounds{};
    std::array<Tick, most_rounds> lengths{};  ///< ticks of each round
    std::array<std::uint8_t, most_rounds> timed_out{};
    DeedsOfAll deeds{};
    std::array<Tick, players> alive{};  ///< ticks of play
    std::array<Tick, players> dry{};    ///< of those, without the energy for a shot
};

/// The error is one line: a level that does not exist, or its file.
Expected<LeagueMatch> play_league_match(const std::filesystem::path& assets,
                                        std::shared_ptr<const MatchData> data,
                                        std::array<int, players> levels, std::uint64_t seed);

/// Two levels, low < high, over all their matches.
struct LeaguePair {
    std::int32_t low{}, high{};
    std::uint32_t matches{}, low_wins{}, high_wins{};
    /// A draw counts half for each.
    double high_share() const {
        return matches == 0 ? 0 : (high_wins + 0.5 * (matches - low_wins - high_wins)) / matches;
    }
};

struct LeagueLevel {
    std::int32_t level{};
    std::uint32_t shots{}, hits{}, kills{}, deaths{};
    Tick alive{}, dry{};
};

struct LeagueSummary {
    std::vector<LeaguePair> pairs;
    std::vector<LeagueLevel> levels;
    std::vector<double> round_s;                       ///< lengths of all rounds, sorted
    std::uint32_t timed_out{};                         ///< of these rounds
    std::array<std::uint32_t, causes.size()> kills{};  ///< by cause
    std::uint32_t own_deaths{};                        ///< that are nobody's kill
    double median_round_s() const;
};

/// Pairs and levels in order.
LeagueSummary summarise(std::span<const LeagueMatch> matches);

}  // namespace thaum::game
