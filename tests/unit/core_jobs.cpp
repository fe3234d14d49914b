#include "core/jobs.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <atomic>
#include <latch>
#include <numeric>

#include "core/hash.h"
#include "core/threads.h"

namespace thaum {
namespace {

using namespace std::chrono_literals;

/// When a thread's stack is full, the signal handler needs another stack to run on.
TEST(Threads, HaveAStackOnWhichAFullOneIsHandled) {
    stack_t stack{};
    auto thread = start_thread([&] { ::sigaltstack(nullptr, &stack); });
    ASSERT_TRUE(thread) << thread.error().message;
    thread->join();
    EXPECT_EQ(stack.ss_flags & SS_DISABLE, 0);
    EXPECT_GE(stack.ss_size, static_cast<std::size_t>(MINSIGSTKSZ));
}

class JobsByThreads : public ::testing::TestWithParam<unsigned> {};

TEST_P(JobsByThreads, SameResultsWithAnyNumberOfThreads) {
    constexpr std::size_t n = 500;
    std::vector<std::uint64_t> results(n);
    {
        Jobs jobs(GetParam());
        std::vector<Jobs::Ticket> tickets;
        for (std::size_t i = 0; i < n; ++i) {
            tickets.push_back(jobs.run([&results, i] { results[i] = hash_value(i); }));
        }
        for (const auto& ticket : tickets) {
            ticket.wait();
            EXPECT_TRUE(ticket.ended());
        }
    }
    for (std::size_t i = 0; i < n; ++i) EXPECT_EQ(results[i], hash_value(i));
}

TEST_P(JobsByThreads, AJobMayWaitForEarlierOnes) {
    Jobs jobs(GetParam());
    std::vector<int> sums(200);
    Jobs::Ticket last;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        last = jobs.run([&sums, i, before = last] {
            before.wait();
            sums[i] = (i == 0 ? 0 : sums[i - 1]) + 1;
        });
    }
    last.wait();
    EXPECT_EQ(sums.back(), 200);
}

TEST_P(JobsByThreads, TheDestructorFinishesAllJobs) {
    std::atomic<int> ran = 0;
    Jobs::Ticket last;
    {
        Jobs jobs(GetParam());
        for (int i = 0; i < 100; ++i) last = jobs.run([&ran] { ++ran; });
    }
    EXPECT_EQ(ran, 100);
    EXPECT_TRUE(last.ended());
    last.wait();  // waits after the Jobs object was destroyed
}

TEST_P(JobsByThreads, AJobsCapturesAreFreedAfterItsRun) {
    Jobs jobs(GetParam());
    auto held = std::make_shared<int>(1);
    const auto ticket = jobs.run([held] { (void)held; });
    ticket.wait();
    EXPECT_EQ(held.use_count(), 1);
}

TEST_P(JobsByThreads, APreparedJobRunsEachTimeItIsSubmitted) {
    Jobs jobs(GetParam());
    int runs = 0;
    const auto ticket = Jobs::prepare([&runs] { ++runs; });
    EXPECT_TRUE(ticket.ended());
    EXPECT_EQ(runs, 0);
    for (int i = 1; i <= 300; ++i) {
        jobs.run(ticket);
        ticket.wait();
        EXPECT_EQ(runs, i);
    }
}

TEST_P(JobsByThreads, ManyMayWaitForOne) {
    Jobs jobs(GetParam());
    const auto ticket = jobs.run([] { std::this_thread::sleep_for(5ms); });
    std::atomic<int> done = 0;
    std::vector<std::jthread> waiters;
    waiters.reserve(8);
    for (int i = 0; i < 8; ++i) {
        waiters.emplace_back([&] {
            ticket.wait();
            if (ticket.ended()) ++done;
        });
    }
    waiters.clear();  // destroys the threads, which waits for them
    EXPECT_EQ(done, 8);
}

INSTANTIATE_TEST_SUITE_P(Core, JobsByThreads, ::testing::Values(0U, 1U, 4U));

TEST(CoreJobs, NoThreadsMeansAtOnceAndHere) {
    Jobs jobs(0);
    std::thread::id where;
    const auto ticket = jobs.run([&where] { where = std::this_thread::get_id(); });
    EXPECT_TRUE(ticket.ended());
    EXPECT_EQ(where, std::this_thread::get_id());
}

TEST(CoreJobs, OneThreadKeepsTheOrder) {
    std::vector<int> order;
    {
        Jobs jobs(1);
        for (int i = 0; i < 300; ++i) jobs.run([&order, i] { order.push_back(i); });
    }
    std::vector<int> expected(300);
    std::iota(expected.begin(), expected.end(), 0);
    EXPECT_EQ(order, expected);
}

TEST(CoreJobs, ThreadsWorkAtTheSameTime) {
    Jobs jobs(2);
    std::latch both(2);
    const auto first = jobs.run([&both] { both.arrive_and_wait(); });
    // Hangs unless both jobs run at the same time.
    const auto second = jobs.run([&both] { both.arrive_and_wait(); });
    first.wait();
    second.wait();
}

TEST(CoreJobs, AnUnfinishedJobIsNotEnded) {
    Jobs jobs(1);
    std::latch go(1);
    const auto ticket = jobs.run([&go] { go.wait(); });
    EXPECT_FALSE(ticket.ended());
    go.count_down();
    ticket.wait();
    EXPECT_TRUE(ticket.ended());
}

TEST(CoreJobs, NoTicketIsAnEndedOne) {
    const Jobs::Ticket none;
    none.wait();
    EXPECT_TRUE(none.ended());
}

}  // namespace
}  // namespace thaum
