#include "audio/speakers.h"

#include <chrono>
#include <condition_variable>
#include <csignal>
#include <mutex>
#include <utility>
#include <vector>

#include "core/text.h"
#include "core/threads.h"

namespace thaum::audio {

using SpeakerClock = std::chrono::steady_clock;

/// Everything that the thread uses. It lives as long as the thread or the owner needs it.
struct Speakers::State {
    State(Mixer mixer, std::unique_ptr<SoundDevice> device) : playback(std::move(mixer), std::move(device)) {}

    Playback playback;
    std::string no_thread;  ///< why there is no thread; empty: there is one
    std::mutex mutex;       ///< guards the three below
    bool stop = false;
    bool left_behind =
        false;  ///< set with `stop`: the program may be ending, so OpenAL is not called any more
    bool ended = false;
    std::condition_variable changed;

    void run() {
        const auto start = SpeakerClock::now();
        std::unique_lock lock(mutex);
        while (!stop) {
            lock.unlock();
            const std::chrono::duration<double> now = SpeakerClock::now() - start;
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

Speakers::Speakers(Mixer mixer, std::unique_ptr<SoundDevice> device, double wait_s)
    : state_(std::make_shared<State>(std::move(mixer), std::move(device))), wait_s_(wait_s) {
    auto started = start_thread([state = state_] { state->run(); });
    if (started)
        thread_ = std::move(*started);
    else
        state_->no_thread = text("no sound: ", started.error().message);
}

Speakers::~Speakers() {
    if (!thread_.joinable()) return;
    std::unique_lock lock(state_->mutex);
    state_->stop = true;
    state_->changed.notify_all();
    const bool ended = state_->changed.wait_for(lock, std::chrono::duration<double>(wait_s_),
                                                [this] { return state_->ended; });
    if (ended) return;
    state_->left_behind = true;
    state_->playback.abandon();
    // Never destroyed: a late return of the device must not find OpenAL half unloaded.
    static auto* const kept = std::make_unique<std::vector<std::shared_ptr<State>>>().release();
    kept->push_back(state_);
    thread_.detach();
}

bool Speakers::hear(const AudioFrame& frame) { return state_->playback.hear(frame); }
bool Speakers::hear(const Voice& voice) { return state_->playback.hear(voice); }
void Speakers::set(const MixSettings& settings) { state_->playback.set(settings); }
std::string Speakers::status() const {
    return state_->no_thread.empty() ? state_->playback.status() : state_->no_thread;
}
bool Speakers::plays() const { return state_->playback.plays(); }
PlaybackReport Speakers::report() const { return state_->playback.report(); }

}  // namespace thaum::audio
