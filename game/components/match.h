// game/components/match.h: the state of the match, its random numbers and its event log, all on one entity.
#pragma once
#include <algorithm>

#include "core/random.h"
#include "core/units.h"
#include "ecs/component.h"

namespace thaum::game {

using ecs::field;

inline constexpr std::uint32_t no_player = 2;

/// A match is one or more rounds. Play stands still between two rounds and after the last one.
enum class Phase : std::uint32_t { playing, between, over };
enum class Ending : std::uint32_t { none, kills, time };

struct Match {
    Tick played{};           ///< ticks of play; does not advance in a pause
    Tick round_began{};      ///< value of `played` when the round began
    std::uint32_t waited{};  ///< ticks spent so far in the current interval between rounds
    Phase phase{};
    Ending ending{};                  ///< how the last finished round ended
    std::uint32_t winner{no_player};  ///< winner of the last finished round; no_player: none yet, or a draw
    std::uint32_t round{};            ///< number of finished rounds, draws included
    std::array<std::uint32_t, 2> rounds_won{};
    std::uint32_t paused{};  ///< 1 while the match is paused
    std::uint32_t paused_by{no_player};
    std::uint32_t skipped{};  ///< number of samples left out because the machine could not keep up
    static constexpr std::string_view name = "Match";
    static constexpr auto fields() {
        return std::tuple(field("played", &Match::played), field("round_began", &Match::round_began),
                          field("waited", &Match::waited), field("phase", &Match::phase),
                          field("ending", &Match::ending), field("winner", &Match::winner),
                          field("round", &Match::round), field("rounds_won", &Match::rounds_won),
                          field("paused", &Match::paused), field("paused_by", &Match::paused_by),
                          field("skipped", &Match::skipped));
    }
};

/// Player who has won more rounds, and so the match if it is over; no_player: neither.
inline std::uint32_t ahead(const Match& match) {
    if (match.rounds_won[0] == match.rounds_won[1]) return no_player;
    return match.rounds_won[0] > match.rounds_won[1] ? 0 : 1;
}

/// Random number generators, one per use: one subsystem's draws do not shift another's sequence.
struct Dice {
    Random spread;
    static constexpr std::string_view name = "Dice";
    static constexpr auto fields() { return std::tuple(field("spread", &Dice::spread)); }
};

/// Kinds of event. Renderer, sound, scenarios and reports read them.
enum class EventKind : std::uint32_t {
    none,
    shot,  ///< detail: EventKind of a hit by this shot
    bolt_hit,
    object_hit,
    fall,
    death,  ///< detail: EventKind that caused the death
    spawn,  ///< detail: number of the pad
    /// Fire was pressed without enough energy for a shot.
    dry,
    round_end,    ///< detail: Ending
    power_up,     ///< detail: PowerUpKind; amount: health (HP) or energy given
    round_begin,  ///< detail: Match::round
    blast_hit,
    lob_hit,
    burst,        ///< detail: EventKind of its hits; amount: reach (m)
    ingredient,   ///< an ingredient was picked up; detail: its number
    dropped,      ///< an ingredient was dropped into the brew; detail: its number; amount: volume (m^3)
    wrested,      ///< a player took the brew over; amount: that player's work in the last 1.5 s (J)
    boiled_over,  ///< the brew boiled over and lost its ingredients; subject: the owner
    spoilt        ///< a wizard was hurt by a brew that boiled over
};
inline constexpr std::array<std::string_view, 19> event_names{
    "none",       "shot",      "bolt_hit", "object_hit",  "fall",      "death",   "spawn",
    "dry",        "round_end", "power_up", "round_begin", "blast_hit", "lob_hit", "burst",
    "ingredient", "dropped",   "wrested",  "boiled_over", "spoilt"};

/// Kind of event that takes health, with the name shown to people.
struct Cause {
    EventKind kind{};
    std::string_view name;
};
inline constexpr std::array<Cause, 6> causes{{{EventKind::bolt_hit, "bolt"},
                                              {EventKind::blast_hit, "blast"},
                                              {EventKind::lob_hit, "lob"},
                                              {EventKind::object_hit, "blow"},
                                              {EventKind::fall, "fall"},
                                              {EventKind::spoilt, "brew"}}};
/// Index in `causes`; causes.size() if the kind takes no health.
constexpr std::size_t cause_of(EventKind kind) {
    for (std::size_t i = 0; i < causes.size(); ++i) {
        if (causes[i].kind == kind) return i;
    }
    return causes.size();
}

struct Event {
    Tick tick{};
    EventKind kind{};
    std::uint32_t subject{no_player};  ///< player to whom the event happened
    std::uint32_t by{no_player};       ///< player who caused the event
    std::uint32_t detail{};
    double amount{};  ///< health taken (HP), unless EventKind says otherwise
    vec3 place{};     ///< position (m, world)
    static constexpr auto fields() {
        return std::tuple(field("tick", &Event::tick), field("kind", &Event::kind),
                          field("subject", &Event::subject), field("by", &Event::by),
                          field("detail", &Event::detail), field("amount", &Event::amount),
                          field("place", &Event::place));
    }
};

/// Statistics of one player and one cause over the whole match: shots, effects on the other player, own
/// deaths.
struct MatchStats {
    std::uint32_t shots{}, hits{}, kills{};
    /// Deaths of this player by this cause that count as no kill of the other player.
    std::uint32_t own_deaths{};
    double damage{};  ///< health taken from the other player (HP)
    static constexpr auto fields() {
        return std::tuple(field("shots", &MatchStats::shots), field("hits", &MatchStats::hits),
                          field("kills", &MatchStats::kills), field("own_deaths", &MatchStats::own_deaths),
                          field("damage", &MatchStats::damage));
    }
};

/// Ring buffer of the last events, newest at (count - 1) % size. match_stats[player][cause] sums over all
/// events of the match.
struct EventLog {
    std::uint64_t count{};
    std::array<Event, 64> events{};
    std::array<std::array<MatchStats, causes.size()>, 2> match_stats{};
    static constexpr std::string_view name = "EventLog";
    static constexpr auto fields() {
        return std::tuple(field("count", &EventLog::count), field("events", &EventLog::events),
                          field("match_stats", &EventLog::match_stats));
    }
};

/// Calls f(event) for each event since `seen`, an earlier value of EventLog::count, and advances `seen`.
/// Returns the number of events lost because newer ones had already overwritten them.
template <class F>
std::uint64_t each_new_event(const EventLog& event_log, std::uint64_t& seen, F f) {
    const auto held = std::min<std::uint64_t>(event_log.count, event_log.events.size());
    const auto lost = std::max(seen, event_log.count - held) - seen;
    for (seen += lost; seen < event_log.count; ++seen) f(event_log.events[seen % event_log.events.size()]);
    return lost;
}

}  // namespace thaum::game
