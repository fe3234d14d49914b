// input/tactile_playback.h: passes tactile frames to an output, and silences it in time. It has no thread and no clock
// (input/tactile_player.h has).
//
//     simulation thread --frames--> queue --> step(): merge, write or silence --> output
//
// Each frame has a time to live. If no newer frame comes in that time, the output is silenced: the match is paused, or
// the program hangs. Several frames that wait become one: each actuator gets its largest amplitude, so that a short
// blow is felt, and the newest frame's carriers. The age of a waiting frame is unknown. It counts as old as the step
// before, so frames that waited while an output hung are dropped.
//
// A second source, such as a menu in which an effect is tried, passes its frames by `try_out`. They are laid over the
// match's frames. Each counts for its time to live.
#pragma once
#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "core/spsc_queue.h"
#include "input/tactile_output.h"

namespace thaum::input {

/// Counts since the start.
struct TactileReport {
    std::uint64_t frames_sent{};     ///< frames that the output played or was silent for
    std::uint64_t frames_merged{};   ///< frames merged into a newer one
    std::uint64_t frames_late{};     ///< frames dropped because their time to live may have passed
    std::uint64_t frames_lost{};     ///< frames dropped because no output was open, or the queue was full
    std::uint64_t times_silenced{};  ///< times to live that ended without a newer frame
    std::uint64_t times_opened{};
    std::uint64_t times_lost{};
};

class TactilePlayback {
public:
    static constexpr double retry_s = 2;           ///< time between two tries to open an output
    static constexpr double longest_life_s = 0.5;  ///< a longer time to live counts as this

    // The thread that makes frames.
    /// Queues a frame. Returns false if the queue is full: the output is not fed at the moment.
    bool feel(const tactile::TactileFrame& frame);

    // Any thread.
    /// Lays a frame over those that are queued. The newest one counts.
    void try_out(const tactile::TactileFrame& frame);
    /// Takes another output at the next step; null: none. The former one is closed.
    void use(std::unique_ptr<TactileOutput> output);
    /// One line: which output plays, or why none does. Empty if there is none.
    std::string status() const;
    TactileReport report() const;
    /// Whether frames reach an output.
    bool is_open() const { return open_; }
    /// Lets `step` return as soon as a blocking call of the output does, without a further one.
    void abandon() { abandoned_ = true; }

    // The thread of the output.
    /// Does what is due at the time `now_s` and returns the time until the next step (s).
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

    mutable std::mutex told_;  ///< guards the five below
    std::string status_;
    TactileReport published_;
    std::unique_ptr<TactileOutput> next_output_;
    bool changes_output_{};
    std::optional<tactile::TactileFrame> next_trial_;

    std::atomic<bool> abandoned_{};
    std::unique_ptr<TactileOutput> output_;
    TactileReport report_;
    tactile::TactileFrame frame_{};  ///< the newest frame, with those merged into it
    tactile::TactileFrame trial_{};  ///< the newest frame of `try_out`
    double trial_until_s_{};
    std::atomic<bool> open_{};  ///< changed by the output's thread only
    bool sounding_{};           ///< the output plays a frame that is not silent
    double silent_at_s_{};
    double next_try_s_{};
    double opened_at_s_{};
    double last_step_s_{};
};

}  // namespace thaum::input
