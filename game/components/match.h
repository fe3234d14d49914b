// game/components/match.h: the state of the match, its random numbers and its event log, all on one entity.
#pragma once
#include "core/random.h"
#include "core/units.h"
#include "ecs/component.h"

namespace thaum::game {

inline constexpr std::uint32_t no_player = 2;

/// A match is one or more rounds. Play stands still between two rounds and after the last one.
enum class Phase : std::uint32_t { playing, between, over };
enum class Ending : std::uint32_t { none, kills, time, great_work };

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
    THAUM_COMPONENT(Match, played, round_began, waited, phase, ending, winner, round, rounds_won, paused,
                    paused_by, skipped);
};

/// Player who has won more rounds, and so the match if it is over; no_player: neither.
inline std::uint32_t ahead(const Match& match) {
    if (match.rounds_won[0] == match.rounds_won[1]) return no_player;
    return match.rounds_won[0] > match.rounds_won[1] ? 0 : 1;
}

/// Random number generators, one per use: one subsystem's draws do not shift another's sequence.
struct Dice {
    Random spread;
    THAUM_COMPONENT(Dice, spread);
};

/// Kinds of event whose numbers recorded matches have. The hits of wands have the numbers that are missing here. New
/// kinds are not listed here: the source that records one registers it, and it has a number above the last
/// (game/data/event_kinds.h, which also names all kinds).
enum class EventKind : std::uint32_t {
    none = 0,
    shot = 1,        ///< detail: EventKind of a hit by this shot
    object_hit = 3,  ///< detail: Surface of the thing (components/body.h)
    fall = 4,
    death = 5,  ///< detail: EventKind that caused the death
    spawn = 6,  ///< detail: number of the pad
    /// Fire was pressed without enough energy for a shot.
    dry = 7,
    round_end = 8,     ///< detail: Ending
    power_up = 9,      ///< detail: PowerUpKind; amount: health (HP) or energy given
    round_begin = 10,  ///< detail: Match::round
    burst = 13,        ///< detail: EventKind of its hits; amount: reach (m)
    ingredient = 14,   ///< an ingredient was picked up; detail: its number
    dropped = 15,      ///< an ingredient was dropped into the brew; detail: its number; amount: volume (m^3)
    wrested = 16,      ///< a player took the brew over; amount: that player's work in the last 1.5 s (J)
    boiled_over = 17,  ///< the brew boiled over and lost its ingredients; subject: the owner
    spoilt = 18,       ///< a wizard was hurt by a brew that boiled over
    boon = 19,         ///< a well-mixed brew begins to heal its owner; amount: health that it can give (HP)
    cast = 20,         ///< a spell was cast; detail: its number; amount: its strength, 1 for a gentle one
    unread = 21,  ///< a stroke meant nothing; detail: number of the nearest gesture; amount: its probability
    unfocused = 22,  ///< a spell failed for lack of focus; detail: its number; amount: the focus that lacked
    fizzled = 23,    ///< a spell had nothing to act on; detail: its number
    held_off = 24,   ///< a shield took harm; detail: EventKind of the harm; amount: that harm (HP)
    pushed = 25,     ///< a spell pushed a wizard; amount: the speed that it gave (m/s)
    // Numbers from 32 on are those of potions.
    potion = 32,       ///< a wizard has brewed and drunk a potion; detail: its number; amount: time (s)
    potion_over = 33,  ///< a potion ends to act on a wizard; detail: its number
    brew_step = 34,    ///< a step of a recipe was right; detail: number of right strokes, 0: an ingredient
    brew_fault = 35,   ///< a step of a recipe was wrong; detail: BrewFault
    poison = 36,       ///< poison hurts a wizard
    recipe_told = 37,  ///< a player learns a drawn recipe; detail: potion, then its ingredients, 8 bits each
    work_half = 38,    ///< a wizard holds half of the Great Work
    work_lost = 39,    ///< a wizard has lost it by death
    put_away = 40,     ///< a wizard has put a carried ingredient away; detail: its number
    hands_full =
        41,       ///< a wizard who carries one ingredient stands at the niche of another; detail: its number
    caught = 42,  ///< a wand has caught a thing that flew to its wizard; amount: its mass (kg)
    // Numbers from 48 on are those of the orb.
    core_near = 48,  ///< the probe of a wizard who scries came near the hidden core
    core_lost = 49,  ///< that probe left it
    scried = 50,     ///< the orb told a wizard what it tells; amount: health given (HP)
    unscried = 51,   ///< a wizard who scried has no focus left
    mode_worn = 52,  ///< a wizard put a mode on or took it off; detail: its number; amount: 1 on, 0 off
    // Numbers from 56 on are those of crystals and of the Great Work.
    chipped =
        56,     ///< a hit has melted a part of a crystal; subject: its last carver; amount: volume (voxels)
    lens = 57,  ///< a wizard has carved the key and holds the Lens
    lens_lost = 58,  ///< a wizard has lost it by death
    work_begun =
        59,  ///< a wizard holds both halves of the Great Work; amount: time that they must be held (s)
    work_broken = 60,  ///< a wizard has lost one of them again
    work_done = 61,    ///< a wizard has completed the Great Work
    blunt = 62,        ///< a wizard has no focus left for carving
    tool_taken = 63    ///< a wizard carves with another tool; detail: its number
};

/// Largest number of causes of harm, over the rules and all wands.
inline constexpr std::size_t most_causes = 16;

struct Event {
    Tick tick{};
    EventKind kind{};
    std::uint32_t subject{no_player};  ///< player to whom the event happened
    std::uint32_t by{no_player};       ///< player who caused the event
    std::uint32_t detail{};
    double amount{};  ///< health taken (HP), unless EventKind says otherwise
    vec3 place{};     ///< position (m, world)
    THAUM_FIELDS(Event, tick, kind, subject, by, detail, amount, place);
};

/// Statistics of one player and one cause over the whole match: shots, effects on the other player, own
/// deaths.
struct MatchStats {
    std::uint32_t shots{}, hits{}, kills{};
    /// Deaths of this player by this cause that count as no kill of the other player.
    std::uint32_t own_deaths{};
    double damage{};  ///< health taken from the other player (HP)
    THAUM_FIELDS(MatchStats, shots, hits, kills, own_deaths, damage);
};

/// Ring buffer of the last events, newest at (count - 1) % size. A tick may record more than it holds, so
/// readers take events from EventJournal. match_stats[player][cause] sums over all events of the match.
struct EventLog {
    std::uint64_t count{};
    std::array<Event, 64> events{};
    std::array<std::array<MatchStats, most_causes>, 2> match_stats{};
    THAUM_COMPONENT(EventLog, count, events, match_stats);
};

}  // namespace thaum::game
