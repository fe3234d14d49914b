#include "input/arm_silence.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <ctime>

#include "core/threads.h"
#include "input/detail/silence.h"

namespace thaum::input {
namespace {

/// Signal that ends the process. The handler of SIGALRM sends it if, a second after the alarm was set,
/// another handler still hangs in the vendor's library.
volatile std::sig_atomic_t ends_by = 0;
/// Whether this thread is already in on_end, the handler of the signals that end the process.
thread_local volatile std::sig_atomic_t ends_here = 0;

void hung(int) {
    std::signal(ends_by, SIG_DFL);
    ::kill(::getpid(), ends_by);
}

void wait_for_silence() noexcept {
    constexpr int looks = 200;
    const timespec between{.tv_sec = 0, .tv_nsec = 1'000'000};
    for (int look = 0; look < looks && !ticks::are_silent(); ++look) ::nanosleep(&between, nullptr);
}

/// Ends all forces after a fault of an arm's own servo thread. No other thread can end the force of that arm;
/// the other arms end theirs in their own threads. If the driver hangs or fails again, the alarm (SIGALRM)
/// ends the process after a second.
void end_as_arms_thread(int signal) noexcept {
    ends_by = signal;
    std::signal(SIGALRM, hung);
    ::alarm(1);
    silence_arms();
    ticks::end_broken();
    wait_for_silence();
    ::alarm(0);
}

/// Whether the thread cannot go on after this signal: when the handler returned, the same instruction would
/// fail again, or abort() would end the process.
bool is_fault(int signal) {
    switch (signal) {
        case SIGSEGV:
        case SIGBUS:
        case SIGFPE:
        case SIGILL:
        case SIGTRAP:
        case SIGSYS:
        case SIGABRT: return true;
        default: return false;
    }
}

/// Passes a signal on to another thread and blocks it in this one, because the arm's thread must keep ticking
/// to send the final zero force.
void hand_on(int signal, void* context) {
    sigset_t one;
    ::sigemptyset(&one);
    ::sigaddset(&one, signal);
    ::pthread_sigmask(SIG_BLOCK, &one, nullptr);
    ::sigaddset(&static_cast<ucontext_t*>(context)->uc_sigmask,
                signal);  // so that it stays blocked when the handler returns
    ::kill(::getpid(), signal);
}

/// Ends all forces when exit() is called, which an arm's servo thread may do as well as any other.
void on_exit() {
    if (ticks::is_arms_thread()) ticks::end_broken();
    silence_arms_and_wait();
}

/// Handler of the signals that end the process. Other threads may be in this handler at the same time; each
/// waits until the arms are silent. Only a fault within the handler ends the process at once.
void on_end(int signal, siginfo_t*, void* context) {
    const bool arms = ticks::is_arms_thread(), nested = ends_here != 0;
    if (!is_fault(signal)) {
        if (arms) return hand_on(signal, context);
        if (nested) return;  // the outer call of this handler ends the process
    }
    ends_here = 1;
    if (!nested && arms) end_as_arms_thread(signal);
    if (!nested && !arms) silence_arms_and_wait();
    std::signal(signal, SIG_DFL);
    ::raise(signal);
}

void on_stop(int signal, siginfo_t*, void* context) {
    if (ticks::is_arms_thread()) return hand_on(signal, context);
    const int error = errno;
    ticks::begin_stop();
    wait_for_silence();
    ::raise(SIGSTOP);
    ticks::end_stop();
    errno = error;
}

/// Sets the handler of a signal unless the program already has one for it.
void handle(int signal, void (*handler)(int, siginfo_t*, void*), int flags) {
    struct sigaction before {};
    if (::sigaction(signal, nullptr, &before) != 0 || before.sa_handler != SIG_DFL) return;
    struct sigaction action {};
    action.sa_sigaction = handler;
    action.sa_flags = SA_SIGINFO | flags;
    ::sigaction(signal, &action, nullptr);
}

}  // namespace

void silence_arms() noexcept { ticks::silence(true); }
void end_silence() noexcept { ticks::silence(false); }

void silence_arms_and_wait() noexcept {
    silence_arms();
    wait_for_silence();
}

void guard_ends() {
    static std::atomic<bool> guarded{false};
    if (guarded.exchange(true)) return;
    static FaultStack stack;
    stack.begin_use();
    for (const int signal :
         {SIGHUP,  SIGINT,  SIGQUIT, SIGILL,  SIGTRAP, SIGABRT,   SIGBUS,  SIGFPE, SIGUSR1, SIGSEGV, SIGUSR2,
          SIGPIPE, SIGALRM, SIGTERM, SIGXCPU, SIGXFSZ, SIGVTALRM, SIGPROF, SIGIO,  SIGPWR,  SIGSYS})
        handle(signal, on_end, SA_NODEFER | SA_ONSTACK);
    for (const int signal : {SIGTSTP, SIGTTIN, SIGTTOU}) handle(signal, on_stop, SA_RESTART);
    std::atexit(on_exit);
    std::at_quick_exit(on_exit);
}

}  // namespace thaum::input
