#include "input/detail/watchdog.h"

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>

#include "core/clock.h"
#include "core/text.h"
#include "core/threads.h"

namespace thaum::input {
namespace {

thread_local CallNote* note_of_thread = nullptr;

/// Work, shared by the thread that does it and the thread that waits for its end.
struct Job {
    std::function<void()> work, if_late;
    CallNote in_call{nullptr};
    std::mutex mutex{};  // protects the members below
    std::condition_variable changed{};
    bool ended = false, given_up = false;
};

void do_job(Job& job) {
    note_of_thread = &job.in_call;
    job.work();
    bool late = false;
    {
        const std::lock_guard lock(job.mutex);
        job.ended = true;
        late = job.given_up;
    }
    job.changed.notify_one();
    if (late) job.if_late();
    note_of_thread = nullptr;
}

}  // namespace

NotedCall::NotedCall(const char* name) {
    if (note_of_thread != nullptr) note_of_thread->store(name, std::memory_order_relaxed);
}

NotedCall::~NotedCall() {
    if (note_of_thread != nullptr) note_of_thread->store(nullptr, std::memory_order_relaxed);
}

Watched run_watched(std::int64_t limit_ns, const std::atomic<bool>* enough, std::function<void()> work,
                    std::function<void()> if_late) {
    using std::chrono::nanoseconds;
    constexpr std::chrono::milliseconds look(20);
    const auto job = std::make_shared<Job>();
    job->work = std::move(work);
    job->if_late = std::move(if_late);
    auto thread = start_thread([job] { do_job(*job); });
    if (!thread) return {Watched::End::no_thread, thread.error().message};
    thread->detach();
    const auto begun = monotonic_ns();
    std::unique_lock lock(job->mutex);
    // Checks are counted instead of reading a clock: while other programs take every core, this thread is
    // delayed like the one that works. So a call that only waits for the processor is not taken for one that
    // hangs.
    for (auto looks = limit_ns / nanoseconds(look).count(); looks > 0; --looks) {
        if (job->ended || (enough != nullptr && *enough)) break;
        job->changed.wait_for(lock, look, [&] { return job->ended; });
    }
    if (job->ended) return {};
    job->given_up = true;
    const char* call = job->in_call.load(std::memory_order_relaxed);
    return {Watched::End::hangs,
            text("the arm's library hangs: ", call != nullptr ? call : "it", " has not returned for ",
                 fixed(static_cast<double>(monotonic_ns() - begun) * 1e-9, 1),
                 " s; end this program, switch the arm off and on, and start again")};
}

}  // namespace thaum::input
