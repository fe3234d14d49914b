// input/detail/watchdog.h: calls of a vendor's library that may never return. Work that calls it runs on a thread of its own, and
// whoever wants the result waits only so long. A thread that hangs is left behind, never joined, so the work must own all that it uses.
#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

namespace thaum::input {

/// The call of the library in which a thread is at the moment; null between calls.
using CallNote = std::atomic<const char*>;

/// Names the call for the thread's watchdog, if it has one, while the object lives.
class NotedCall {
public:
    explicit NotedCall(const char* name);
    ~NotedCall();
    NotedCall(const NotedCall&) = delete;
    NotedCall& operator=(const NotedCall&) = delete;
};

/// How the work went. The line says what to do: the call that did not return, or that no thread could be made.
struct Watched {
    enum class End : std::uint8_t { in_time, hangs, no_thread } end{};
    std::string line{};
};

/// Runs `work` on a thread of its own and waits for it, but no longer than until `enough` (null: never) is true. It
/// waits limit_ns in slices of 20 ms, which are longer while other programs take the processor. Work that ends after it
/// was given up is followed by `if_late`, on the same thread.
Watched run_watched(std::int64_t limit_ns, const std::atomic<bool>* enough, std::function<void()> work,
                    std::function<void()> if_late);

}  // namespace thaum::input
