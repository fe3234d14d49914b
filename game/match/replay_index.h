// game/match/replay_index.h: makes every place of a replay quick to reach.
//
//     log:    0 ------ 2048 ------ 4096 ------ 6144 ---- ... ---- end
//     index:  S         S           S           S                        S: packed state, at keyframes only
//     seek to 5000:                 S --------->
//
// One thread plays the log once, ahead of the viewer, and keeps the states. Another goes to a tick from the newest
// state before it. A state of a stirred brew has 1.7 MB, and its packed form a fraction of that. If all of them
// need more memory than allowed, every second one is dropped, and places take twice as long to reach.
#pragma once
#include <atomic>
#include <mutex>
#include <vector>

#include "game/match/playback.h"

namespace thaum::game {

/// A death in a match.
struct Kill {
    Tick at{};               ///< on the log's clock, Simulation::now
    std::uint32_t victim{};  ///< player who died
    std::uint32_t by{};      ///< player who gets the kill; the victim or no_player: nobody
    bool operator==(const Kill&) const = default;
};

class ReplayIndex {
public:
    static constexpr std::size_t usual_bytes = std::size_t{224} << 20U;

    /// Keeps the state at the log's first tick, where the playback must be. `most_bytes`: memory for all states.
    explicit ReplayIndex(const Playback& at_start, std::size_t most_bytes = usual_bytes);

    /// Plays from the first tick to the log's end, or until `stop` is set. Only one thread may call it.
    void fill(Playback playback, const std::atomic<bool>& stop);

    // Called by any thread.
    /// The index is filled up to this tick.
    Tick reached() const { return reached_; }
    /// Whether nobody will fill the index further.
    bool complete() const { return complete_; }
    /// Says that nobody fills the index.
    void give_up() { complete_ = true; }
    /// Whether the newest state before `target` is here, so that going there is quick.
    bool covers(Tick target) const;
    std::vector<Kill> kills() const;
    /// The first divergence that filling has found.
    std::optional<Divergence> divergence() const;
    /// Memory of all kept states.
    std::size_t bytes() const;
    /// Distance between two kept states (ticks).
    Tick spacing() const;

    /// A kept state.
    struct Keyframe {
        Tick at{};
        std::shared_ptr<const Bytes> packed{};
    };
    /// The newest kept state at or before `target`.
    Keyframe newest_before(Tick target) const;

private:
    void add_state(const Simulation& match);
    void look(const Playback& playback, std::uint64_t& events_seen);

    const std::size_t most_bytes_;
    mutable std::mutex mutex_;
    // Under the mutex:
    std::vector<Keyframe> keyframes_;  ///< by rising tick; the first is tick 0
    std::size_t bytes_ = 0;
    Tick spacing_ = keyframe_interval;
    std::vector<Kill> kills_;
    std::optional<Divergence> divergence_;

    std::atomic<Tick> reached_{0};
    std::atomic<bool> complete_{false};
};

/// Brings the playback to the state after `target` ticks, or to the log's end if that comes first. The state has the
/// same bits as if all ticks had been played. Returns early if `stop` becomes true. The error: a kept state could not
/// be restored.
Expected<void> seek(Playback& playback, const ReplayIndex& index, Tick target, const std::atomic<bool>& stop);

/// The earlier one of two divergences.
std::optional<Divergence> earlier(const std::optional<Divergence>& a, const std::optional<Divergence>& b);

}  // namespace thaum::game
