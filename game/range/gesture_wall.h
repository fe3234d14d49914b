// game/range/gesture_wall.h: the gesture wall of the range. It follows the strokes of the practising player, compares each
// with the gesture that it was read as, and collects three strokes for a gesture of the player's own.
#pragma once
#include <memory>
#include <optional>

#include "game/match/simulation.h"
#include "game/picture/gesture_wall_picture.h"

namespace thaum::app {

class GestureWall {
public:
    static constexpr std::size_t recorded_strokes = 3;

    /// Looks at the match after a tick.
    void follow(const game::Simulation& match);
    /// Takes the next three strokes of the player for the gesture of this name. Empty: stops recording.
    void record(const std::string& name);
    /// Whether strokes are recorded, or complete ones are being checked. Ends by `record({})` or `give_up`.
    bool records() const { return !recording_.name.empty(); }
    /// Name of the gesture that is recorded; empty: none.
    const std::string& recorded_name() const { return recording_.name; }
    /// The recorded gesture was refused: says why, and takes the next three strokes for it.
    void draw_again(std::vector<std::string> why);
    /// The player gives up the gesture that is recorded.
    void give_up(const game::Simulation& match);
    /// The gesture whose strokes are complete, once. The wall goes on recording until it is told what became of it.
    std::optional<gesture::Gesture> take_recorded() { return std::exchange(recorded_, std::nullopt); }
    /// Words for the player in the wall's first line, such as that a gesture was saved, for some seconds.
    void say(const game::Simulation& match, std::vector<std::string> lines);
    /// Fills in what is shown. The wall is shown during a stroke, for some seconds after it, and while it records.
    void show(const game::Simulation& match, game::GestureWallPicture& picture) const;

private:
    void read(const game::Simulation& match);
    void refuse(const game::Simulation& match);
    std::uint32_t gesture_tried(std::uint32_t nearest, int score) const;
    void advise(const game::CastingRules& rules, const gesture::Gesture& gesture, double force, bool meant);
    std::string words_of_haste() const;
    std::string words_of_slip(const game::CastingRules& rules, double shortest) const;
    void keep(const game::Simulation& match);
    void list(const game::Simulation& match);
    void tell_recording();
    void begin_stroke();

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
    bool checked_ = false;  ///< the recorded strokes are complete, and somebody compares them with others
    std::optional<gesture::Gesture> recorded_{};
};

}  // namespace thaum::app
