// core/jobs.h: a few threads for large work beside the simulation, such as the fluid step.
//
// The caller collects a job's result at a fixed place (Ticket::wait), not when the job happens to end.
// Results therefore do not depend on the number of threads. Jobs start in the order in which they were
// submitted.
#pragma once
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace thaum {

/// Threads that execute submitted jobs while their caller continues.
class Jobs {
public:
    /// Handle of one submitted job, to wait for its end.
    class Ticket {
    public:
        Ticket() = default;
        /// Returns when the job has ended, or at once if the ticket has no job.
        void wait() const;
        /// Returns true if the job has ended or the ticket has no job.
        bool ended() const;

    private:
        friend class Jobs;
        struct Job;
        explicit Ticket(std::shared_ptr<Job> job) : job_(std::move(job)) {}
        std::shared_ptr<Job> job_;
    };

    /// Starts `threads` threads. With 0, `run` executes each job at once on the caller's thread.
    explicit Jobs(unsigned threads);
    /// Waits until every submitted job has ended.
    ~Jobs();
    Jobs(const Jobs&) = delete;
    Jobs& operator=(const Jobs&) = delete;

    /// Submits a job. The job must not throw. It may wait for jobs submitted before it.
    Ticket run(std::function<void()> job);
    /// Makes a job that can be submitted many times, and does not submit it yet. Until it is submitted, its
    /// ticket says that it has ended.
    static Ticket prepare(std::function<void()> job);
    /// Submits a job made by prepare(), which must have ended. Unlike the other `run`, it allocates nothing.
    void run(const Ticket& prepared);
    /// Number of threads that execute jobs.
    std::size_t threads() const { return threads_.size(); }

private:
    void submit(std::shared_ptr<Ticket::Job> job);
    void work();

    std::mutex mutex_;
    std::condition_variable wake_;
    // The jobs that no thread has begun. Each refers to the next one, so that waiting needs no memory.
    std::shared_ptr<Ticket::Job> first_;
    Ticket::Job* last_ = nullptr;
    bool stopping_ = false;
    /// Last member, so that the threads end while the other members still exist.
    std::vector<std::jthread> threads_;
};

}  // namespace thaum
