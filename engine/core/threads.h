// core/threads.h: starts a thread, or reports why the system refuses one (a process limit, no memory for its
// stack).
#pragma once
#include <array>
#include <cstddef>
#include <memory>
#include <system_error>
#include <thread>
#include <utility>

#include "core/error.h"

namespace thaum {

/// Memory in which a signal handler runs (SA_ONSTACK) after the stack of its thread has overflowed. Each thread needs
/// its own.
class FaultStack {
public:
    /// Makes it the calling thread's, unless that thread has one. The memory must outlive the thread or its use.
    void begin_use() noexcept;
    /// Ends the use; call it from the thread that began it.
    void end_use() noexcept;

private:
    std::array<std::byte, 65536> memory_;
    bool used_ = false;
};

/// Runs `body` in a new thread that has a stack for its faults. The thread's destructor waits until `body` returns. The
/// error is one line with the system's reason.
template <class Body>
Expected<std::jthread> start_thread(Body&& body) {
    auto run = [stack = std::make_unique_for_overwrite<FaultStack>(),
                body = std::forward<Body>(body)]() mutable {
        stack->begin_use();
        body();
        stack->end_use();
    };
    try {
        return std::jthread(std::move(run));
    } catch (const std::system_error& refused) {
        return fail(std::string("the system allows no further thread: ") + refused.code().message());
    }
}

}  // namespace thaum
