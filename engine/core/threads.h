// core/threads.h: starting a thread where the system may refuse one (a limit of processes, no memory for its stack).
#pragma once
#include <system_error>
#include <thread>
#include <utility>

#include "core/error.h"

namespace thaum {

/// Runs `body` in a thread of its own. The error is one line that says why the system allows none.
template <class Body>
Expected<std::thread> start_thread(Body&& body) {
    try {
        return std::thread(std::forward<Body>(body));
    } catch (const std::system_error& refused) {
        return fail(std::string("the system allows no further thread: ") + refused.code().message());
    }
}

}  // namespace thaum
