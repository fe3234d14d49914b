// game/app/shots.h: pictures of chosen moments of a replay, drawn in memory.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "game/app/still.h"
#include "game/match/playback.h"

namespace thaum::app {

/// Which moments, and where the pictures go.
struct ShotPlan {
    std::filesystem::path folder{};
    Tick every = 0;                                   ///< 0: not by time
    std::vector<Tick> at{};                           ///< sorted
    std::array<bool, game::event_names.size()> on{};  ///< by game::EventKind
    bool on_marks = false;
    render::Size size{1280, 720};

    bool any() const;
};

/// Follows a playback and leaves FOLDER/shot_TICK.png, or shot_TICK_WHAT.png for an event or a mark.
class Shots {
public:
    /// Makes the folder. The error is one line: it cannot be made, or there is no OpenGL.
    static Expected<Shots> create(ShotPlan plan, const game::MatchData& data,
                                  const std::filesystem::path& assets);
    /// Takes the pictures that are due in the playback's state now; at most one a tick.
    Expected<void> follow(const game::Playback& playback);
    std::size_t taken() const { return taken_; }

private:
    Shots(ShotPlan plan, Still still) : plan_(std::move(plan)), still_(std::move(still)) {}
    std::optional<std::string> due(const game::Playback& playback);

    ShotPlan plan_;
    Still still_;
    std::size_t next_at_ = 0, next_mark_ = 0, taken_ = 0;
    std::uint64_t seen_ = 0;  ///< of Chronicle::count
};

}  // namespace thaum::app
