// game/live/end_watch.h: SIGINT (Ctrl-C), SIGTERM and SIGHUP as requests to end, so that the program can
// close logs and release force-feedback arms. The signal handler ends the forces at once, whatever the
// program does meanwhile. The second signal of a kind ends the process as if there were no watch.
#pragma once
#include <array>
#include <atomic>
#include <csignal>

namespace thaum::game::inline live {

class EndWatch {
public:
    EndWatch();
    ~EndWatch();
    EndWatch(const EndWatch&) = delete;
    EndWatch& operator=(const EndWatch&) = delete;

    /// Flag that is true once a signal has come since the newest watch began. Any thread may read the flag.
    static const std::atomic<bool>& asked();

private:
    static constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};
    std::array<struct sigaction, signals.size()> before_{};
};

/// Prints that a signal has ended the command, if that is so.
void tell_end_by_signal();

}  // namespace thaum::game::inline live
