#include "core/jobs.h"

#include <atomic>
#include <utility>

#include "core/assert.h"
#include "core/threads.h"

namespace thaum {

struct Jobs::Ticket::Job {
    std::function<void()> body;
    bool repeats = false;  // true: made by prepare(), so the function stays after a run, for the next one
    std::atomic<bool> done{false};
    std::shared_ptr<Job> next{};  // the job that was submitted after this one, while both wait

    void execute() {
        body();
        if (!repeats) body = nullptr;
        done.store(true, std::memory_order_release);
        done.notify_all();
    }
};

void Jobs::Ticket::wait() const {
    if (job_) job_->done.wait(false, std::memory_order_acquire);
}

bool Jobs::Ticket::ended() const { return !job_ || job_->done.load(std::memory_order_acquire); }

Jobs::Jobs(unsigned threads) {
    threads_.reserve(threads);
    // If the system refuses some or all of the threads, the same work runs more slowly.
    for (unsigned i = 0; i < threads; ++i) {
        auto started = start_thread([this] { work(); });
        if (!started) break;
        threads_.push_back(std::move(*started));
    }
}

Jobs::~Jobs() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    wake_.notify_all();  // the threads then end, and the members' destructors wait for them
}

Jobs::Ticket Jobs::run(std::function<void()> body) {
    auto job = std::make_shared<Ticket::Job>();
    job->body = std::move(body);
    submit(job);
    return Ticket(std::move(job));
}

Jobs::Ticket Jobs::prepare(std::function<void()> body) {
    auto job = std::make_shared<Ticket::Job>();
    job->body = std::move(body);
    job->repeats = true;
    job->done.store(true, std::memory_order_relaxed);
    return Ticket(std::move(job));
}

void Jobs::run(const Ticket& prepared) {
    THAUM_ASSERT(prepared.job_ && prepared.job_->repeats && prepared.ended(),
                 "a job was submitted again that was not prepared or has not ended");
    prepared.job_->done.store(false, std::memory_order_relaxed);
    submit(prepared.job_);
}

void Jobs::submit(std::shared_ptr<Ticket::Job> job) {
    if (threads_.empty()) return job->execute();
    {
        const std::lock_guard lock(mutex_);
        auto& place = first_ ? last_->next : first_;
        last_ = job.get();
        place = std::move(job);
    }
    wake_.notify_one();
}

void Jobs::work() {
    for (;;) {
        std::shared_ptr<Ticket::Job> job;
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [this] { return stopping_ || first_; });
            if (!first_) return;
            job = std::move(first_);
            first_ = std::move(job->next);
        }
        job->execute();
    }
}

}  // namespace thaum
