#include "core/jobs.h"

#include <atomic>

#include "core/threads.h"

namespace thaum {

struct Jobs::Ticket::Job {
    std::function<void()> body;
    std::atomic<bool> done{false};

    void execute() {
        body();
        body = nullptr;
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
    if (threads_.empty()) {
        job->execute();
        return Ticket(std::move(job));
    }
    {
        const std::lock_guard lock(mutex_);
        queue_.push_back(job);
    }
    wake_.notify_one();
    return Ticket(std::move(job));
}

void Jobs::work() {
    for (;;) {
        std::shared_ptr<Ticket::Job> job;
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [this] { return stopping_ || !queue_.empty(); });
            if (queue_.empty()) return;
            job = std::move(queue_.front());
            queue_.pop_front();
        }
        job->execute();
    }
}

}  // namespace thaum
