// core/threads.h: starts a thread, or reports why the system refuses one (a process limit, no memory for its
// stack). Also counts the processors.
#pragma once
#include <array>
#include <cstddef>
#include <memory>
#include <system_error>
#include <thread>
#include <utility>

#include "core/error.h"

namespace thaum {

/// Memory in which a signal handler can run (SA_ONSTACK) after the stack of its thread has overflowed. Each
/// thread needs its own.
class FaultStack {
public:
    /// Makes this the signal stack of the calling thread, unless that thread already has one. The memory must
    /// stay until the thread ends or calls end_use.
    void begin_use() noexcept;
    /// Ends the use of this memory as signal stack. Must be called by the thread that called begin_use.
    void end_use() noexcept;

private:
    std::array<std::byte, 65536> memory_;
    bool used_ = false;
};

/// Number of processors on which the calling thread may run, at least 1.
unsigned processors() noexcept;

/// Runs `body` in a new thread that has a FaultStack. The thread's destructor waits until `body` returns. The
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
