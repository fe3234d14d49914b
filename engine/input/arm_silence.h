// input/arm_silence.h: no force when the program ends, however it ends. A device goes on exerting what it was told last, so the
// last word to it must be zero. The arm's own thread says it: it goes on for as long as the process lives, also while another thread
// handles a signal or aborts.
//
// SIGKILL, a power cut and a library that no longer calls us cannot be helped; there only the device's own watchdog acts.
#pragma once

namespace thaum::input {

/// From its next tick on every arm is told to exert nothing, until `end_silence`. Any thread, also in a signal handler.
void silence_arms() noexcept;
void end_silence() noexcept;

/// As silence_arms, and waits until the arm was told so: at most 0.2 s. Any thread, also in a signal handler.
void silence_arms_and_wait() noexcept;

/// From now on the force is zero before the process ends by a fault (SIGSEGV, SIGBUS, SIGFPE, SIGILL), an abort (a failed assertion, an
/// exception that nobody caught), by exit(), or by SIGTERM, SIGINT, SIGHUP where the program has no handler of its own; and while it
/// is stopped (SIGTSTP). The process then ends as it would have without this. Once is enough; another call does nothing.
void guard_ends();

}  // namespace thaum::input
