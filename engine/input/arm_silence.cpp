#include "input/arm_silence.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <ctime>

#include "input/detail/silence.h"

namespace thaum::input {
namespace {

/// The signal that ends the process; for the alarm that ends a handler which hangs in the vendor's library.
volatile std::sig_atomic_t ends_by = 0;

void die(int signal) noexcept {
    std::signal(signal, SIG_DFL);
    ::kill(::getpid(), signal);
}

void hung(int) { die(ends_by); }

/// A fault within the arm's own tick: nobody else can say the last word. The library may hang or fail again; the alarm ends that.
void leave_tick(int signal) noexcept {
    ends_by = signal;
    std::signal(SIGALRM, hung);
    ::alarm(1);
    hd::end_broken_step();
    ::alarm(0);
}

/// exit() may be called anywhere, too.
void on_exit() {
    if (hd::is_in_tick())
        hd::end_broken_step();
    else
        silence_arms_and_wait();
}

/// The handler is reset when it is called (SA_RESETHAND): a second signal, or a fault in here, ends the process at once.
void on_end(int signal) {
    if (hd::is_in_tick())
        leave_tick(signal);
    else
        silence_arms_and_wait();
    ::raise(signal);
}

void on_stop(int) {
    silence_arms_and_wait();
    ::raise(SIGSTOP);
    end_silence();
}

/// Where nobody else has a handler.
void handle(int signal, void (*handler)(int), int flags) {
    struct sigaction before {};
    if (::sigaction(signal, nullptr, &before) != 0 || before.sa_handler != SIG_DFL) return;
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = flags;
    ::sigaction(signal, &action, nullptr);
}

/// A stack that has run over is a fault, too.
void keep_a_stack_for_faults() {
    static std::array<char, 65536> memory;
    stack_t stack{};
    stack_t before{};
    if (::sigaltstack(nullptr, &before) != 0 || (before.ss_flags & SS_DISABLE) == 0) return;
    stack.ss_sp = memory.data();
    stack.ss_size = memory.size();
    ::sigaltstack(&stack, nullptr);
}

}  // namespace

void silence_arms() noexcept { hd::silence_ticks(true); }
void end_silence() noexcept { hd::silence_ticks(false); }

void silence_arms_and_wait() noexcept {
    silence_arms();
    constexpr int looks = 200;
    const timespec between{.tv_sec = 0, .tv_nsec = 1'000'000};
    for (int look = 0; look < looks && !hd::ticks_are_silent(); ++look) ::nanosleep(&between, nullptr);
}

void guard_ends() {
    static std::atomic<bool> guarded{false};
    if (guarded.exchange(true)) return;
    keep_a_stack_for_faults();
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTERM, SIGINT, SIGHUP})
        handle(signal, on_end, static_cast<int>(SA_RESETHAND) | SA_NODEFER | SA_ONSTACK);
    handle(SIGTSTP, on_stop, SA_RESTART);
    std::atexit(on_exit);
}

}  // namespace thaum::input
