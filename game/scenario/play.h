// game/scenario/play.h: one run of one scenario: a match, the hands that play it, and all that is kept of it. It knows
// nothing of Lua; verbs.cpp brings it to scripts.
#pragma once
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "game/bots/bot.h"
#include "game/match/record.h"
#include "game/match/simulation.h"
#include "game/scenario/force_trace.h"
#include "game/scenario/runner.h"
#include "game/scenario/script_arm.h"
#include "input/log.h"

namespace thaum::game {

/// What a script holds in its hands; becomes one device sample a tick.
struct Hand {
    std::int32_t look_right{}, look_up{};  ///< counts still to be given
    std::int32_t strafe{}, forward{};      ///< -127..127
    std::uint32_t buttons{};
    std::int32_t trigger{255};  ///< how far fire is pulled while it is held
};

/// A match as the script asks for it.
struct MatchWish {
    DataChoice data;
    std::uint64_t seed = 1;
    std::array<int, players> bot_level{};  ///< 0: played by the script
    using Percents = std::array<std::optional<std::uint32_t>, players>;
    Percents force{};   ///< of the device's, for each player; nothing: by the rules
    Percents weight{};  ///< of the weight of what he carries that he feels; nothing: all
    Percents blows{};   ///< likewise of its blows
    std::array<std::array<std::optional<std::uint32_t>, input::fluid_faders>, players>
        modes{};                      ///< and of a brew that he stirs, by haptics::fluid_modes
    std::array<bool, players> arm{};  ///< who holds a real one
};

/// Something that the script has put into the world.
struct SpawnedThing {
    ecs::Entity entity;
    double mass{};  ///< kg
};

/// A file of one line for each tick.
struct Trace {
    std::string name;
    std::string csv;
    std::vector<double (*)(const struct Play&, std::uint32_t)> readers;
    std::vector<std::uint32_t> subjects;  ///< of each reader: a player or a thing
};

/// What hands felt since a trace of forces began.
struct FeltForces {
    ForceRecord record;
    std::string csv;  ///< as of `thaum replay --forces`
};

/// The state before a keyframe tick, from which a run can go on.
struct Keyframe {
    Tick tick{};
    Bytes world;
};

struct Play {
    const ScenarioOptions* options{};
    std::string name;
    bool keeps_files{};  ///< the first of the two runs: log, traces, pictures
    int run{};           ///< 1, 2

    std::shared_ptr<const MatchData> data;
    std::unique_ptr<Simulation> match;  ///< null until the script asked for one
    Bots bots;
    std::array<int, players> bot_level{};
    std::array<Hand, players> hands{};
    ScriptArms arms{};
    Tick behind{};  ///< ticks for which the arms went on while the match stood still

    std::vector<input::InputFrame> frames;  ///< all so far
    std::vector<std::uint64_t> hashes;      ///< after every hash_interval ticks
    std::vector<Keyframe> keyframes;        ///< of matches that can be replayed
    std::vector<Event> events;              ///< all so far
    std::uint64_t events_seen{};            ///< Chronicle::count
    std::size_t events_expected{};          ///< before this one expect_event has looked
    Bytes begun;                            ///< the state before the first tick
    std::vector<Bytes> states;              ///< kept by the script
    std::vector<SpawnedThing> things;
    std::vector<Trace> traces;
    std::optional<FeltForces> felt;
    std::vector<Pixels> pictures;
    std::vector<std::string> files;
    std::string write_fault;  ///< the first file that could not be written, and why; empty: none

    bool no_picture{};  ///< the script asked for a picture, and nobody can draw one
    bool scene_set{};   ///< the script has changed the world itself: its input alone does not lead here
    std::optional<input::LogWriter> log;
    std::filesystem::path log_path;
    std::optional<Tick> save_at;  ///< for looking into a difference
    Bytes saved;

    Tick wait_until{};  ///< Simulation::now
    bool waits{};       ///< a verb has set wait_until
};

Expected<void> begin_match(Play& play, const MatchWish& wish);

/// One tick of the match, with what the hands do.
void tick(Play& play);

/// The match stands still, and then makes up for it, while arms go on.
void stall(Play& play, Tick ticks);

/// From here on the log and the frames do not tell the whole story.
void scene_is_set(Play& play);

/// Closes the log, writes the traces.
void end_match(Play& play);

/// How far the wand in hand is charged or drawn, 0 to 1.
double readiness(const Play& play, std::uint32_t player);

ecs::Entity wizard_entity(const Play& play, std::uint32_t player);
template <class C>
const C& part(const Play& play, std::uint32_t player) {
    return play.match->world().get<C>(wizard_entity(play, player));
}

/// What a hand must still turn, in counts, so that its wizard looks at a place.
struct LookCounts {
    std::int32_t right{}, up{};
};
LookCounts counts_to(const Play& play, std::uint32_t player, vec3 target);

/// Reader of a column "1.x", "2.health", "t3.speed"; null and an error text where there is none.
Expected<void> add_column(const Play& play, const std::string& column, Trace& trace);
/// One line of the trace.
void trace_now(const Play& play, Trace& trace);

/// The same frames in other matches: from the start, and from the keyframe before each tick. Empty, or what differs.
std::string check_seek(const Play& play, const std::vector<Tick>& ticks);
/// The same frames in a match on another thread, which now stands still and now takes many at once.
std::string check_late(const Play& play, std::uint64_t seed);
/// The same frames in a match whose jobs run on `workers` threads beside its own.
std::string check_threads(const Play& play, unsigned workers);

}  // namespace thaum::game
