// game/match/simulation.h: a match as a pure function: state(t) = f(rules version, data, seed, input up to t).
//
//     Simulation match(data, {.seed = 1, .devices = {...}});
//     while (!match.over()) match.tick(frame);
//
// Nothing else reaches it: no clock, no thread, no address. At every keyframe (2,048 ticks) the physics is rebuilt from
// the World, so a state saved there and restored goes on to the same bits; any other tick is reached from the keyframe
// before it by running on with the logged input.
#pragma once
#include <memory>
#include <optional>

#include "core/bytes.h"
#include "game/match/stage.h"

namespace thaum::game {

/// Changes whenever the same input would lead to another state (and says why in the history of this line's file).
inline constexpr std::uint32_t rules_version = 15;

struct MatchSetup {
    std::uint64_t seed = 1;
    std::vector<input::DeviceSpec> devices;  ///< in the order of the frame's samples
    unsigned workers = 0;  ///< threads for large work beside the caller's; the same match with any number
};

class Simulation {
public:
    Simulation(std::shared_ptr<const MatchData> data, MatchSetup setup);
    ~Simulation();
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;

    /// One tick of 1 ms with one sample of each device. In a pause, and after the round has ended, time stands still.
    void tick(const input::InputFrame& frame);
    /// Ticks done so far, pauses included: the log's clock.
    Tick now() const { return now_; }

    const ecs::World& world() const;
    /// For scenarios that set a scene, and for spoiling a value on purpose; not for a match that is logged.
    ecs::World& world_to_change();
    physics::Physics& physics();
    const physics::Physics& physics() const;
    const MatchData& data() const { return *data_; }
    const MatchSetup& setup() const { return setup_; }
    const Match& match() const { return world().single<Match>(); }

    std::uint64_t state_hash() const;
    /// Of the forces that devices were told since the last multiple of hash_interval.
    std::uint64_t force_hash() const { return force_hash_; }
    /// Length of the force on a player's hand, N, at tick t of play in place t mod size.
    const ForceTrace& felt(std::uint32_t player) const;
    const Touch& touch() const;
    /// What computes the cauldron's brew (game/cauldron/cauldron.h); null where nobody has touched one.
    const BrewWork* brew() const;
    /// The World's snapshot (ecs/snapshot.h). Restorable only where now() is a multiple of keyframe_interval.
    void save(Bytes& out) const;
    /// Goes on from a state that another Simulation of the same data and setup saved at tick `at`, a keyframe.
    Expected<void> restore(std::span<const std::byte> snapshot, Tick at);
    /// A match that goes on from here by other data (game/match/carry_over.h). Its state is then no longer what its own data,
    /// seed and input would have come to: not for a match that is logged.
    std::unique_ptr<Simulation> continued_with(std::shared_ptr<const MatchData> data) const;

    /// The systems with their counts; `always` run in a pause as well.
    ecs::Schedule& always() { return always_; }
    ecs::Schedule& live() { return live_; }

private:
    void keyframe();

    std::shared_ptr<const MatchData> data_;
    MatchSetup setup_;
    std::unique_ptr<Stage> stage_;
    Jobs jobs_;  // after the stage, which jobs work on until they end
    ecs::Schedule always_, live_;
    Tick now_ = 0;
    std::uint64_t force_hash_ = 0;
};

}  // namespace thaum::game
