// game/match/replay_index.h: makes it quick to jump to any tick of a replay.
//
//     log:    0 ------ 2048 ------ 4096 ------ 6144 ---- ... ---- end
//     index:  S         S           S           S                        S: compressed state (keyframes only)
//     seek to 5000:                 S --------->
//
// One thread plays the log once, ahead of the viewer, and stores the states. Another thread reaches a tick by
// replaying from the newest state before it. A state of a stirred brew has 1.7 MB, and its compressed form a
// fraction of that. If all states need more memory than allowed, every second one is dropped, and jumps take
// twice as long.
#pragma once
#include <atomic>
#include <mutex>
#include <vector>

#include "game/match/playback.h"

namespace thaum::game::inline match {

/// A death in a match, with the player who is credited with it as a kill.
struct Kill {
    Tick at{};               ///< time on the log's clock, Simulation::now (ticks)
    std::uint32_t victim{};  ///< player who died
    std::uint32_t by{};      ///< player who is credited with the kill; the victim or no_player: no one
    bool operator==(const Kill&) const = default;
};

class ReplayIndex {
public:
    static constexpr std::size_t usual_bytes = std::size_t{224} << 20U;

    /// Stores the state at the log's first tick, where the playback must be. `max_bytes`: memory limit for
    /// all states.
    explicit ReplayIndex(const Playback& at_start, std::size_t max_bytes = usual_bytes);

    /// Fills the index by playing from the first tick to the log's end, or until `stop` is set. Only one
    /// thread may call it.
    void fill(Playback playback, const std::atomic<bool>& stop);

    // Any thread may call the following functions.

    /// Tick up to which the index is filled.
    Tick reached() const { return reached_; }
    /// Whether no thread fills the index any further.
    bool complete() const { return complete_; }
    /// Marks the index as one that is no longer filled.
    void give_up() { complete_ = true; }
    /// Whether the index is filled as far as the state from which a jump to `target` continues, so that the
    /// jump is quick.
    bool covers(Tick target) const;
    std::vector<Kill> kills() const;
    /// The first difference between replay and record that was found while filling the index.
    std::optional<Divergence> divergence() const;
    /// Memory used by all stored states (bytes).
    std::size_t bytes() const;
    /// Distance between two stored states (ticks).
    Tick spacing() const;

    /// A stored state of the match, from which a replay can continue.
    struct Keyframe {
        Tick at{};
        std::shared_ptr<const Bytes> packed{};
    };
    /// The newest stored state at or before `target`.
    Keyframe newest_before(Tick target) const;

private:
    void add_state(const Simulation& match);
    void look(const Playback& playback, std::uint64_t& events_seen);

    const std::size_t max_bytes_;
    mutable std::mutex mutex_;
    // The mutex guards the following members:
    std::vector<Keyframe> keyframes_;  ///< stored states in increasing order of tick; the first is at tick 0
    std::size_t bytes_ = 0;
    Tick spacing_ = keyframe_interval;
    std::vector<Kill> kills_;
    std::optional<Divergence> divergence_;

    std::atomic<Tick> reached_{0};
    std::atomic<bool> complete_{false};
};

/// Brings the playback to the state after `target` ticks, or to the log's end if that comes first. The state
/// has the same bits as if all ticks had been played. Returns early if `stop` becomes true. The error says
/// that a stored state could not be restored.
Expected<void> seek(Playback& playback, const ReplayIndex& index, Tick target, const std::atomic<bool>& stop);

/// The earlier one of two differences between replay and record.
std::optional<Divergence> earlier(const std::optional<Divergence>& a, const std::optional<Divergence>& b);

}  // namespace thaum::game::inline match
