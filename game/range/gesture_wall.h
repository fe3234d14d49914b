// game/range/gesture_wall.h: the gesture wall, a display of all gestures on the practice range. It follows
// the strokes of the practising player, compares each with the gesture as which it was recognised, and
// collects three strokes when the player records a gesture.
#pragma once
#include <memory>
#include <optional>

#include "game/match/simulation.h"
#include "game/picture/gesture_wall_picture.h"

namespace thaum::game::inline range {

class GestureWall {
public:
    static constexpr std::size_t recorded_strokes = 3;

    /// Follows the strokes of the practising player. Call this after every tick.
    void follow(const Simulation& match);
    /// Starts to record: the player's next three strokes become the gesture of this name. An empty name stops
    /// recording.
    void record(const std::string& name);
    /// Whether strokes are being recorded, or a complete recording is being checked. `record({})` or
    /// `give_up` ends this.
    bool records() const { return !recording_.name.empty(); }
    /// Name of the gesture that is being recorded; empty: none.
    const std::string& recorded_name() const { return recording_.name; }
    /// To be called if the recorded gesture was refused: shows why, and records three strokes again.
    void draw_again(std::vector<std::string> why);
    /// Cancels the recording, as the player wants.
    void give_up(const Simulation& match);
    /// Returns a gesture whose strokes are complete, once. The wall stays in recording until it is told the
    /// result of the check.
    std::optional<gesture::Gesture> take_recorded() { return std::exchange(recorded_, std::nullopt); }
    /// Shows lines of text first on the wall for some seconds, such as that a gesture was saved.
    void say(const Simulation& match, std::vector<std::string> lines);
    /// Fills in the wall's picture. The wall is shown during a stroke, for some seconds after it, and during
    /// recording.
    void show(const Simulation& match, GestureWallPicture& picture) const;

private:
    void read(const Simulation& match);
    void refuse(const Simulation& match);
    std::uint32_t gesture_tried(std::uint32_t nearest, int score) const;
    void advise(const CastingRules& rules, const gesture::Gesture& gesture, double force, bool meant);
    std::string words_of_haste() const;
    std::string words_of_slip(const CastingRules& rules, double shortest) const;
    void keep(const Simulation& match);
    void list(const Simulation& match);
    void tell_recording();
    void begin_stroke();

    /// The set of gestures from which `gestures_` was made; null: none.
    std::shared_ptr<const GestureSet> listed_{};
    std::shared_ptr<const std::vector<WallGesture>> gestures_{};
    std::vector<int> scores_{};
    std::vector<gesture::StrokePoint> stroke_{};
    bool drawing_ = false;
    /// True: a key chord (a wand's key while Trace is held) has replaced the newest stroke.
    bool chord_ = false;
    int chosen_ = -1;
    Tick read_at_{};  ///< tick of play of the newest reading of a stroke that was shown (LastReading::at)
    Tick shown_until_{};
    std::vector<std::string> lines_{};
    gesture::Gesture recording_{};  ///< the gesture being recorded; without a name: none
    bool checked_ = false;  ///< true: the recording is complete, and is being compared with other gestures
    std::optional<gesture::Gesture> recorded_{};
};

}  // namespace thaum::game::inline range
