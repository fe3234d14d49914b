// game/components/match.h: the match itself, as one entity.
#pragma once
#include <algorithm>

#include "core/random.h"
#include "core/units.h"
#include "ecs/component.h"

namespace thaum::game {

using ecs::field;

inline constexpr std::uint32_t no_player = 2;

/// A match is one or more rounds; between two of them, and after the last, play stands still.
enum class Phase : std::uint32_t { playing, between, over };
enum class Ending : std::uint32_t { none, kills, time };

struct Match {
    Tick played{};           ///< ticks of play; stands still in a pause
    Tick round_began{};      ///< `played` at the round's beginning
    std::uint32_t waited{};  ///< ticks between rounds, so far
    Phase phase{};
    Ending ending{};                  ///< of the last round that ended
    std::uint32_t winner{no_player};  ///< of that round; no_player: nobody yet, or a draw
    std::uint32_t round{};            ///< rounds that have ended before this one, draws included
    std::array<std::uint32_t, 2> rounds_won{};
    std::uint32_t paused{};  ///< 1: paused
    std::uint32_t paused_by{no_player};
    std::uint32_t skipped{};  ///< samples left out because the machine could not keep up
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

/// Who has won more rounds: at the end, the match. no_player: neither.
inline std::uint32_t ahead(const Match& match) {
    if (match.rounds_won[0] == match.rounds_won[1]) return no_player;
    return match.rounds_won[0] > match.rounds_won[1] ? 0 : 1;
}

/// One generator per use, so that one subsystem's throws do not shift another's.
struct Dice {
    Random spread;
    static constexpr std::string_view name = "Dice";
    static constexpr auto fields() { return std::tuple(field("spread", &Dice::spread)); }
};

/// What happened, for picture, sound, scenarios and reports.
enum class EventKind : std::uint32_t {
    none,
    shot,  ///< detail: the EventKind of its hit
    bolt_hit,
    object_hit,
    fall,
    death,  ///< detail: the EventKind that did it
    spawn,  ///< detail: number of the pad
    dry,
    round_end,    ///< detail: Ending
    power_up,     ///< detail: PowerUpKind; amount: HP or energy given
    round_begin,  ///< detail: Match::round
    blast_hit,
    lob_hit,
    burst,        ///< detail: the EventKind of its hits; amount: m, how far it reaches
    ingredient,   ///< picked up; detail: its number
    dropped,      ///< an ingredient into the brew; detail: its number; amount: m^3
    wrested,      ///< the brew, from the other; amount: J, done in the last second and a half
    boiled_over,  ///< the brew, spoilt; subject: whose it was
    spoilt        ///< hurt by that
};
inline constexpr std::array<std::string_view, 19> event_names{
    "none",       "shot",      "bolt_hit", "object_hit",  "fall",      "death",   "spawn",
    "dry",        "round_end", "power_up", "round_begin", "blast_hit", "lob_hit", "burst",
    "ingredient", "dropped",   "wrested",  "boiled_over", "spoilt"};

/// What can take health, as the kinds of event that say so, and what people call it.
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
/// Index into `causes`; their number where it is none.
constexpr std::size_t cause_of(EventKind kind) {
    for (std::size_t i = 0; i < causes.size(); ++i) {
        if (causes[i].kind == kind) return i;
    }
    return causes.size();
}

struct Event {
    Tick tick{};
    EventKind kind{};
    std::uint32_t subject{no_player};  ///< the player it happened to
    std::uint32_t by{no_player};       ///< the player who did it
    std::uint32_t detail{};
    double amount{};  ///< HP, or as the kind says
    vec3 place{};     ///< m, world
    static constexpr auto fields() {
        return std::tuple(field("tick", &Event::tick), field("kind", &Event::kind),
                          field("subject", &Event::subject), field("by", &Event::by),
                          field("detail", &Event::detail), field("amount", &Event::amount),
                          field("place", &Event::place));
    }
};

/// What one player has done to the other by one cause, over the whole match.
struct Deeds {
    std::uint32_t shots{}, hits{}, kills{};
    std::uint32_t own_deaths{};  ///< of this player, by this cause, that are nobody else's deed
    double damage{};             ///< HP
    static constexpr auto fields() {
        return std::tuple(field("shots", &Deeds::shots), field("hits", &Deeds::hits),
                          field("kills", &Deeds::kills), field("own_deaths", &Deeds::own_deaths),
                          field("damage", &Deeds::damage));
    }
};

/// The last events, the newest at (count - 1) % size, and the sum of all: deeds[player][cause].
struct Chronicle {
    std::uint64_t count{};
    std::array<Event, 64> events{};
    std::array<std::array<Deeds, causes.size()>, 2> deeds{};
    static constexpr std::string_view name = "Chronicle";
    static constexpr auto fields() {
        return std::tuple(field("count", &Chronicle::count), field("events", &Chronicle::events),
                          field("deeds", &Chronicle::deeds));
    }
};

/// Calls f(event) for what came since `seen` (of Chronicle::count), which moves on. Returns how many had already been
/// written over by newer ones: more than a Chronicle holds came between two calls.
template <class F>
std::uint64_t each_new_event(const Chronicle& chronicle, std::uint64_t& seen, F f) {
    const auto held = std::min<std::uint64_t>(chronicle.count, chronicle.events.size());
    const auto lost = std::max(seen, chronicle.count - held) - seen;
    for (seen += lost; seen < chronicle.count; ++seen) f(chronicle.events[seen % chronicle.events.size()]);
    return lost;
}

}  // namespace thaum::game
