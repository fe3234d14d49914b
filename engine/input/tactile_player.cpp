#include "input/tactile_player.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>
#include <vector>

#include "core/text.h"
#include "core/threads.h"

namespace thaum::input {

using PlayerClock = std::chrono::steady_clock;

/// Everything that the thread uses. It lives as long as the thread or the owner needs it.
struct TactilePlayer::State {
    TactilePlayback playback;
    std::string no_thread;  ///< why there is no thread; empty: there is one
    std::mutex mutex;       ///< guards the three below
    bool stop = false;
    bool left_behind = false;  ///< set with `stop`: the owner waits no more
    bool ended = false;
    std::condition_variable changed;

    void run() {
        const auto start = PlayerClock::now();
        std::unique_lock lock(mutex);
        while (!stop) {
            lock.unlock();
            const std::chrono::duration<double> now = PlayerClock::now() - start;
            const std::chrono::duration<double> rest(playback.step(now.count()));
            lock.lock();
            changed.wait_for(lock, rest, [this] { return stop; });
        }
        if (left_behind) return;
        lock.unlock();
        playback.close();
        lock.lock();
        ended = true;
        changed.notify_all();
    }
};

TactilePlayer::TactilePlayer(double wait_s) : state_(std::make_shared<State>()), wait_s_(wait_s) {
    auto started = start_thread([state = state_] { state->run(); });
    if (started)
        thread_ = std::move(*started);
    else
        state_->no_thread = started.error().message;
}

TactilePlayer::~TactilePlayer() {
    if (!thread_.joinable()) return;
    std::unique_lock lock(state_->mutex);
    state_->stop = true;
    state_->changed.notify_all();
    const bool ended = state_->changed.wait_for(lock, std::chrono::duration<double>(wait_s_),
                                                [this] { return state_->ended; });
    if (ended) return;
    state_->left_behind = true;
    state_->playback.abandon();
    // Never destroyed: a late return of the output must find its own memory.
    static auto* const kept = std::make_unique<std::vector<std::shared_ptr<State>>>().release();
    kept->push_back(state_);
    thread_.detach();
}

bool TactilePlayer::feel(const tactile::TactileFrame& frame) { return state_->playback.feel(frame); }
void TactilePlayer::use(std::unique_ptr<TactileOutput> output) { state_->playback.use(std::move(output)); }
std::string TactilePlayer::status() const {
    return state_->no_thread.empty() ? state_->playback.status() : state_->no_thread;
}
TactileReport TactilePlayer::report() const { return state_->playback.report(); }
bool TactilePlayer::is_open() const { return state_->playback.is_open(); }

}  // namespace thaum::input
