// input/detail/watchdog.h: runs calls of a vendor's library that may never return. The calls run on a thread
// of their own, and the caller waits only for a limited time. A thread that hangs is abandoned and never
// joined, so the work must own everything that it uses.
#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

namespace thaum::input {

/// Name of the library call in which a thread is at the moment; null between calls.
using CallNote = std::atomic<const char*>;

/// During its lifetime, names the call to the watchdog of this thread, if the thread has one.
class NotedCall {
public:
    explicit NotedCall(const char* name);
    ~NotedCall();
    NotedCall(const NotedCall&) = delete;
    NotedCall& operator=(const NotedCall&) = delete;
};

/// Outcome of watched work. `line` tells the user what to do: it names the call that did not return, or says
/// that no thread could be started.
struct Watched {
    enum class End : std::uint8_t { in_time, hangs, no_thread } end{};
    std::string line{};
};

/// Runs `work` on a thread of its own and waits until it ends, until `enough` is true (null: never), or for
/// limit_ns. The time is counted in slices of 20 ms, which take longer while other programs use the
/// processor. If the work ends after it was given up, `if_late` runs next on the same thread.
Watched run_watched(std::int64_t limit_ns, const std::atomic<bool>* enough, std::function<void()> work,
                    std::function<void()> if_late);

}  // namespace thaum::input
