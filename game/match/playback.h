// game/match/playback.h: a log played again without devices: the ticks, and what they must come to.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>

#include "game/match/record.h"

namespace thaum::game {

/// A log and the match that it makes.
class Playback {
public:
    /// The error is one line: no log, damaged header, other rules, changed data.
    static Expected<Playback> open(const std::filesystem::path& log, const std::filesystem::path& assets);

    const input::LogReader& log() const { return *log_; }
    const Simulation& match() const { return *match_; }
    Simulation& match() { return *match_; }

    /// Plays one tick; false at the log's end.
    bool step();
    /// Plays up to that many ticks in all; false where the log is shorter.
    bool play_to(Tick tick);
    /// The frame that the last step played.
    const input::InputFrame& frame() const { return frame_; }
    /// The hash that the log has for the state now and that is not the state's; nothing where they agree or there is none.
    std::optional<input::HashRecord> mismatch() const;

private:
    Playback() = default;
    std::unique_ptr<input::LogReader> log_;
    std::unique_ptr<Simulation> match_;
    input::InputFrame frame_;
};

}  // namespace thaum::game
