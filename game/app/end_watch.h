// game/app/end_watch.h: SIGINT (Ctrl-C), SIGTERM and SIGHUP as a wish to end, so that logs are closed and arms let go of. The forces end at
// once, whatever the program does meanwhile. The second signal of a kind ends the process as if nobody watched.
#pragma once
#include <array>
#include <atomic>
#include <csignal>

namespace thaum::app {

class EndWatch {
public:
    EndWatch();
    ~EndWatch();
    EndWatch(const EndWatch&) = delete;
    EndWatch& operator=(const EndWatch&) = delete;

    /// Whether a signal has come since the newest watch began. Any thread.
    static const std::atomic<bool>& asked();

private:
    static constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};
    std::array<struct sigaction, signals.size()> before_{};
};

}  // namespace thaum::app
