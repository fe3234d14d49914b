// input/arm_silence.h: no force when the program ends, however it ends. A device goes on exerting what it was told last, so the
// last word to it must be zero. The arm's own thread says it: it goes on for as long as the process lives, also while another thread
// handles a signal or aborts.
//
// There is no help against SIGKILL, a power cut, a library that no longer calls us or takes no zero, and a stack that runs
// over in a thread which start_thread has not started. There only the device's own watchdog acts.
#pragma once

namespace thaum::input {

/// From its next tick on every arm is told to exert nothing, until `end_silence`. Any thread, also in a signal handler.
void silence_arms() noexcept;
void end_silence() noexcept;

/// As silence_arms, and waits until the arm was told so: at most 0.2 s. Any thread, also in a signal handler.
void silence_arms_and_wait() noexcept;

/// From now on the force is zero before the process ends by exit() or by a signal that ends it: a fault, an abort (a failed
/// assertion, an exception that nobody caught), a wish to end (SIGTERM, SIGINT, SIGQUIT, SIGHUP), a broken pipe, a limit. It
/// is zero as well while the process is stopped (SIGTSTP, SIGTTIN, SIGTTOU). The process then ends or stops as it would have
/// without this. Signals that somebody ignores or handles stay theirs, and so do real-time signals, which libraries take for
/// themselves. Once is enough; another call does nothing.
void guard_ends();

}  // namespace thaum::input
