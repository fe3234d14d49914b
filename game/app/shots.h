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
    /// For each game::EventKind, true if a picture is made of each such event.
    std::vector<bool> on = std::vector<bool>(game::event_kinds().kinds.size());
    bool on_marks = false;
    render::Size size{1280, 720};

    bool any() const;
};

/// Follows a playback and saves its pictures as FOLDER/shot_TICK.png, or shot_TICK_WHAT.png for an event or a
/// mark.
class Shots {
public:
    /// Makes the folder. The error is one line: the folder cannot be made, or there is no OpenGL.
    static Expected<Shots> create(ShotPlan plan, const game::MatchData& data,
                                  const std::filesystem::path& assets);
    /// Saves the picture that is due in the playback's present state; at most one per tick. Must be called
    /// after each tick, so that pictures show what was heard and felt before.
    Expected<void> follow(const game::Playback& playback);
    /// Marks all pictures so far as true to the recorded match. Must be called when a state hash has agreed.
    void confirm() { unconfirmed_.clear(); }
    /// Deletes the pictures taken since the last confirmation, which show moments that never happened in the
    /// recorded match.
    void remove_unconfirmed();
    std::size_t taken() const { return taken_; }

private:
    Shots(ShotPlan plan, Still still, std::unique_ptr<game::Senses> senses)
        : plan_(std::move(plan)), still_(std::move(still)), senses_(std::move(senses)) {}
    std::optional<std::string> due(const game::Playback& playback);

    ShotPlan plan_;
    Still still_;
    /// What players hear and feel, for the pictures; null if a data file has a fault.
    std::unique_ptr<game::Senses> senses_;
    std::size_t next_at_ = 0, next_mark_ = 0, taken_ = 0;
    /// Value of EventJournal::count (number of events so far) when events were last read.
    std::uint64_t seen_ = 0;
    std::vector<std::filesystem::path> unconfirmed_{};
};

/// What players hear and feel, for pictures that show it as the live view does. Null after an error, which is
/// printed in one line.
std::unique_ptr<game::Senses> senses_of(const game::MatchData& data, const std::filesystem::path& assets);
/// The settings of the HUD for a player who has changed none of them.
game::HudSettings hud_of(const game::Playback& playback);

}  // namespace thaum::game::inline app
