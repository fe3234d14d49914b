// The clock of the fake library: its thread, and the tasks that the thread calls.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include "drivers/fake_hd/library.h"

namespace thaum::fake_hd {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto ms = std::chrono::milliseconds(1);

/// Closes a frame that a task has left open, and counts the violation.
void close_frame(Library& l) {
    if (l.script.is("callback", "two_threads")) return;
    for (auto& d : l.devices) {
        if (!d.frame) continue;
        broken(l, fake_hd_unpaired, frame_error);
        d.frame = false;
    }
}

/// Returns whether an asynchronous task is due in this tick, according to the script's option `callback`.
bool comes(Library& l) {
    if (l.script.is("callback", "never")) return false;
    return !l.script.is("callback", "once") || l.calls["once"]++ == 0;
}

void wait_for_next(Library& l, std::uint64_t tick, Clock::time_point& due) {
    const auto late = l.script.number("late");
    if (late != 0 && tick % late == 0) {
        std::this_thread::sleep_for(5 * ms);
        if (!l.script.has("burst")) due = Clock::now();
    }
}

void run_thread(Library& l) {
    l.own_thread = std::this_thread::get_id();
    const auto hz = l.script.number("rate");
    const auto period = hz == 0 ? std::chrono::microseconds(ms) : std::chrono::microseconds(1'000'000 / hz);
    auto due = Clock::now();
    while (l.running) {
        due += period;
        std::uint64_t tick = 0;
        bool asynchronous = false;
        int signal = 0;
        {
            const Lock lock(l.mutex);
            move_arms(l);
            tick = l.report.ticks;
            const bool scheduled =
                std::any_of(l.tasks.begin(), l.tasks.end(), [](auto& t) { return !t.synchronous; });
            auto& first = l.devices[0];
            asynchronous = scheduled && comes(l) && !goes_wrong(first, "stop");
            signal = goes_wrong(first, "crash") ? SIGSEGV : goes_wrong(first, "interrupt") ? SIGTERM : 0;
        }
        if (signal != 0) std::raise(signal);
        wait_for_next(l, tick, due);
        run_tasks(l, !asynchronous);
        if (l.script.is("callback", "twice")) run_tasks(l, !asynchronous);
        std::this_thread::sleep_until(due);
    }
}

/// Calls the program's tick task from a second thread, independently of the library's first one.
void run_second_thread(Library& l) {
    while (l.running) {
        call_ticks(l);
        std::this_thread::sleep_for(ms / 2);
    }
}

}  // namespace

void run_tasks(Library& l, bool synchronous_only) {
    std::vector<Task> due;
    {
        const Lock lock(l.mutex);
        due = l.tasks;
    }
    if (synchronous_only) std::erase_if(due, [](auto& t) { return !t.synchronous; });
    std::stable_sort(due.begin(), due.end(), [](auto& a, auto& b) { return a.priority > b.priority; });
    for (const auto& task : due) {
        const bool done = task.run(task.context) == 0;
        const Lock lock(l.mutex);
        close_frame(l);
        if (done) std::erase_if(l.tasks, [&](const Task& t) { return t.number == task.number; });
    }
}

void call_ticks(Library& l) {
    Task ticks{};
    {
        const Lock lock(l.mutex);
        ticks = l.newest_ticks;
    }
    if (ticks.run != nullptr) ticks.run(ticks.context);
}

void call_after_end(Library& l) {
    std::jthread([&l] {
        constexpr int calls = 200;
        for (int i = 0; i < calls; ++i) {
            call_ticks(l);
            std::this_thread::sleep_for(ms);
            const Lock lock(l.mutex);
            ++l.report.calls_after_end;
        }
    }).detach();
}

void start_threads(Library& l) {
    l.thread = std::jthread([&l] { run_thread(l); });
    if (l.script.is("callback", "two_threads"))
        l.second_thread = std::jthread([&l] { run_second_thread(l); });
}

void stop_threads(Library& l) {
    if (l.thread.joinable()) l.thread.join();
    if (l.second_thread.joinable()) l.second_thread.join();
}

unsigned long schedule(Library& l, Callback run, void* context, unsigned short priority, bool synchronous) {
    const Lock lock(l.mutex);
    const bool any = std::any_of(l.devices.begin(), l.devices.end(), [](auto& d) { return d.initiated; });
    if (!any) broken(l, fake_hd_wrong_order, invalid_operation);
    const auto number = !synchronous && l.script.is("task", "zero") ? 0 : l.next_task++;
    l.tasks.push_back({number, priority, run, context, synchronous});
    if (!synchronous) l.newest_ticks = l.tasks.back();
    return number;
}

}  // namespace thaum::fake_hd
