// core/step_thread.h: a thread that runs a Work object step by step, and that its owner may abandon.
//
// The work may block its caller for ever, as a device can, so only this thread calls it. The destructor of
// StepThread waits for the thread for a limited time. A thread that has not ended by then is abandoned with
// all that it uses: its memory is kept until the program ends.
#pragma once
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "core/threads.h"

namespace thaum {

/// A thread that runs a Work. `Work` has three functions: `double step(double now_s)` does what is due and
/// returns the time until the next step (s); `void close()` is the last call if the thread ends in time;
/// `void abandon()` is called by the owner if it does not.
template <class Work>
class StepThread {
public:
    /// Starts the thread. `wait_s` is the longest time for which the destructor waits until the thread ends
    /// (s).
    template <class... Arguments>
    explicit StepThread(double wait_s, Arguments&&... arguments)
        : state_(std::make_shared<State>(std::forward<Arguments>(arguments)...)), wait_s_(wait_s) {
        auto started = start_thread([state = state_] { state->run(); });
        if (started)
            thread_ = std::move(*started);
        else
            refused_ = started.error().message;
    }
    ~StepThread();
    StepThread(const StepThread&) = delete;
    StepThread& operator=(const StepThread&) = delete;

    /// The work. Its thread uses it at the same time, so call only functions that are safe for that.
    Work& work() { return state_->work; }
    const Work& work() const { return state_->work; }
    /// Why the system refused to start the thread; empty: it was started.
    const std::string& refused() const { return refused_; }

private:
    using Clock = std::chrono::steady_clock;

    /// Everything that the thread uses, the Work included. It lives as long as the thread or the owner needs
    /// it.
    struct State {
        template <class... Arguments>
        explicit State(Arguments&&... arguments) : work(std::forward<Arguments>(arguments)...) {}

        void run();

        Work work;
        std::mutex mutex;  ///< guards the three members below
        bool stop = false;
        /// True: the owner no longer waits for the end of the thread, which it had asked to stop.
        bool left_behind = false;
        bool ended = false;
        std::condition_variable changed;
    };

    std::shared_ptr<State> state_;
    double wait_s_;
    std::string refused_{};
    std::jthread thread_;
};

template <class Work>
void StepThread<Work>::State::run() {
    const auto start = Clock::now();
    std::unique_lock lock(mutex);
    while (!stop) {
        lock.unlock();
        const std::chrono::duration<double> now = Clock::now() - start;
        const std::chrono::duration<double> wait(work.step(now.count()));
        lock.lock();
        changed.wait_for(lock, wait, [this] { return stop; });
    }
    if (left_behind) return;
    lock.unlock();
    work.close();
    lock.lock();
    ended = true;
    changed.notify_all();
}

template <class Work>
StepThread<Work>::~StepThread() {
    if (!thread_.joinable()) return;
    std::unique_lock lock(state_->mutex);
    state_->stop = true;
    state_->changed.notify_all();
    const bool ended = state_->changed.wait_for(lock, std::chrono::duration<double>(wait_s_),
                                                [this] { return state_->ended; });
    if (ended) return;
    state_->left_behind = true;
    state_->work.abandon();
    // Never destroyed, because a device call that returns late must still find its memory and its library.
    static auto* const kept = std::make_unique<std::vector<std::shared_ptr<State>>>().release();
    kept->push_back(state_);
    thread_.detach();
}

}  // namespace thaum
