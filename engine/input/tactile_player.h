// input/tactile_player.h: plays tactile frames on one output, in a thread of its own.
//
// While the output is open, the thread looks for frames every 4 ms, else every 100 ms.
//
// An output may block its caller for ever. Only this thread calls it, and the destructor waits for the thread for
// `most_wait_s` only. A thread that has not ended by then is left behind with all that it uses: it ends with the call
// that hangs, and its memory stays until the program ends.
#pragma once
#include <memory>
#include <string>
#include <thread>

#include "input/tactile_playback.h"

namespace thaum::input {

class TactilePlayer {
public:
    static constexpr double most_wait_s = 1.5;

    explicit TactilePlayer(double wait_s = most_wait_s);
    /// Silences and closes the output.
    ~TactilePlayer();
    TactilePlayer(const TactilePlayer&) = delete;
    TactilePlayer& operator=(const TactilePlayer&) = delete;

    /// Queues a frame; the simulation thread calls it every 8 ms. Never waits.
    bool feel(const tactile::TactileFrame& frame);
    /// Changes the output; null: none. Any thread; never waits for an output.
    void use(std::unique_ptr<TactileOutput> output);
    /// One line: which output plays, or why none does. Empty if there is none. Any thread may ask.
    std::string status() const;
    TactileReport report() const;
    /// Whether frames reach an output. Any thread.
    bool is_open() const;

private:
    struct State;
    std::shared_ptr<State> state_;
    double wait_s_;
    std::jthread thread_;
};

}  // namespace thaum::input
