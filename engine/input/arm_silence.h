// input/arm_silence.h: removes the arm's force when the program ends in any way. A device keeps exerting its
// last command, so the last command must be zero. The arm's own thread sends it. That thread runs as long as
// the process lives, also while another thread handles a signal or aborts.
//
// While a library hangs or stops calling, the engine's watchdog ends the force (detail/stall_watch.h). Only
// the device's own watchdog (input/arm_driver.h) helps in these cases: SIGKILL, SIGSTOP, a power cut, a
// library that rejects the zero, or a stack overflow in a thread that start_thread did not start.
#pragma once

namespace thaum::input {

/// Makes every arm exert no force from its next tick on, until `end_silence`. Any thread may call it, also in
/// a signal handler.
void silence_arms() noexcept;
/// Lets arms give forces again after `silence_arms`.
void end_silence() noexcept;

/// Calls silence_arms and waits, at most 0.2 s, until the zero force has been sent. Any thread may call it,
/// also in a signal handler.
void silence_arms_and_wait() noexcept;

/// Makes the force zero before the process ends by exit(), by quick_exit() or by a signal. That covers
/// faults, aborts (a failed assertion, an uncaught exception), requests to end (SIGTERM, SIGINT, SIGQUIT,
/// SIGHUP), a broken pipe and an exceeded limit (SIGXCPU, SIGXFSZ). The force is also zero while the process
/// is stopped (SIGTSTP, SIGTTIN, SIGTTOU). The process then ends or stops as it would have done otherwise.
/// Signals that are ignored or handled elsewhere stay unchanged, and so do real-time signals, which libraries
/// use. A second call does nothing.
void guard_ends();

}  // namespace thaum::input
