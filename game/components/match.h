// game/components/match.h: the state of the match, its random numbers and its event log, all on one entity.
#pragma once
#include "core/random.h"
#include "core/units.h"
#include "ecs/component.h"

namespace thaum::game::inline components {

inline constexpr std::uint32_t no_player = 2;

/// A match is one or more rounds. The clock of play stands still between two rounds and after the last one.
enum class Phase : std::uint32_t { playing, between, over };
enum class Ending : std::uint32_t { none, kills, time, great_work, boil_over };

struct Match {
    Tick played{};           ///< ticks of play; does not advance in a pause
    Tick round_began{};      ///< value of `played` when the round began
    std::uint32_t waited{};  ///< ticks spent so far in the current interval between rounds
    Phase phase{};
    Ending ending{};                  ///< how the last finished round ended, such as by kills
    std::uint32_t winner{no_player};  ///< player who won the last finished round; no_player: none yet, or a
                                      ///< draw
    std::uint32_t round{};            ///< number of finished rounds, draws included
    std::array<std::uint32_t, 2> rounds_won{};
    std::uint32_t paused{};  ///< 1 while the match is paused
    std::uint32_t paused_by{no_player};
    std::uint32_t skipped{};  ///< number of device samples skipped because the machine could not keep up
    /// Tick of play at which the round's time was up with equal kills, so that the next death decides it; 0:
    /// not yet.
    Tick boils_over_since{};
    THAUM_COMPONENT(Match, played, round_began, waited, phase, ending, winner, round, rounds_won, paused,
                    paused_by, skipped, boils_over_since);
};

/// Player who has won more rounds, and so the match if it is over; no_player: neither.
inline std::uint32_t ahead(const Match& match) {
    if (match.rounds_won[0] == match.rounds_won[1]) return no_player;
    return match.rounds_won[0] > match.rounds_won[1] ? 0 : 1;
}

/// Random number generators, one per use, so that draws by one system do not shift the sequence of another.
struct Dice {
    Random spread;
    THAUM_COMPONENT(Dice, spread);
};

/// Kinds of event with fixed numbers, because recorded matches contain these numbers. The numbers missing in
/// this list belong to the hits of wands. New kinds are not added here: the source that records a new kind
/// registers it (game/data/event_kinds.h, which names all kinds). It then gets a number above the last one of
/// the list.
enum class EventKind : std::uint32_t {
    none = 0,
    shot = 1,        ///< a shot was fired; detail: kind of event as which its hits are recorded
    object_hit = 3,  ///< a loose thing hit a wizard; detail: surface of the thing (Surface in
                     ///< components/body.h)
    fall = 4,
    death = 5,  ///< a wizard died; detail: kind of event (EventKind) that caused the death
    spawn = 6,  ///< a wizard appeared at a pad, a place to start from; detail: the pad's number
    /// Fire was pressed without enough energy for a shot.
    dry = 7,
    round_end = 8,  ///< a round ended; detail: how it ended (Ending)
    /// A wizard picked up a power-up; detail: its kind (PowerUpKind); amount: health (HP) or energy given.
    power_up = 9,
    round_begin = 10,  ///< a round began; detail: its number (Match::round)
    burst = 13,        ///< a missile burst; detail: kind of event as which its hits are recorded; amount:
                       ///< reach (m)
    ingredient = 14,   ///< an ingredient was picked up; detail: its number
    dropped = 15,      ///< an ingredient was dropped into the brew; detail: its number; amount: volume (m^3)
    /// A player has become the owner of the brew; amount: that player's work in the last 1.5 s (J)
    wrested = 16,
    boiled_over = 17,  ///< the brew boiled over and lost its ingredients; subject: the owner
    spoilt = 18,       ///< a wizard was hurt by a brew that boiled over
    boon = 19,         ///< a well-mixed brew begins to heal its owner; amount: health that it can give (HP)
    cast = 20,         ///< a spell was cast; detail: number of the spell; amount: its strength, 1 for a
                       ///< gentle one
    /// A stroke was not recognised; detail: number of the nearest gesture; amount: its probability.
    unread = 21,
    unfocused = 22,  ///< a spell failed for lack of focus; detail: number of the spell; amount: the missing
                     ///< focus
    fizzled = 23,    ///< a spell had nothing to act on; detail: number of the spell
    held_off = 24,   ///< the Shield spell absorbed harm; detail: kind of event of the harm; amount: that harm
                     ///< (HP)
    pushed = 25,     ///< a spell pushed a wizard; amount: the speed given to the wizard (m/s)
    // From here on, kinds of event about potions (32 to 47).
    potion = 32,       ///< a wizard has brewed and drunk a potion; detail: number of the potion; amount: its
                       ///< duration (s)
    potion_over = 33,  ///< a potion stops acting on a wizard; detail: number of the potion
    brew_step = 34,    ///< a step of a recipe was right; detail: number of right strokes so far, 0 if the
                       ///< step was an ingredient
    brew_fault = 35,   ///< a step of a recipe was wrong; detail: what was wrong (BrewFault)
    poison = 36,       ///< poison hurts a wizard
    /// A player learns the order of a recipe's ingredients, which is drawn at random; detail: number of the
    /// potion, then those of the ingredients, 8 bits each.
    recipe_told = 37,
    work_half = 38,  ///< a wizard holds Azoth or the Lens, which held together win a round (the Great Work)
    work_lost = 39,  ///< a wizard has lost Azoth or the Lens, halves of the Great Work, by dying
    put_away = 40,   ///< a wizard has put a carried ingredient away; detail: number of the ingredient
    /// A wizard who already carries an ingredient stands at another niche (place of ingredients); detail:
    /// number of the niche's ingredient.
    hands_full = 41,
    caught = 42,  ///< a wand has caught a thing that flew at its wizard; amount: the thing's mass (kg)
    // From here on, kinds of event about the orb (48 to 55).
    core_near = 48,  ///< the probe of a wizard who searches (scries) the orb came near its hidden core
    core_lost = 49,  ///< the probe of a wizard who searches the orb left its hidden core
    scried = 50,     ///< the orb gave a wizard its reward; amount: health given (HP)
    unscried = 51,   ///< a wizard at the orb has no focus left, which the search costs
    /// A wizard at the orb switched a haptic mode (a way to feel its flow) on or off; detail: its number;
    /// amount: 1 on, 0 off.
    mode_worn = 52,
    // From here on, kinds of event about crystals and the Great Work (56 and above).
    chipped =
        56,     ///< a hit has melted a part of a crystal; subject: its last carver; amount: volume (voxels)
    lens = 57,  ///< a wizard has carved the key out of a crystal and holds its reward, the Lens
    lens_lost = 58,    ///< a wizard has lost the Lens, the reward for carving a crystal, by dying
    work_begun = 59,   ///< a wizard holds Azoth and the Lens; amount: time to hold both in order to win (s)
    work_broken = 60,  ///< a wizard no longer holds both Azoth and the Lens, so wins nothing by them
    work_done = 61,    ///< a wizard has completed the Great Work, which wins the round
    blunt = 62,        ///< a wizard who carves has no focus left, which carving costs
    tool_taken = 63    ///< a wizard carves with another tool; detail: number of the tool
};

/// Largest number of causes of harm: those of the rules and those of all wands together.
inline constexpr std::size_t max_causes = 16;

struct Event {
    Tick tick{};
    EventKind kind{};
    std::uint32_t subject{no_player};  ///< player to whom the event happened
    std::uint32_t by{no_player};       ///< player who caused the event
    std::uint32_t detail{};
    double amount{};  ///< health taken (HP), unless the comment on the event's kind says otherwise
    vec3 place{};     ///< position of the event (m, world)
    THAUM_FIELDS(Event, tick, kind, subject, by, detail, amount, place);
};

/// Statistics of one player and one cause of harm over the whole match: shots, effects on the other player,
/// own deaths.
struct MatchStats {
    std::uint32_t shots{}, hits{}, kills{};
    /// Deaths of this player by this cause that do not count as kills of the other player.
    std::uint32_t own_deaths{};
    double damage{};  ///< health taken from the other player (HP)
    THAUM_FIELDS(MatchStats, shots, hits, kills, own_deaths, damage);
};

/// Ring buffer of the last events, newest at (count - 1) % size. One tick may record more events than the
/// buffer holds, so readers use EventJournal. match_stats[player][cause] sums over all events of the match.
struct EventLog {
    std::uint64_t count{};
    std::array<Event, 64> events{};
    std::array<std::array<MatchStats, max_causes>, 2> match_stats{};
    THAUM_COMPONENT(EventLog, count, events, match_stats);
};

}  // namespace thaum::game::inline components
