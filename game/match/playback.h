// game/match/playback.h: replays a log without devices and compares each recorded hash with the recomputed
// one.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "game/match/record.h"

namespace thaum::game::inline match {

/// A recorded hash and the hashes that the replay computed at the same tick, at least one of which differs.
struct Divergence {
    input::HashRecord recorded;
    std::uint64_t state{};
    std::uint64_t force{};
};

/// Text of a divergence: "tick 128: state differs: the log has ..., here it is ...".
std::string described(const Divergence&);

/// A log and the match that is recomputed from it.
class Playback {
public:
    /// Opens a log. The error is one line: the file is not a log, a damaged header, another rules version, or
    /// changed data.
    static Expected<Playback> open(const std::filesystem::path& log, const std::filesystem::path& assets);
    /// Opens the same log once more, at its first tick. The error also says if the file has been replaced by
    /// another match.
    Expected<Playback> open_again() const;

    const input::LogReader& log() const { return *log_; }
    const Simulation& match() const { return *match_; }
    Simulation& match() { return *match_; }

    /// Plays one tick and compares the state with the log's hash for this tick, if there is one. Returns
    /// false at the log's end.
    bool step();
    /// Plays until `tick` ticks are done in total. Returns false if the log is shorter.
    bool play_to(Tick tick);
    /// Continues from a state that another Playback of the same log saved at tick `at`, which must be a
    /// keyframe (a multiple of keyframe_interval).
    Expected<void> restore(std::span<const std::byte> snapshot, Tick at);
    /// Input frame of the last tick that was played.
    const input::InputFrame& frame() const { return frame_; }
    /// The log's hash at the tick just played, and the computed one. std::nullopt if they agree, or if the
    /// log has no hash for this tick.
    std::optional<Divergence> mismatch() const;
    /// The first difference from the recorded hashes that was found. After it, the replay no longer shows the
    /// recorded match.
    const std::optional<Divergence>& divergence() const { return divergence_; }

    /// One line that says why equal hashes do not prove the replay; empty if they do. The log may have no
    /// hashes, lack one at a multiple of 128 ticks or, if it was closed properly, lack the hash of its last
    /// tick. For a log that was cut off, the hashes prove the replay up to the last hash.
    std::string missing_hashes() const;
    /// One line if a properly closed log stores another result than the match has now; else empty.
    std::string wrong_result() const;

private:
    Playback() = default;
    std::filesystem::path path_, assets_;
    std::unique_ptr<input::LogReader> log_;
    std::unique_ptr<Simulation> match_;
    input::InputFrame frame_;
    std::optional<Divergence> divergence_;
};

}  // namespace thaum::game::inline match
