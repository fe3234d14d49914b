// core/jobs.h: a few threads for large work beside the simulation (log blocks, pictures, later the fluid).
//
// A job's result is taken where the code says so (Ticket::wait), never when it happens to be ready; so what is computed
// does not depend on the number of threads. Jobs start in the order in which they were given.
#pragma once
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace thaum {

class Jobs {
public:
    class Ticket {
    public:
        Ticket() = default;
        /// Returns when the job has ended; at once where there is none.
        void wait() const;
        /// True when the job has ended or there is none.
        bool ended() const;

    private:
        friend class Jobs;
        struct Job;
        explicit Ticket(std::shared_ptr<Job> job) : job_(std::move(job)) {}
        std::shared_ptr<Job> job_;
    };

    /// threads = 0: a job runs inside `run`, on the caller's thread.
    explicit Jobs(unsigned threads);
    /// Ends every job that was given.
    ~Jobs();
    Jobs(const Jobs&) = delete;
    Jobs& operator=(const Jobs&) = delete;

    /// The job must not throw. It may wait for jobs given before it.
    Ticket run(std::function<void()> job);

private:
    void work();

    std::mutex mutex_;
    std::condition_variable wake_;
    std::deque<std::shared_ptr<Ticket::Job>> queue_;
    bool stopping_ = false;
    std::vector<std::thread> threads_;
};

}  // namespace thaum
