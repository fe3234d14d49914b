// input/tactile_playback.h: passes tactile frames to an output, and silences it in time. It has no thread and
// no clock (input/tactile_player.h has both).
//
//     simulation thread --frames--> queue --> step(): merge, write or silence --> output
//
// Each frame has a time to live. If no newer frame comes in that time, the output is silenced: the match is
// paused, or the program hangs. Frames that wait together are merged: each actuator gets its largest
// amplitude, so that a short blow is felt, and the carrier frequency of the newest frame. The age of a
// waiting frame is unknown. It is assumed to be the time since the previous step, so frames that waited while
// an output hung are dropped.
//
// A second source, such as a menu in which an effect is tried, passes its frames by `try_out`. They are
// merged with the match's frames during their time to live.
#pragma once
#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "core/spsc_queue.h"
#include "input/tactile_output.h"

namespace thaum::input {

/// Counts of frames and outputs since the start.
struct TactileReport {
    std::uint64_t frames_sent{};     ///< frames that the output played, or for which it was rightly silent
    std::uint64_t frames_merged{};   ///< frames merged into a newer one
    std::uint64_t frames_late{};     ///< frames dropped because their time to live may have passed
    std::uint64_t frames_lost{};     ///< frames dropped because no output was open, or the queue was full
    std::uint64_t times_silenced{};  ///< number of times that a time to live ended without a newer frame
    std::uint64_t times_opened{};
    std::uint64_t times_lost{};
};

/// Plays frames on an output. The output's thread calls `step`.
class TactilePlayback {
public:
    static constexpr double retry_s = 2;           ///< time between two tries to open an output (s)
    static constexpr double longest_life_s = 0.5;  ///< longest time to live of a frame that is accepted (s)

    /// Queues a frame; called by the thread that makes frames. Returns false if the queue is full, which
    /// happens while the output's thread takes no frames.
    bool feel(const tactile::TactileFrame& frame);

    /// Merges a frame of a second source, such as a menu, with the queued ones. Only its newest frame is
    /// used. Any thread may call it.
    void try_out(const tactile::TactileFrame& frame);
    /// From the next step on, frames go to this output; null: to none. The former output is closed.
    void use(std::unique_ptr<TactileOutput> output);
    /// One line: which output plays, or why none does. Empty if there is no output.
    std::string status() const;
    /// Counts of frames played, merged and dropped since the start.
    TactileReport report() const;
    /// Whether an output is open, to which frames are passed.
    bool is_open() const { return open_; }
    /// Lets `step` return as soon as a blocking call of the output returns, without calling the output again.
    void abandon() { abandoned_ = true; }

    /// Does what is due at the time `now_s` and returns the time until the next step (s). Called by the
    /// output's thread.
    double step(double now_s);
    /// Silences and closes the output.
    void close();

private:
    void take_output(double now_s);
    void try_open(double now_s);
    void lose(double now_s);
    void drop_waiting();
    bool take_trial(double now_s);
    std::size_t take_frames();
    void pass_all(double now_s);
    void play(double now_s, double age_s);
    void send(double now_s, double life_s);
    void say(std::string status);
    void publish_report();

    SpscQueue<tactile::TactileFrame, 32> frames_;
    std::atomic<std::uint64_t> refused_{};  ///< frames that found the queue full

    mutable std::mutex told_;  ///< guards the five members below
    std::string status_;
    TactileReport published_;
    std::unique_ptr<TactileOutput> next_output_;
    bool changes_output_{};
    std::optional<tactile::TactileFrame> next_trial_;

    std::atomic<bool> abandoned_{};
    std::unique_ptr<TactileOutput> output_;
    TactileReport report_;
    tactile::TactileFrame frame_{};  ///< the newest frame, with older ones merged into it
    tactile::TactileFrame trial_{};  ///< the newest frame that a second source has passed by `try_out`
    double trial_until_s_{};
    std::atomic<bool> open_{};  ///< true: an output is open; changed only by the output's thread
    bool sounding_{};           ///< true: the output plays a frame that is not silent
    double silent_at_s_{};
    double next_try_s_{};
    double opened_at_s_{};
    double last_step_s_{};
};

}  // namespace thaum::input
