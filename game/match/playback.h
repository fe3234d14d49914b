// game/match/playback.h: a log played again without devices: the ticks, and what they must come to.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "game/match/record.h"

namespace thaum::game {

/// A recorded hash and what the replay came to at the same tick.
struct Divergence {
    input::HashRecord recorded;
    std::uint64_t state{};
    std::uint64_t force{};
};

/// "tick 128: state differs: the log has ..., here it is ...".
std::string described(const Divergence&);

/// A log and the match that it makes.
class Playback {
public:
    /// The error is one line: no log, damaged header, other rules, changed data.
    static Expected<Playback> open(const std::filesystem::path& log, const std::filesystem::path& assets);

    const input::LogReader& log() const { return *log_; }
    const Simulation& match() const { return *match_; }
    Simulation& match() { return *match_; }

    /// Plays one tick and compares it with the log's hash, if there is one; false at the log's end.
    bool step();
    /// Plays up to that many ticks in all; false where the log is shorter.
    bool play_to(Tick tick);
    /// The frame that the last step played.
    const input::InputFrame& frame() const { return frame_; }
    /// The log's hash of this tick where it is not the state's; nothing where they agree or the log has none.
    std::optional<Divergence> mismatch() const;
    /// The first such difference since the log's beginning: what is played after it never happened.
    const std::optional<Divergence>& divergence() const { return divergence_; }

    /// Why agreeing hashes would not prove the whole replay, as a line: one of the states that must have a hash has
    /// none (every 128th, and the last one of a log that was closed), or there is nothing to compare. Empty: they would.
    std::string missing_hashes() const;
    /// A line where the log's result is not that of the match now, at the end of a log that was closed; else empty.
    std::string wrong_result() const;

private:
    Playback() = default;
    std::unique_ptr<input::LogReader> log_;
    std::unique_ptr<Simulation> match_;
    input::InputFrame frame_;
    std::optional<Divergence> divergence_;
};

}  // namespace thaum::game
