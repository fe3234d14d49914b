// game/scenario/play.h: one run of one scenario: a match, its simulated hands, and everything recorded of it.
// This file does not depend on Lua; verbs.cpp makes it available to scripts. Types of the match are only
// declared, not included, because their headers are long and most verbs need only components and the
// functions below.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/bytes.h"
#include "ecs/entity.h"
#include "game/components/match.h"
#include "game/components/wizard.h"
#include "game/scenario/force_trace.h"
#include "game/scenario/runner.h"
#include "input/frame.h"

namespace thaum::ecs {
class World;
}
namespace thaum::input {
class LogWriter;
}
namespace thaum::physics {
class Physics;
}

namespace thaum::game::inline bots {
class Bots;
}
namespace thaum::game::inline data {
struct MatchData;
struct OrbRules;
struct Presentation;
}  // namespace thaum::game::inline data

namespace thaum::game::inline scenario {

class PlaySenses;
struct MatchOptions;
struct ScriptArm;
using ScriptArms = std::array<std::unique_ptr<ScriptArm>, players>;

/// State of a scripted player's input, from which a device sample is made in each tick.
struct Hand {
    std::int32_t look_right{}, look_up{};    ///< mouse counts still to be sent
    std::int32_t drawn_right{}, drawn_up{};  ///< mouse counts added in the coming tick
    std::int32_t stick_right{}, stick_up{};  ///< deflection of the stick that turns the view, -127 to 127
    std::int32_t strafe{}, forward{};        ///< wanted motion to the right and ahead, -127 to 127
    std::uint32_t buttons{};
    std::uint8_t wand{};        ///< wand whose key is down, 1 to input::max_wands; 0: none
    std::int32_t trigger{255};  ///< pull of the trigger while fire is held, 0 to 255 (full)
    /// changes of the forces' strengths (faders) that are still to be sent, one per tick
    std::vector<input::FaderChange> changes{};
};

/// A thing that the script has added to the world.
struct SpawnedThing {
    ecs::Entity entity;
    double mass{};  ///< mass of the added thing (kg)
};

/// A CSV file with one line for each tick.
struct Trace {
    std::string name;
    std::string csv;
    std::vector<double (*)(const struct Play&, std::uint32_t)> readers;
    /// index of the player or thing whose value each function in `readers` reads
    std::vector<std::uint32_t> subjects;
};

/// Forces on the hands since the force trace began.
struct FeltForces {
    ForceRecord record;
    std::string csv;  ///< rows in the format of `thaum replay --forces`
};

/// The state at a keyframe (a multiple of keyframe_interval ticks), from which a run can continue.
struct Keyframe {
    Tick tick{};
    Bytes world;
};

struct Play {
    Play();
    ~Play();
    Play(const Play&) = delete;
    Play& operator=(const Play&) = delete;

    const ScenarioOptions* options{};
    std::string name;
    bool keeps_files{};  ///< true in the first run, which writes log, traces and pictures
    int run{};           ///< number of the run, 1 or 2

    std::shared_ptr<const MatchData> data;
    std::unique_ptr<Simulation> match;  ///< null until the script calls match{}
    std::unique_ptr<Bots> bots;         ///< null unless a bot plays
    std::array<std::string, players> bot{};
    std::array<Hand, players> hands{};
    ScriptArms arms;
    Tick behind{};  ///< number of ticks that the arms have run while the match was stopped

    std::vector<input::InputFrame> frames;  ///< all input frames since the start
    std::vector<std::uint64_t> hashes;      ///< state hashes, one after every hash_interval ticks
    /// states every keyframe_interval ticks, if the match can be replayed
    std::vector<Keyframe> keyframes;
    std::vector<Event> events;  ///< all events since the start
    /// number of events recorded by the match (EventLog::count) up to the last one that `events` has
    std::uint64_t events_seen{};
    std::size_t events_expected{};  ///< index of the first event that expect_event has not examined
    Bytes begun;                    ///< saved state of the match before its first tick
    std::vector<Bytes> states;      ///< states saved by the script
    std::vector<SpawnedThing> things;
    std::vector<Trace> traces;
    std::optional<FeltForces> felt;
    std::unique_ptr<PlaySenses> senses;  ///< null until the script calls senses{}
    std::vector<Pixels> pictures;
    std::vector<std::string> files;
    std::string write_fault;  ///< first file that could not be written, with the reason; empty: none

    bool no_picture{};  ///< true: the script asked for a picture, but no picture function is set
    /// True: the script has changed the world, so the input alone does not lead to this state.
    bool scene_set{};
    std::unique_ptr<input::LogWriter> log;
    std::filesystem::path log_path;
    /// tick at which the state is copied to `saved`, to find out how two runs differ
    std::optional<Tick> save_at;
    Bytes saved;

    Tick wait_until{};  ///< tick at which the wait ends, compared with Simulation::now
    bool waits{};       ///< true: the script waits until `wait_until`
};

/// Begins the match that a script asks for (game/scenario/match_options.h).
Expected<void> begin_match(Play& play, const MatchOptions& wanted);

/// Plays one tick of the match with the input of all hands.
void tick(Play& play);

/// Stops the match for some ticks while the simulated arms continue, then lets the match catch up.
void stall(Play& play, Tick ticks);

/// Notes that the script has changed the world, so that log and frames no longer determine the match.
void scene_is_set(Play& play);

/// Closes the log and writes the traces.
void end_match(Play& play);

/// Text of the force trace, a table of the forces on both hands; std::nullopt: the script did not ask for
/// one.
std::optional<std::string> force_trace_of(Play& play);
/// Number of ticks in which the match computed another force than an arm's thread. It must be 0.
std::uint64_t differing_forces(const Play& play);

// These functions read a match that has begun, for the runner and the verbs (the functions that scripts
// call).

/// Ticks played, pauses included.
Tick now_of(const Play& play);
/// Ticks played, without pauses.
Tick played_in(const Play& play);
/// Hash of the match's state.
std::uint64_t state_hash_of(const Play& play);
/// Writes the match's present state.
void save_state(const Play& play, Bytes& out);

const ecs::World& world_of(const Play& play);
ecs::World& world_to_change(Play& play);
physics::Physics& physics_of(Play& play);
const Presentation& presentation_of(const Play& play);
/// Rules of the orb; null if the match has none.
const OrbRules* orb_rules_of(const Play& play);

/// Charge or draw of the wand in hand, 0 to 1.
double readiness(const Play& play, std::uint32_t player);

ecs::Entity wizard_entity(const Play& play, std::uint32_t player);

/// Value of the column `with` in the table of events, such as the cause of a hit; empty if the event has
/// none.
std::string with_of(const Play& play, const Event& event);
/// Records an event that did not happen in the match, so that it is heard and felt.
void record_by_hand(Play& play, const Event& event);

/// A missile in flight.
struct FlyingMissile {
    vec3 position{}, velocity{};
    std::uint32_t player{};
    double size{};
};
/// All missiles, in the order of the wands.
std::vector<FlyingMissile> missiles_of(const Play& play);

/// A kind of event that is heard or felt, with the names of its sound and of its effect; an empty name: none.
struct SensedKind {
    std::string_view kind, sound, tactile;
};
/// All kinds that are heard or felt, in the order of their numbers.
std::vector<SensedKind> sensed_kinds_of(const Play& play);

/// Velocity of the brew at a place (m/s, world). Zero outside the brew.
vec3 current_at(const Play& play, vec3 place);
/// Height of the brew's surface at a position (m, world). The match must have a cauldron.
double surface_at(const Play& play, vec3 place);
/// Name of an ingredient of the cauldron.
const std::string& ingredient_name(const Play& play, std::size_t ingredient);

/// The orb's hidden core, the axis of its strongest vortex, in the device frame of a wizard who works at the
/// orb.
struct CoreInHand {
    vec3 place{}, axis{};
};
/// The orb's hidden core, if this player's wizard works at the orb; else std::nullopt.
std::optional<CoreInHand> core_in_hand(const Play& play, std::uint32_t player);

/// Mouse counts that turn a wizard towards a place.
struct LookCounts {
    std::int32_t right{}, up{};
};
LookCounts counts_to(const Play& play, std::uint32_t player, vec3 target);

/// Starts to record the forces on both hands.
void begin_force_trace(Play& play);
/// Adds to a trace a column such as "1.x", "2.health" or "t3.speed". The error says that there is no such
/// column.
Expected<void> add_column(const Play& play, const std::string& column, Trace& trace);
/// Adds one line with the present values to the trace.
void trace_now(const Play& play, Trace& trace);

/// Plays the same input frames in other matches: from the start, and from the saved state (keyframe) before
/// each tick. Returns an empty string, or the difference.
std::string check_seek(const Play& play, const std::vector<Tick>& ticks);
/// Plays the same frames in a match on another thread. That thread stalls at times and then takes many frames
/// at once.
std::string check_late(const Play& play, std::uint64_t seed);
/// Plays the same frames in a match with `workers` extra job threads.
std::string check_threads(const Play& play, unsigned workers);
/// Plays the same frames in two matches. In one, hearing and feeling are computed with these layouts until
/// the tick `quit`. Compares states and forces.
std::string check_senses(const Play& play, const std::vector<std::string>& layouts, Tick quit);

}  // namespace thaum::game::inline scenario
