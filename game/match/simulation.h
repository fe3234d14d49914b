// game/match/simulation.h: a match as a pure function:
// state(t) = f(rules version, data, seed, input up to t).
//
//     Simulation match(data, {.seed = 1, .devices = {...}});
//     while (match.match().phase != Phase::over) match.tick(frame);
//
// Nothing else affects the state: no clock, no thread, no address. At every keyframe (2,048 ticks) the
// physics is rebuilt from the World, so a state saved and restored there continues with the same bits. Any
// other tick is reached by replaying the logged input from the keyframe before it.
#pragma once
#include <memory>

#include "core/bytes.h"
#include "game/stations/cauldron/cauldron.h"
#include "game/stations/crystal/crystal.h"

namespace thaum::game::inline match {

/// Version of the rules. It changes whenever the same input would lead to another state. CHANGELOG.md
/// gives the reasons.
inline constexpr std::uint32_t rules_version = 30;

struct MatchSetup {
    std::uint64_t seed = 1;
    std::vector<input::DeviceSpec> devices;  ///< devices, in the order of the samples in an input frame
    /// Gestures of players who recorded their own; null: those of the match's data. Set by use_profile.
    std::array<std::shared_ptr<const GestureSet>, players> gestures{};
    /// The gestures in `gestures` as profile data, the form in which the log stores them.
    std::vector<input::ProfileData> profile{};
    /// Number of further threads for large computations, besides the calling thread. It does not affect the
    /// match.
    unsigned workers = 0;
};

class Simulation {
public:
    Simulation(std::shared_ptr<const MatchData> data, MatchSetup setup);
    ~Simulation();
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;

    /// Plays one tick of 1 ms with one sample of each device. Play does not advance in a pause and after a
    /// round has ended.
    void tick(const input::InputFrame& frame);
    /// Number of ticks played, pauses included. This is the log's clock.
    Tick now() const { return now_; }

    const ecs::World& world() const;
    /// Write access, for scenarios that build a scene and for tests that corrupt a value. Not for a match
    /// that is logged.
    ecs::World& world_to_change();
    MatchContext& context_to_change();
    const MatchContext& context() const { return context_; }
    /// Switches the recognition of a player's strokes off or on. Not for a match that is logged.
    void leave_strokes_unread(std::uint32_t player, bool unread);
    physics::Physics& physics();
    const physics::Physics& physics() const;
    const MatchData& data() const { return *data_; }
    const std::shared_ptr<const MatchData>& shared_data() const { return data_; }
    const MatchSetup& setup() const { return setup_; }
    const Match& match() const { return world().single<Match>(); }
    /// All events of the last seconds.
    const EventJournal& events() const;

    std::uint64_t state_hash() const;
    /// Hash of the forces commanded to devices since the last multiple of hash_interval.
    std::uint64_t force_hash() const { return force_hash_; }
    /// Magnitude of the force on a player's hand (N). Index: tick of play modulo the size.
    const ForceTrace& felt(std::uint32_t player) const;
    const HapticSetup& haptic_setup() const;
    /// The part that computes the cauldron's brew (game/stations/cauldron/cauldron.h); null if no player has
    /// touched the brew.
    const BrewWork* brew() const;
    /// Data on the crystals that is not part of the state: changed bricks (blocks of voxels), and keys, the
    /// shapes to be carved (game/stations/crystal/crystal.h).
    const CrystalBodies& crystals() const;
    /// Write access to the data on crystals, for scenarios and tests that carve.
    CrystalBodies& crystals_to_change();
    /// Writes the World's snapshot (ecs/snapshot.h). It can be restored only if now() is a multiple of
    /// keyframe_interval.
    void save(Bytes& out) const;
    /// Restores a state that another Simulation of the same data and setup saved at tick `at`, a multiple of
    /// keyframe_interval. Data that is only shown starts anew: older events and forces are lost, and
    /// force_hash() is valid only after the next tick.
    Expected<void> restore(std::span<const std::byte> snapshot, Tick at);
    /// Returns a match that continues this one with other data (game/match/carry_over.h). Its state no longer
    /// follows from its own data, seed and input, so it must not be logged.
    std::unique_ptr<Simulation> continued_with(std::shared_ptr<const MatchData> data) const;
    /// Like continued_with(data), with a setup whose own gestures players have recorded in the meantime. The
    /// setup must have the same seed and devices.
    std::unique_ptr<Simulation> continued_with(std::shared_ptr<const MatchData> data, MatchSetup setup) const;

    /// Systems of the match with their performance counters. The systems of `always` also run in a pause.
    ecs::Schedule& always() { return always_; }
    ecs::Schedule& live() { return live_; }

private:
    void keyframe();

    std::shared_ptr<const MatchData> data_;
    MatchSetup setup_;
    MatchInput input_;
    MatchContext context_;
    BrewResource brew_;
    CrystalResource crystals_;
    Jobs jobs_;  // declared after brew_, so that jobs end before the memory that they use is freed
    ecs::Schedule always_, live_;
    Tick now_ = 0;
    std::uint64_t force_hash_ = 0;
};

}  // namespace thaum::game::inline match
