// game/app/shots.h: pictures of chosen moments of a replay, drawn without a window.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "game/hud/still.h"
#include "game/match/playback.h"

namespace thaum::game::inline app {

/// Chosen moments of a replay, and the folder for their pictures.
struct ShotPlan {
    std::filesystem::path folder{};
    Tick every = 0;          ///< ticks between two pictures; 0: no regular pictures
    std::vector<Tick> at{};  ///< single ticks with a picture, sorted
    /// For each EventKind, whether it gets a picture.
    std::vector<bool> on = std::vector<bool>(event_kinds().kinds.size());
    bool on_marks = false;
    render::Size size{1280, 720};

    bool any() const;
};

/// Follows a playback and saves its pictures as FOLDER/shot_TICK.png, or shot_TICK_WHAT.png for an event or
/// for a mark, which a user has set in the log.
class Shots {
public:
    /// Makes the folder. The error is one line: the folder cannot be made, or there is no OpenGL.
    static Expected<Shots> create(ShotPlan plan, const MatchData& data, const std::filesystem::path& assets);
    /// Saves the picture that is due in the playback's state now; at most one per tick. Call it after each
    /// tick, since the pictures also show sounds and body effects, which follow the match tick by tick.
    Expected<void> follow(const Playback& playback);
    /// Marks all pictures so far as true to the record; call this when a state hash has agreed.
    void confirm() { unconfirmed_.clear(); }
    /// Deletes the pictures taken since the last confirmation, which show moments that never happened in the
    /// recorded match.
    void remove_unconfirmed();
    std::size_t taken() const { return taken_; }

private:
    Shots(ShotPlan plan, Still still, std::unique_ptr<Senses> senses)
        : plan_(std::move(plan)), still_(std::move(still)), senses_(std::move(senses)) {}
    std::optional<std::string> due(const Playback& playback);

    ShotPlan plan_;
    Still still_;
    std::unique_ptr<Senses> senses_;  ///< what is heard and felt; null if a data file has a fault
    std::size_t next_at_ = 0, next_mark_ = 0, taken_ = 0;
    /// Value of EventJournal::count (number of events so far) when events were last read.
    std::uint64_t seen_ = 0;
    std::vector<std::filesystem::path> unconfirmed_{};
};

/// Makes the object that computes what is heard and felt, as the live view shows it. Null after an error,
/// which is printed in one line.
std::unique_ptr<Senses> senses_of(const MatchData& data, const std::filesystem::path& assets);
/// The HUD of a player who has changed no setting.
HudSettings hud_of(const Playback& playback);

}  // namespace thaum::game::inline app
