// game/components/match.h: the match itself, as one entity.
#pragma once
#include "core/random.h"
#include "core/units.h"
#include "ecs/component.h"

namespace thaum::game {

using ecs::field;

inline constexpr std::uint32_t no_player = 2;

enum class Phase : std::uint32_t { playing, over };
enum class Ending : std::uint32_t { none, kills, time };

struct Match {
    Tick played{};  ///< ticks of play; stands still in a pause
    Phase phase{};
    Ending ending{};
    std::uint32_t winner{no_player};  ///< no_player: nobody yet, or a draw
    std::uint32_t paused{};           ///< 1: paused
    std::uint32_t paused_by{no_player};
    std::uint32_t skipped{};  ///< samples left out because the machine could not keep up
    static constexpr std::string_view name = "Match";
    static constexpr auto fields() {
        return std::tuple(field("played", &Match::played), field("phase", &Match::phase),
                          field("ending", &Match::ending), field("winner", &Match::winner),
                          field("paused", &Match::paused), field("paused_by", &Match::paused_by),
                          field("skipped", &Match::skipped));
    }
};

/// One generator per use, so that one subsystem's throws do not shift another's.
struct Dice {
    Random spread;
    static constexpr std::string_view name = "Dice";
    static constexpr auto fields() { return std::tuple(field("spread", &Dice::spread)); }
};

/// What happened, for picture, sound, scenarios and reports.
enum class EventKind : std::uint32_t { none, shot, bolt_hit, object_hit, fall, death, spawn, dry, round_end };
inline constexpr std::array<std::string_view, 9> event_names{
    "none", "shot", "bolt_hit", "object_hit", "fall", "death", "spawn", "dry", "round_end"};

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

/// The last events, the newest at (count - 1) % size.
struct Chronicle {
    std::uint64_t count{};
    std::array<Event, 32> events{};
    static constexpr std::string_view name = "Chronicle";
    static constexpr auto fields() {
        return std::tuple(field("count", &Chronicle::count), field("events", &Chronicle::events));
    }
};

}  // namespace thaum::game
