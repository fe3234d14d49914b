// game/live/gesture_wall.h: the gesture wall of the range. It follows the strokes of the practising player, compares each
// with the gesture that it was read as, and collects three strokes for a gesture of the player's own.
#pragma once
#include <memory>
#include <optional>

#include "game/hud/gesture_wall.h"
#include "game/match/simulation.h"

namespace thaum::app {

class GestureWall {
public:
    static constexpr std::size_t recorded_strokes = 3;

    /// Looks at the match after a tick.
    void follow(const game::Simulation& match);
    /// Takes the next three strokes of the player for the gesture of this name. Empty: stops recording.
    void record(const std::string& name);
    bool records() const { return !recording_.name.empty(); }
    /// The gesture whose strokes are complete, once.
    std::optional<gesture::Gesture> take_recorded() { return std::exchange(recorded_, std::nullopt); }
    /// Words for the player in the wall's first line, such as that a gesture was saved.
    void say(std::vector<std::string> lines);
    /// Fills in what is shown. The wall is shown during a stroke, for some seconds after it, and while it records.
    void show(const game::Simulation& match, game::GestureWallPicture& picture) const;

private:
    void read(const game::Simulation& match);
    void refuse(const game::Simulation& match);
    std::string words_of_haste() const;
    void keep(const game::Simulation& match);
    void list(const game::Simulation& match);
    void tell_recording();

    std::shared_ptr<const game::GestureSet> listed_{};  ///< set whose ghosts `gestures_` has; null: none
    std::shared_ptr<const std::vector<game::WallGesture>> gestures_{};
    std::vector<int> scores_{};
    std::vector<gesture::StrokePoint> stroke_{};
    bool drawing_ = false;
    bool chord_ = false;  ///< a key chord took the place of the newest stroke
    int chosen_ = -1;
    Tick read_at_{};  ///< LastReading::at of the newest reading that was shown
    Tick shown_until_{};
    std::vector<std::string> lines_{};
    gesture::Gesture recording_{};  ///< without a name: nothing is recorded
    std::optional<gesture::Gesture> recorded_{};
};

}  // namespace thaum::app
