// input/tactile_player.h: plays tactile frames on one output, in a thread of its own.
//
// While the output is open, the thread looks for frames every 4 ms, else every 100 ms.
//
// An output may block its caller for ever, so the destructor waits for the thread for `most_wait_s` only
// (core/step_thread.h). A thread that is left behind ends with the call that hangs.
#pragma once
#include <memory>
#include <string>

#include "core/step_thread.h"
#include "input/tactile_playback.h"

namespace thaum::input {

class TactilePlayer {
public:
    static constexpr double most_wait_s = 1.5;

    /// Starts the thread. The destructor silences and closes the output.
    explicit TactilePlayer(double wait_s = most_wait_s) : thread_(wait_s) {}

    /// Queues a frame; the simulation thread calls it every 8 ms. Never waits.
    bool feel(const tactile::TactileFrame& frame);
    /// Lays a frame over those that are queued (TactilePlayback::try_out). Any thread.
    void try_out(const tactile::TactileFrame& frame);
    /// Changes the output; null: none. Any thread; never waits for an output.
    void use(std::unique_ptr<TactileOutput> output);
    /// One line: which output plays, or why none does. Empty if there is none. Any thread may ask.
    std::string status() const;
    TactileReport report() const;
    /// Whether frames reach an output. Any thread.
    bool is_open() const;

private:
    StepThread<TactilePlayback> thread_;
};

}  // namespace thaum::input
