// input/tactile_player.h: plays tactile frames on one output, in a thread of its own.
//
// The thread checks for frames every 4 ms while the output is open, and every 100 ms otherwise.
//
// An output may block its caller for ever, so the destructor waits for the thread for `max_wait_s` only
// (core/step_thread.h). A thread that is abandoned ends when the hanging call returns.
#pragma once
#include <memory>
#include <string>

#include "core/step_thread.h"
#include "input/tactile_playback.h"

namespace thaum::input {

/// Plays tactile frames on one output, in a thread of its own.
class TactilePlayer {
public:
    static constexpr double max_wait_s = 1.5;

    /// Starts the thread. The destructor silences and closes the output.
    explicit TactilePlayer(double wait_s = max_wait_s) : thread_(wait_s) {}

    /// Queues a frame; the simulation thread calls it every 8 ms. Never waits.
    bool feel(const tactile::TactileFrame& frame);
    /// Merges a frame of a second source, such as a menu, with the queued ones. Any thread may call it.
    void try_out(const tactile::TactileFrame& frame);
    /// Changes the output; null: none. Any thread may call it; it never waits for an output.
    void use(std::unique_ptr<TactileOutput> output);
    /// One line: which output plays, or why none does. Empty if there is no output. Any thread may ask.
    std::string status() const;
    /// Counts of frames played, merged and dropped since the start. Any thread may ask.
    TactileReport report() const;
    /// Whether an output is open, to which frames are passed. Any thread may ask.
    bool is_open() const;

private:
    StepThread<TactilePlayback> thread_;
};

}  // namespace thaum::input
