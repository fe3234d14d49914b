// game/range/practice.h: the practice range in a live session: its match and dummy, the scores, and data
// files, which are read again when they change.
#pragma once
#include <condition_variable>
#include <mutex>
#include <thread>

#include "core/triple_buffer.h"
#include "game/picture/picture.h"
#include "game/range/apprentice.h"
#include "game/range/force_sample.h"
#include "game/range/force_trial.h"
#include "game/range/gesture_wall.h"
#include "game/range/match_request.h"
#include "game/range/range_files.h"
#include "game/settings/own_gestures.h"

namespace thaum::game::inline range {

/// Watches the data files in a thread of its own, so that neither match nor window waits for the disk.
class DataWatcher {
public:
    explicit DataWatcher(RangeFiles files);
    ~DataWatcher();
    DataWatcher(const DataWatcher&) = delete;
    DataWatcher& operator=(const DataWatcher&) = delete;

    /// Newest data read since the last call, or null. The data is valid until the next call. Never blocks.
    const Reload* take();

private:
    void watch();

    RangeFiles files_;
    TripleBuffer<Reload> reloads_{Reload{}};
    std::mutex mutex_;
    std::condition_variable stopped_;
    bool stop_ = false;
    std::jthread thread_;  ///< declared last, so that the thread ends before the other members are destroyed
};

/// The match of a practice range with its dummy and scores. The caller passes the data of changed files.
class Practice {
public:
    /// `devices` are those of the practising player: the simulated hands first, then the real arm if the
    /// player holds one. With `lessons`, the series of lessons (Apprentice) runs instead of free practice.
    Practice(const RangeData& data, const std::vector<input::DeviceSpec>& devices, DummyKind kind,
             std::uint64_t seed, std::optional<Lessons> lessons = {},
             std::vector<input::ProfileData> profile = {});

    Simulation& match() { return *range_.match; }
    /// Removes fire from the practising player's samples until it is released, if the press began before a
    /// step of the lessons or chose a force. So that press fires no shot.
    void hold_fire_back(input::InputFrame& frame);
    /// Starts the search for the largest force that the player likes.
    void find_force() { force_trial_.begin(); }
    /// Runs the search for the largest force for a tick, acting on its input. Returns the chosen force (% of
    /// the device's peak), once.
    std::optional<std::uint32_t> try_force(input::InputFrame& frame) {
        force_sample_.step(match(), practising);
        const auto found = force_trial_.step(match(), practising, frame);
        if (found) tell_found(*found);
        return found;
    }
    /// Lets the player feel the forces whose strength one setting (fader) sets.
    void play_force(input::HandFader fader) { force_sample_.begin(fader); }
    /// Whether the search for the largest force is running. Meanwhile the player's own force limit does not
    /// apply.
    bool finds_force() const { return force_trial_.runs(); }
    input::DeviceSample dummy_sample() { return range_.dummy.sample(*range_.match); }
    void set_dummy(DummyKind kind);
    /// Continues with changed rules; match() may then return another object. Returns whether anything
    /// changed.
    bool set_changes(const RangeChanges& changes);
    /// Continues with the data of changed files; match() may then return another object. If a file has a
    /// fault, the old data is kept, and a caption shows the fault until the next reload.
    void adopt(const Reload& reload);
    /// Updates the lessons (the Apprentice) after a tick: measures the present step, and puts wizards and
    /// dummy in place if a step begins.
    void follow_lessons();
    /// The lessons; null in free practice.
    Apprentice* apprentice() { return apprentice_ ? &*apprentice_ : nullptr; }
    /// Takes the player's next strokes for a gesture, by its number in the match's
    /// set. Unknown numbers do nothing.
    void draw_gesture(std::uint32_t number);
    /// Passes the strokes that the practising player draws to the gesture wall. Call this after every tick.
    void follow_gestures();
    /// The gesture wall, a display of all gestures. The lessons do not show it.
    GestureWall& wall() { return wall_; }
    /// Continues with other recorded gestures of the player; match() then returns another object. If they are
    /// refused, the old ones are kept, and the gesture wall (the practice range's display of gestures) keeps
    /// recording.
    void use_gestures(OwnGestures own);
    void show(Picture& picture);
    std::string score() { return words_of(scorer_.score(*range_.match)); }
    /// Number and name of the present step of the lessons: "2 of 8: Bolt".
    std::string step_words() const;
    /// Text about the practice that is ending: the score of the range, or the player's progress in the
    /// lessons.
    std::string last_words();

private:
    void say(std::string words, Tick how_long);
    void tell_found(std::uint32_t percent);
    void place(std::uint32_t player);
    void heal();
    void show_lesson(PracticePicture& picture);

    RangeData data_;  ///< data as in the files, without the changes of rules that the player has chosen
    RangeChanges changes_{};
    RangeMatch range_;
    RangeScorer scorer_{};
    std::optional<Apprentice> apprentice_;
    GestureWall wall_{};
    ForceTrial force_trial_{};
    ForceSample force_sample_{};
    bool fire_anew_ = false;  ///< true: fire does nothing until it has been released, because an earlier
                              ///< press holds it down
    Caption caption_{};
    Tick caption_until_{};  ///< end of the caption (ticks of play, so that a pause does not use up its time)
};

// Requests to the practice (match_request.h). The menu's rows send them.

/// Request to go on to the next step of the lessons.
struct SkipStep {
    void carry_out(Practice& practice) const {
        if (auto* course = practice.apprentice()) course->skip();
    }
};

/// Request to begin the present step of the lessons again.
struct RepeatStep {
    void carry_out(Practice& practice) const {
        if (auto* course = practice.apprentice()) course->repeat();
    }
};

struct FindForce {
    void carry_out(Practice& practice) const { practice.find_force(); }
};

struct FeelForce {
    input::HandFader fader{};
    void carry_out(Practice& practice) const { practice.play_force(fader); }
};

struct DrawGesture {
    std::uint32_t number{};  ///< number of the gesture in the match's set
    void carry_out(Practice& practice) const { practice.draw_gesture(number); }
};

/// Request to cancel the recording of new strokes for a gesture (DrawGesture).
struct StopDrawing {
    void carry_out(Practice& practice) const { practice.wall().give_up(practice.match()); }
};

}  // namespace thaum::game::inline range
